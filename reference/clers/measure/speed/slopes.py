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
from clers.measure.speed.contender import Contender, Way, listed
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


@dataclass(frozen=True, slots=True)
class Slope:
    """How one way of one code grows on one family. Clause: TOOL-SPEED-5.

    `slope` is that of the logarithm of time over that of the number of triangles: 1, if linear.
    `ratio` is time per triangle at the greatest size divided by that at the least.
    """

    family: str
    name: str
    way: Way
    faces: tuple[int, ...]
    seconds_per_triangle: tuple[float, ...]
    slope: float
    ratio: float


def slopes(
    sizes: Sequence[int],
    contenders: Sequence[Contender],
    rounds: int,
    step: Callable[[str], None],
) -> tuple[Slope, ...]:
    """All families at all sizes. Clause: TOOL-SPEED-5."""
    found: list[Slope] = []
    for family, make in FAMILIES.items():
        points: dict[tuple[str, Way], list[tuple[int, float]]] = {}
        for size in sizes:
            each = listed(f"{family}, {size}", make(size))
            faces = each.indices.faces
            for rate in rates(sampled(each, contenders, rounds, step), faces):
                points.setdefault((rate.name, rate.way), []).append((faces, rate.cpu.least))
            del each
        found += [slope(family, name, way, of) for (name, way), of in points.items()]
    return tuple(found)


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
    )
