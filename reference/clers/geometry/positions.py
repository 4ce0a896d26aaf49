"""Positions of vertices: three coordinates each, with the precision they were given in."""

from array import array
from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from math import isfinite

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtVertex, Whole

Point = tuple[float, float, float]


class Precision(StrEnum):
    """The IEEE 754 format that every coordinate is a value of. Clause: GEOM-POSITION-1."""

    F32 = "f32"
    F64 = "f64"


@dataclass(frozen=True, slots=True)
class Positions:
    """The places of vertices 0 … V−1, flat: x₀, y₀, z₀, x₁, … Clause: GEOM-POSITION-1.

    Built by `positions`, which checks it. Equality is of numbers, so −0.0 equals 0.0; to compare
    bits, compare `exact.encode`.
    """

    precision: Precision
    coordinates: tuple[float, ...]

    @property
    def vertices(self) -> int:
        """V, the number of vertices."""
        return len(self.coordinates) // 3

    def point(self, vertex: int) -> Point:
        """The coordinates of one vertex."""
        x, y, z = self.coordinates[3 * vertex : 3 * vertex + 3]
        return x, y, z


def positions(
    precision: Precision, coordinates: Sequence[float], vertices: int
) -> Accepted[Positions] | Rejected:
    """Positions for that many vertices, or the first fault.

    Clauses: GEOM-POSITION-2, GEOM-POSITION-3, GEOM-POSITION-4.
    """
    if len(coordinates) != 3 * vertices:
        detail = f"{len(coordinates)} coordinates for {vertices} vertices"
        return Rejected(Reason.COUNT_MISMATCH, Clause.GEOM_POSITION_2, Whole(), detail)
    values = tuple(map(float, coordinates))
    if not all(map(isfinite, values)):
        i = next(i for i, x in enumerate(values) if not isfinite(x))
        where, detail = AtVertex(i // 3), f"{'xyz'[i % 3]} is {values[i]}"
        return Rejected(Reason.NON_FINITE_COORDINATE, Clause.GEOM_POSITION_3, where, detail)
    if precision is Precision.F32:
        single = tuple(array("f", values))
        if single != values:
            i = next(i for i, x in enumerate(values) if single[i] != x)
            where, detail = AtVertex(i // 3), f"{'xyz'[i % 3]} = {values[i]!r} is no binary32"
            return Rejected(Reason.NOT_REPRESENTABLE, Clause.GEOM_POSITION_4, where, detail)
    return Accepted(Positions(precision, values))


def narrowest(coordinates: Sequence[float]) -> Precision:
    """F32 if each coordinate is a binary32 value, otherwise F64. Clause: GEOM-POSITION-5."""
    same = tuple(array("f", coordinates)) == tuple(coordinates)
    return Precision.F32 if same else Precision.F64
