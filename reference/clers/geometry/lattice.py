"""Quantised positions: the nearest points of a lattice whose step is a power of two.

A power of two makes every step of the arithmetic exact, so that all implementations find the same
integers, and the error bound has no term for rounding.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import floor, frexp, ldexp
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtVertex
from clers.geometry.positions import Positions, narrowest

LOWEST_EXPONENT: Final = -1074
HIGHEST_EXPONENT: Final = 971
LARGEST_NUMBER: Final = (1 << 53) - 1
"""Lattice numbers are integers that binary64 holds exactly, up to sign. Clause: GEOM-LATTICE-1."""


@dataclass(frozen=True, slots=True)
class Quantised:
    """Points of the lattice of step 2^exponent: 3V integers, flat. Clause: GEOM-LATTICE-1."""

    exponent: int
    numbers: tuple[int, ...]


def quantise(given: Positions, exponent: int) -> Accepted[Quantised] | Rejected:
    """The nearest lattice point of each position, half a step away at most.

    Clauses: GEOM-LATTICE-1 … GEOM-LATTICE-3, GEOM-LATTICE-6, GEOM-LATTICE-7.
    """
    if not LOWEST_EXPONENT <= exponent <= HIGHEST_EXPONENT:
        detail = f"exponent {exponent}"
        return Rejected(Reason.BAD_LATTICE, Clause.GEOM_LATTICE_1, detail=detail)
    flat = given.coordinates
    if flat and not (fits(min(flat), exponent) and fits(max(flat), exponent)):
        i = next(i for i, x in enumerate(flat) if not fits(x, exponent))
        where, detail = AtVertex(i // 3), f"{'xyz'[i % 3]} = {flat[i]!r}, the step is 2^{exponent}"
        return Rejected(Reason.NOT_REPRESENTABLE, Clause.GEOM_LATTICE_3, where, detail)
    return Accepted(Quantised(exponent, tuple(nearest(x, exponent) for x in flat)))


def restore(given: Quantised) -> Positions:
    """The lattice points as positions. Exact. Clause: GEOM-LATTICE-4."""
    exponent = given.exponent
    places = tuple(ldexp(float(k), exponent) for k in given.numbers)
    return Positions(narrowest(places), places)


def nearest(x: float, exponent: int) -> int:
    """⌊x / 2^exponent + 1/2⌋ in three operations on doubles. Clauses: GEOM-LATTICE-2, -5.

    Only for x that `fits`. Exact: see the proof under GEOM-LATTICE-5.
    """
    y = ldexp(x, -exponent)
    k = floor(y)
    return k + 1 if y - k >= 0.5 else k


def fits(x: float, exponent: int) -> bool:
    """Whether the nearest lattice number is less than 2^53 in magnitude. Clause: GEOM-LATTICE-3."""
    _, size = frexp(x)  # 2^(size−1) ≤ |x| < 2^size
    # From 2^52 on doubles are integers, so that no rounding leads up to 2^53.
    return x == 0.0 or size - exponent <= 53


def exponent_for_bits(given: Positions, bits: int) -> Accepted[int] | Rejected:
    """The least exponent with at most 2^bits − 1 steps on each axis. Clause: GEOM-CHOICE-1."""
    if not 1 <= bits <= 30:
        return Rejected(Reason.BAD_LATTICE, Clause.GEOM_CHOICE_1, detail=f"{bits} bits")
    ends = [
        (min(axis, default=0.0), max(axis, default=0.0))
        for axis in (given.coordinates[i::3] for i in range(3))
    ]
    for exponent in range(LOWEST_EXPONENT, HIGHEST_EXPONENT + 1):
        if _spans(ends, exponent, (1 << bits) - 1):
            return Accepted(exponent)
    detail = f"the coordinates span more than 2^{bits} steps of 2^{HIGHEST_EXPONENT}"
    return Rejected(Reason.BAD_LATTICE, Clause.GEOM_CHOICE_1, detail=detail)


def exponent_for_error(bound: float) -> Accepted[int] | Rejected:
    """The largest exponent whose error bound is at most `bound`. Clause: GEOM-CHOICE-2."""
    if not 0.0 < bound < float("inf"):
        return Rejected(Reason.BAD_LATTICE, Clause.GEOM_CHOICE_2, detail=f"error bound {bound!r}")
    _, size = frexp(bound)  # 2^(size−1) ≤ bound < 2^size
    return Accepted(min(HIGHEST_EXPONENT, size))


def _spans(ends: Sequence[tuple[float, float]], exponent: int, steps: int) -> bool:
    return all(
        fits(low, exponent)
        and fits(high, exponent)
        and nearest(high, exponent) - nearest(low, exponent) <= steps
        for low, high in ends
    )
