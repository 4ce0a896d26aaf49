"""How many lines the kernels execute for each triangle: a guard of speed that needs no clock.

After a change that is meant, print the numbers anew: `CLERS_KERNELS=interpreted python
tests/kernels/test_steps.py`.
"""

import sys
from collections.abc import Callable, Mapping
from functools import cache
from typing import Final, TypeVar

import pytest

from clers import kernels
from clers.codes import registry
from clers.codes.closings import closings, records
from clers.codes.registry import CodeName
from clers.complexes.corner_table import face_list, surface
from clers.complexes.face_list import FaceList
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.stream import Encoding
from clers.generate.families import shuffled, torus_chain, with_holes
from clers.generate.uniform import uniform_sphere
from clers.geometry.order import in_creation_order
from counted import lines_by_file

pytestmark = pytest.mark.interpreted

TOLERANCE: Final = 0.02 if sys.version_info[:2] == (3, 11) else 0.1
"""Of the pinned numbers. Later interpreters do not count all lines alike. TOOL-BUILD-7."""

T = TypeVar("T")

Family = Callable[[int], FaceList]


def sphere(size: int) -> FaceList:
    """A random sphere: fans of any length, and its word has all symbols."""
    return face_list(uniform_sphere(250 * size + 2, 1))


def handles(size: int) -> FaceList:
    """A chain of tori with holes, its faces in random order: handle data of both kinds."""
    return shuffled(with_holes(torus_chain(4 * size, 8, 9), 8 * size), 1)


PINNED: Final[Mapping[str, Mapping[str, float]]] = {
    "sphere": {
        "automaton": 29.38,
        "foretelling": 368.82,
        "gluing": 67.65,
        "interval": 190.87,
        "loops": 75.21,
        "naming": 56.08,
        "order": 24.52,
        "scan": 18.71,
        "table": 315.18,
        "tree": 142.86,
        "urn": 29.89,
        "walk": 61.28,
    },
    "handles": {
        "automaton": 30.4,
        "closing": 45.49,
        "foretelling": 354.21,
        "gluing": 34.46,
        "interval": 95.04,
        "loops": 75.0,
        "naming": 28.22,
        "order": 24.49,
        "scan": 19.38,
        "table": 157.42,
        "walk": 33.35,
    },
}
"""Lines for each triangle, by family and kernel, at size 2. Clause: TOOL-BUILD-7."""

FAMILIES: Final[Mapping[str, Family]] = {"sphere": sphere, "handles": handles}


@cache
def steps(family: str, size: int) -> Mapping[str, float]:
    """Lines for each triangle of all that the kernels do: there and back, by each of their codes.

    `flat` makes arrays, in one line each, however long they are.
    """
    mesh = FAMILIES[family](size)
    names = [CodeName.GOLDEN, CodeName.CONTEXT]
    if family == "sphere":
        names.append(CodeName.ENUMERATIVE)

    def work() -> None:
        of = taken(surface(mesh))
        encoding = encode(of)
        in_creation_order(of, encoding)
        taken(decode(encoding.stream))
        for name in names:
            there_and_back(name, encoding)

    counted = lines_by_file(work, "clers/kernels/")
    return {
        kernel: count / len(mesh.faces) for kernel, count in counted.items() if kernel != "flat"
    }


def there_and_back(name: CodeName, encoding: Encoding) -> None:
    stream = encoding.stream
    bits, seen = taken(registry.encode(name, stream)), taken(closings(stream))
    back = registry.decode(name, bits, len(stream.word), stream.components_with_boundary, seen)
    assert taken(back) == stream.word
    assert taken(records(stream.word, seen)) == stream.records


def taken(result: Accepted[T] | Rejected) -> T:
    assert isinstance(result, Accepted)
    return result.value


@pytest.mark.parametrize("family", FAMILIES)
def test_steps_are_as_pinned(family: str) -> None:
    """Clause: TOOL-BUILD-7."""
    assert steps(family, 2) == pytest.approx(dict(PINNED[family]), rel=TOLERANCE)


@pytest.mark.parametrize("family", FAMILIES)
def test_steps_stay_from_a_mesh_to_twice_the_mesh(family: str) -> None:
    """Clause: TOOL-BUILD-7."""
    assert steps(family, 4) == pytest.approx(dict(steps(family, 2)), rel=0.04)


def test_all_kernels_are_counted() -> None:
    """TOOL-BUILD-7: but for `flat`, which makes an array in one line."""
    sources = {path.stem for path in kernels.HERE.glob("*.py")} - {"__init__", "flat"}
    sphere, handles = PINNED["sphere"].keys(), PINNED["handles"].keys()
    assert sources == sphere | {"closing"} == handles | {"tree", "urn"}


if __name__ == "__main__":
    for name in FAMILIES:
        rounded = {kernel: round(count, 2) for kernel, count in sorted(steps(name, 2).items())}
        sys.stdout.write(f"{name}: {rounded}\n")
