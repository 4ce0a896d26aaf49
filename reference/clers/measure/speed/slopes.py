"""How time grows with the number of triangles, for ordinary meshes and for the worst."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import log
from statistics import linear_regression
from typing import Final

from clers.complexes.index_list import IndexList
from clers.generate.flat_families import (
    bipyramid,
    copies,
    grid_sphere,
    nested_splits,
    shuffled,
    sphere_of,
    torus_chain,
    with_holes,
)
from clers.generate.irregular import flat_irregular_sphere
from clers.measure.speed.contender import Contender, Given, Way, listed
from clers.measure.speed.rates import rates, sampled

SEED: Final = 2007
LEAST: Final = 100
"""Every family has a mesh of about so many faces."""


def _irregular(faces: int) -> IndexList:
    return flat_irregular_sphere(faces - faces % 2, SEED)


FAMILIES: Final[Mapping[str, Callable[[int], IndexList]]] = {
    "irregular sphere": _irregular,
    "irregular, shuffled": lambda faces: shuffled(_irregular(faces), SEED),
    "nested S": lambda faces: nested_splits(faces // 4),
    "one run of C": lambda faces: bipyramid(faces // 2),
    "handles": lambda faces: torus_chain(max(faces // 102, 1), 7, 7),
    "components": lambda faces: copies(grid_sphere(1), faces // 8),
    "curves": lambda faces: with_holes(sphere_of(faces), faces // 100),
}
"""Meshes of about so many faces, made in linear time. Clause: TOOL-SPEED-5."""


SMALLEST: Final = 10_000
"""Time per triangle is compared from this size on. Clause: TOOL-SPEED-5."""


def sizes(faces: int) -> tuple[int, ...]:
    """The powers of ten from 10,000 on below the greatest size, and this; two at least.

    Clause: TOOL-SPEED-5.
    """
    found = [SMALLEST]
    while 10 * found[-1] < faces:
        found.append(10 * found[-1])
    below = found if faces > SMALLEST else [faces // 10]
    return tuple(max(size, LEAST) for size in (*below, faces))


def rounds_at(size: int, greatest: int, rounds: int) -> int:
    """Meshes that take no time are coded ten times as often. Clause: TOOL-SPEED-5."""
    return 10 * rounds if 10 * size <= greatest else rounds


@dataclass(frozen=True, slots=True)
class Slope:
    """How one way of one code grows on one family. Clause: TOOL-SPEED-5.

    `slope` is that of the logarithm of time over that of the number of triangles: 1, if linear.
    `ratio` is time per triangle at the greatest size divided by that at the least, `worst` the
    greatest such quotient of any size and a smaller one.
    """

    family: str
    name: str
    way: Way
    faces: tuple[int, ...]
    seconds_per_triangle: tuple[float, ...]
    slope: float
    ratio: float
    worst: float


def slopes(
    sizes: Sequence[int],
    contenders: Sequence[Contender],
    rounds: int,
    step: Callable[[str], None],
) -> tuple[Slope, ...]:
    """All families at all sizes, one mesh at a time. Clause: TOOL-SPEED-5."""
    found: list[Slope] = []
    for family, make in FAMILIES.items():
        points: dict[tuple[str, Way], list[tuple[int, float]]] = {}
        for size in sizes:
            for key, point in _points(
                listed(f"{family}, {size}", make(size)),
                contenders,
                rounds_at(size, sizes[-1], rounds),
                step,
            ):
                points.setdefault(key, []).append(point)
        found += [slope(family, name, way, of) for (name, way), of in points.items()]
    return tuple(found)


def _points(
    of: Given, contenders: Sequence[Contender], rounds: int, step: Callable[[str], None]
) -> list[tuple[tuple[str, Way], tuple[int, float]]]:
    """Of each code and way the faces of a mesh and the least of its seconds."""
    faces = of.indices.faces
    samples = sampled(of, contenders, rounds, step)
    return [((rate.name, rate.way), (faces, rate.cpu.least)) for rate in rates(samples, faces)]


def slope(family: str, name: str, way: Way, points: Sequence[tuple[int, float]]) -> Slope:
    """The slope through two points or more of faces and seconds. Clause: TOOL-SPEED-5."""
    across = [log(faces) for faces, _ in points]
    upward = [log(seconds) for _, seconds in points]
    each = tuple(seconds / faces for faces, seconds in points)
    return Slope(
        family,
        name,
        way,
        tuple(faces for faces, _ in points),
        each,
        linear_regression(across, upward).slope,
        each[-1] / each[0],
        max(later / min(each[:k]) for k, later in enumerate(each) if k > 0),
    )
