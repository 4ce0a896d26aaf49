"""Laws of the lattice: every one is checked over fractions, where nothing is rounded."""

from fractions import Fraction
from math import copysign, floor, ldexp
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, at_most, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import AtVertex
from clers.geometry.box import boxed, unboxed
from clers.geometry.given import ASKED, LATTICE_MESHES, ON_AXIS, Asked, LatticeMesh, OnAxis
from clers.geometry.lattice import (
    HIGHEST_EXPONENT,
    LARGEST_NUMBER,
    LOWEST_EXPONENT,
    exponent_for_bits,
    exponent_for_error,
    fits,
    nearest,
    quantise,
    restore,
)
from clers.geometry.positions import Positions, Precision, narrowest


def number_by_definition(x: float, exponent: int) -> int:
    """GEOM-LATTICE-2 word for word."""
    return floor(Fraction(x) / Fraction(2) ** exponent + Fraction(1, 2))


def nearest_is_exact(at: OnAxis) -> Verdict:
    """Three operations on doubles find the number of the definition."""
    if not fits(at.coordinate, at.exponent):
        return Holds()
    expected = number_by_definition(at.coordinate, at.exponent)
    return same(expected, nearest(at.coordinate, at.exponent))


def fits_where_it_should(at: OnAxis) -> Verdict:
    """A coordinate is refused exactly if its number is 2^53 or more; then its vertex is blamed."""
    size = abs(number_by_definition(at.coordinate, at.exponent))
    line = Positions(Precision.F64, (0.0, 0.0, 0.0, 0.0, at.coordinate, 0.0))
    match quantise(line, at.exponent):
        case Accepted(_):
            return at_most(LARGEST_NUMBER, size, "|k|")
        case Rejected(_, clause, where, _):
            return every(
                at_most(size, LARGEST_NUMBER + 1, "2^53"),
                same((Clause.GEOM_LATTICE_3, AtVertex(1)), (clause, where)),
            )


def lattice_within_doubles(at: OnAxis) -> Verdict:
    """Lattice points are binary64 values, and other exponents are refused."""
    if not fits(at.coordinate, at.exponent):
        return Holds()
    k = nearest(at.coordinate, at.exponent)
    place = ldexp(float(k), at.exponent)
    point = Positions(Precision.F64, (place, 0.0, 0.0))
    outside = (quantise(point, e) for e in (LOWEST_EXPONENT - 1, HIGHEST_EXPONENT + 1))
    clauses = [r.clause if isinstance(r, Rejected) else None for r in outside]
    return every(
        same(k * Fraction(2) ** at.exponent, Fraction(place)),
        same([Clause.GEOM_LATTICE_1] * 2, clauses),
    )


def restored_exactly(given: LatticeMesh) -> Verdict:
    """k becomes k·2^e, and 0 positive zero; the precision is the narrowest."""
    step = Fraction(2) ** given.quantised.exponent
    found = restore(given.quantised)
    zeros = [copysign(1.0, x) for x in found.coordinates if x == 0.0]
    return every(
        same([k * step for k in given.quantised.numbers], [Fraction(x) for x in found.coordinates]),
        same([1.0] * len(zeros), zeros),
        same(narrowest(found.coordinates), found.precision),
    )


def error_within_half_a_step(at: OnAxis) -> Verdict:
    """|x − k·2^e| ≤ 2^(e−1), over fractions."""
    line = Positions(Precision.F64, (at.coordinate, 0.0, 0.0))
    match quantise(line, at.exponent):
        case Accepted(found):
            moved = Fraction(restore(found).coordinates[0])
            error = abs(Fraction(at.coordinate) - moved)
            half = Fraction(2) ** (at.exponent - 1)
            return Holds() if error <= half else Fails(f"≤ {half}", str(error), AtVertex(0))
        case Rejected():
            return Holds()


def quantised_once(given: LatticeMesh) -> Verdict:
    """quantise (restore q) is q."""
    again = quantise(restore(given.quantised), given.quantised.exponent)
    return same(Accepted(given.quantised), again)


