"""Each law of tree words and of their code, on parts with a fault."""

from collections.abc import Callable
from dataclasses import replace

import pytest

from clers.arithmetic.bits import Bits, pack
from clers.codes import enumerative, laws_enumerative, laws_trees
from clers.codes.closure import sphere_of
from clers.codes.code import Code, Guarantee, Shape
from clers.codes.half_edges import HalfEdges
from clers.codes.laws_trees import Trees
from clers.codes.orientation import orientation
from clers.codes.tree_word import tree_word
from clers.complexes.corner_table import face_list, surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds
from clers.edgebreaker.decode import decode
from clers.edgebreaker.examples import ANNULUS, TETRAHEDRON, TORUS
from clers.edgebreaker.stream import Stream
from clers.generate.uniform import uniform_sphere

REFUSED = Rejected(Reason.NOT_CANONICAL, Clause.CODE_TREE_6)
SPHERE = uniform_sphere(12, 1)
WORD = tree_word(SPHERE)


def octahedron() -> Surface:
    """The sphere with a cycle that can run both ways, about its last face."""
    faces = (
        (0, 1, 2), (0, 2, 4), (2, 1, 3), (1, 0, 5), (2, 3, 4), (1, 5, 3), (0, 4, 5), (3, 5, 4),
    )  # fmt: skip
    made = surface(FaceList(faces, 6))
    assert isinstance(made, Accepted)
    return made.value


def cycle_turned(edges: HalfEdges) -> bytearray:
    """The orientation with the last face's edges turned over."""
    out = orientation(edges)
    for h in range(len(out) - 3, len(out)):
        out[h], out[edges.twin[h]] = out[edges.twin[h]], out[h]
    return out


def root_moved(word: bytes) -> Accepted[Surface] | Rejected:
    """The right sphere from the wrong root."""
    found = sphere_of(word)
    if isinstance(found, Rejected):
        return found
    listed = face_list(found.value)
    return surface(FaceList((*listed.faces[1:], listed.faces[0]), listed.vertices))


def undirected(edges: HalfEdges) -> bytearray:
    return bytearray(len(edges.twin))


FAULTS: list[tuple[str, Trees, object]] = [
    ("orientation-three-out", replace(laws_trees.REFERENCE, orientation=undirected), SPHERE),
    (
        "orientation-three-out",
        replace(laws_trees.REFERENCE, orientation=cycle_turned),
        octahedron(),
    ),
    ("tree-word-shape", replace(laws_trees.REFERENCE, tree_word=lambda _: WORD[1:]), SPHERE),
    ("tree-word-shape", replace(laws_trees.REFERENCE, tree_word=lambda _: WORD[::-1]), SPHERE),
    ("tree-word-decodes", replace(laws_trees.REFERENCE, sphere_of=root_moved), SPHERE),
    ("tree-word-decodes", replace(laws_trees.REFERENCE, sphere_of=lambda _: REFUSED), SPHERE),
    ("tree-word-unique", replace(laws_trees.REFERENCE, tree_word=lambda _: b"\1\0\0\0"), WORD),
    (
        "tree-word-unique",
        replace(
            laws_trees.REFERENCE,
            sphere_of=lambda _: Rejected(Reason.TRAILING_BITS, Clause.CODE_TREE_6),
        ),
        WORD,
    ),
    ("closure-as-defined", replace(laws_trees.REFERENCE, sphere_of=root_moved), WORD),
    ("closure-as-defined", replace(laws_trees.REFERENCE, sphere_of=lambda _: REFUSED), WORD),
    (
        "closure-as-defined",
        replace(laws_trees.REFERENCE, sphere_of=lambda _: Accepted(TETRAHEDRON)),
        b"\1\1\0\0\0\0\0\0",
    ),
]


@pytest.mark.parametrize(("name", "subject", "example"), FAULTS)
def test_a_fault_in_trees_is_found(name: str, subject: Trees, example: object) -> None:
    (law,) = [law for law in laws_trees.laws_of(subject) if law.name == name]
    assert isinstance(law.check(example), Fails)
    (sound,) = [law for law in laws_trees.LAWS if law.name == name]
    assert sound.check(example) == Holds()


def anything(symbols: str, shape: Shape) -> Accepted[Bits] | Rejected:
    del symbols, shape
    return Accepted(pack([0, 1]))


def nothing(symbols: str, shape: Shape) -> Accepted[Bits] | Rejected:
    del symbols, shape
    return REFUSED


def grammar_only(symbols: str, shape: Shape) -> Accepted[Bits] | Rejected:
    """Refuses for another reason."""
    stream = Stream("X" + symbols, (), len(shape.closings))
    found = decode(stream)
    return found if isinstance(found, Rejected) else REFUSED


def lenient(bits: Bits, count: int, shape: Shape) -> Accepted[str] | Rejected:
    """Reads over what follows the message."""
    longest = range(bits.length, -1, -1)
    values = bits.values()
    results = (enumerative.decode(pack(values[:n]), count, shape) for n in longest)
    return next((found for found in results if isinstance(found, Accepted)), REFUSED)


def with_bound(bits: Callable[[int], int]) -> Guarantee:
    return Guarantee("", lambda parts: bits(sum(part.faces for part in parts)))


CODE = enumerative.CODE
BROKEN: list[tuple[str, Code, Surface]] = [
    ("enumerative-decodes", replace(CODE, encode=anything), SPHERE),
    ("enumerative-decodes", replace(CODE, encode=nothing), SPHERE),
    ("enumerative-decodes", replace(CODE, most_symbols=lambda n: n // 4), SPHERE),
    ("enumerative-other-bits", replace(CODE, decode=lenient), SPHERE),
    ("enumerative-other-bits", replace(CODE, encode=nothing), SPHERE),
    ("enumerative-length", replace(CODE, guarantee=with_bound(lambda t: t)), SPHERE),
    ("enumerative-length", replace(CODE, encode=nothing), SPHERE),
    ("enumerative-spheres-only", replace(CODE, encode=anything), TORUS),
    ("enumerative-spheres-only", replace(CODE, encode=grammar_only), TORUS),
    ("enumerative-spheres-only", replace(CODE, guarantee=with_bound(lambda t: t)), ANNULUS),
]


@pytest.mark.parametrize(("name", "code", "example"), BROKEN)
def test_a_fault_in_the_code_is_found(name: str, code: Code, example: Surface) -> None:
    (law,) = [law for law in laws_enumerative.laws_of(code) if law.name == name]
    assert isinstance(law.check(example), Fails)
    (sound,) = [law for law in laws_enumerative.LAWS if law.name == name]
    assert sound.check(example) == Holds()
