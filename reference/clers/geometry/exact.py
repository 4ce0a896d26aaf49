"""Exact positions: every bit of every coordinate, little-endian."""

from struct import Struct

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.geometry.positions import Positions, Precision, positions


def width(precision: Precision) -> int:
    """Bytes of one coordinate: 4 or 8. Clause: GEOM-EXACT-1."""
    return 4 if precision is Precision.F32 else 8


def encode(given: Positions) -> bytes:
    """The coordinates as IEEE 754 numbers, lowest byte first. Clause: GEOM-EXACT-1."""
    return _struct(given.precision, len(given.coordinates)).pack(*given.coordinates)


def decode(precision: Precision, data: bytes, vertices: int) -> Accepted[Positions] | Rejected:
    """The positions that `encode` wrote. Clauses: GEOM-EXACT-2, GEOM-POSITION-3."""
    if len(data) != 3 * vertices * width(precision):
        detail = f"{len(data)} bytes for {vertices} vertices of {precision}"
        return Rejected(Reason.COUNT_MISMATCH, Clause.GEOM_EXACT_2, detail=detail)
    return positions(precision, _struct(precision, 3 * vertices).unpack(data), vertices)


def _struct(precision: Precision, count: int) -> Struct:
    return Struct(f"<{count}{'f' if precision is Precision.F32 else 'd'}")