def _works(given: Positions, exponent: int, bits: int) -> bool:
    """GEOM-CHOICE-1's condition, every coordinate over fractions."""
    numbers = [number_by_definition(x, exponent) for x in given.coordinates]
    spans = [max(axis) - min(axis) for axis in (numbers[i::3] for i in range(3)) if axis]
    return all(abs(k) < 1 << 53 for k in numbers) and all(span < 1 << bits for span in spans)


def least_exponent(asked: Asked) -> Verdict:
    """The exponent found will do, and the next lower will not."""
    bits = asked.bits
    match exponent_for_bits(asked.positions, bits):
        case Accepted(exponent):
            lower = exponent > LOWEST_EXPONENT and _works(asked.positions, exponent - 1, bits)
            return same((True, False), (_works(asked.positions, exponent, bits), lower))
        case Rejected(_, clause, _, _):
            possible = 1 <= bits <= 30 and _works(asked.positions, HIGHEST_EXPONENT, bits)
            return same((Clause.GEOM_CHOICE_1, False), (clause, possible))


def greatest_exponent(asked: Asked) -> Verdict:
    """The error bound is kept, and the next greater exponent would break it."""
    match exponent_for_error(asked.bound):
        case Accepted(e):
            bound = Fraction(asked.bound)
            kept = Fraction(2) ** (e - 1) <= bound
            next_breaks = Fraction(2) ** e > bound or e == HIGHEST_EXPONENT
            return same((True, True), (kept, next_breaks))
        case Rejected(_, clause, _, _):
            possible = 0.0 < asked.bound < float("inf")
            return same((Clause.GEOM_CHOICE_2, False), (clause, possible))


def box_is_tight(given: LatticeMesh) -> Verdict:
    """Indices run from 0 to the extent of their axis, reach both, and lead back."""
    match boxed(given.quantised):
        case Accepted(found):
            axes = [found.indices[i::3] for i in range(3)]
            ends = [(min(axis), max(axis)) for axis in axes]
            return every(
                same([(0, extent) for extent in found.box.extent], ends),
                same(given.quantised, unboxed(found)),
            )
        case Rejected() as rejected:
            return Fails("a box", rejected.line(), rejected.where)


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "lattice-nearest-is-exact",
        Clause.GEOM_LATTICE_5,
        "the three operations on doubles give ⌊x/2^e + 1/2⌋",
        ON_AXIS,
        nearest_is_exact,
    ),
    Law(
        "lattice-fits-where-it-should",
        Clause.GEOM_LATTICE_3,
        "a coordinate is refused exactly if its lattice number is 2^53 or more in magnitude",
        ON_AXIS,
        fits_where_it_should,
    ),
    Law(
        "lattice-within-doubles",
        Clause.GEOM_LATTICE_1,
        "every lattice point is a binary64 value",
        ON_AXIS,
        lattice_within_doubles,
    ),
    Law(
        "lattice-restored-exactly",
        Clause.GEOM_LATTICE_4,
        "the number k is restored as k·2^e",
        LATTICE_MESHES,
        restored_exactly,
    ),
    Law(
        "lattice-error-bound",
        Clause.GEOM_LATTICE_6,
        "no coordinate moves by more than half a step",
        ON_AXIS,
        error_within_half_a_step,
    ),
    Law(
        "lattice-idempotent",
        Clause.GEOM_LATTICE_7,
        "quantise (restore q) is q",
        LATTICE_MESHES,
        quantised_once,
    ),
    Law(
        "lattice-least-exponent-for-bits",
        Clause.GEOM_CHOICE_1,
        "the exponent for n bits is the least that will do",
        ASKED,
        least_exponent,
    ),
    Law(
        "lattice-greatest-exponent-for-error",
        Clause.GEOM_CHOICE_2,
        "the exponent for an error bound is the greatest that keeps it",
        ASKED,
        greatest_exponent,
    ),
    Law(
        "lattice-box-is-tight",
        Clause.GEOM_BOX_1,
        "indices reach 0 and the extent on every axis, and lead back to the numbers",
        LATTICE_MESHES,
        box_is_tight,
    ),
)
