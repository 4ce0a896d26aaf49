"""The box of lattice points: where they begin on each axis, and how far they reach."""

from dataclasses import dataclass
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.geometry.lattice import Quantised

LARGEST_EXTENT: Final = (1 << 30) - 1
"""So that every sum of a prediction and every residual fits in 32 bits. Clause: GEOM-BOX-2."""

Triple = tuple[int, int, int]


@dataclass(frozen=True, slots=True)
class Box:
    """The least lattice number of each axis, and greatest minus least. Clause: GEOM-BOX-1."""

    low: Triple
    extent: Triple


@dataclass(frozen=True, slots=True)
class Boxed:
    """Lattice points counted from the low corner of their box. Clause: GEOM-BOX-1.

    `indices` are flat, 3V, and between 0 and the extent of their axis.
    """

    exponent: int
    box: Box
    indices: tuple[int, ...]


def boxed(given: Quantised) -> Accepted[Boxed] | Rejected:
    """The points in their box, if it is small enough. Clauses: GEOM-BOX-1, GEOM-BOX-2."""
    x, y, z = (given.numbers[i::3] for i in range(3))
    low = min(x, default=0), min(y, default=0), min(z, default=0)
    high = max(x, default=0), max(y, default=0), max(z, default=0)
    extent = high[0] - low[0], high[1] - low[1], high[2] - low[2]
    if max(extent) > LARGEST_EXTENT:
        detail = f"{max(extent)} steps on an axis"
        return Rejected(Reason.BAD_LATTICE, Clause.GEOM_BOX_2, detail=detail)
    indices = tuple(k - low[i % 3] for i, k in enumerate(given.numbers))
    return Accepted(Boxed(given.exponent, Box(low, extent), indices))


def unboxed(given: Boxed) -> Quantised:
    """The points as lattice numbers again. Clause: GEOM-BOX-1."""
    low = given.box.low
    numbers = tuple(q + low[i % 3] for i, q in enumerate(given.indices))
    return Quantised(given.exponent, numbers)
