"""Positions and the lattice on examples worked out by hand."""

from math import inf, ldexp, nan, nextafter

import pytest

from clers.conventions.clause import Clause
from clers.conventions.reason import Fault, Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtVertex
from clers.geometry import exact
from clers.geometry.box import boxed
from clers.geometry.lattice import (
    Quantised,
    exponent_for_bits,
    exponent_for_error,
    quantise,
    restore,
)
from clers.geometry.positions import Positions, Precision, positions


def refusal(result: object) -> Rejected:
    """The rejection that a test expects."""
    assert isinstance(result, Rejected), result
    return result


@pytest.mark.parametrize("stranger", [inf, -inf, nan])
def test_no_infinity_and_no_nan(stranger: float) -> None:
    """Clause: GEOM-POSITION-3."""
    found = refusal(positions(Precision.F64, (0.0, 0.0, 0.0, 0.0, stranger, nan), 2))
    assert found.reason is Reason.NON_FINITE_COORDINATE
    assert found.fault is Fault.INVALID
    assert found.where == AtVertex(1)


def test_not_a_number_is_found_before_what_does_not_fit() -> None:
    """Clauses: GEOM-POSITION-2, GEOM-POSITION-3, GEOM-POSITION-4."""
    too_many = refusal(positions(Precision.F32, (0.1, nan, 0.0, 1.0), 1))
    not_finite = refusal(positions(Precision.F32, (0.1, nan, 0.0), 1))
    not_single = refusal(positions(Precision.F32, (0.0, 0.0, 0.0, 0.1, 0.5, 0.0), 2))
    assert too_many.reason is Reason.COUNT_MISMATCH
    assert not_finite.reason is Reason.NON_FINITE_COORDINATE
    assert (not_single.reason, not_single.where) == (Reason.NOT_REPRESENTABLE, AtVertex(1))


def test_exact_bytes_of_negative_zero_and_the_smallest_number() -> None:
    """Clauses: GEOM-EXACT-1, GEOM-EXACT-2."""
    given = Positions(Precision.F64, (-0.0, 5e-324, 1.0))
    data = bytes.fromhex("0000000000000080 0100000000000000 000000000000f03f")
    assert exact.encode(given) == data
    back = exact.decode(Precision.F64, data, 1)
    assert isinstance(back, Accepted)
    assert exact.encode(back.value) == data
    assert str(back.value.coordinates[0]) == "-0.0"


def test_exact_bytes_of_a_nan_are_refused() -> None:
    """Clause: GEOM-POSITION-3."""
    data = bytes.fromhex("0000c07f 00000000 00000000")
    found = refusal(exact.decode(Precision.F32, data, 1))
    assert found.reason is Reason.NON_FINITE_COORDINATE


@pytest.mark.parametrize(
    ("x", "exponent", "k"),
    [
        (0.5, 0, 1),  # a tie goes up
        (-0.5, 0, 0),
        (-1.5, 0, -1),
        (2.5, 0, 3),
        (nextafter(0.5, 0.0), 0, 0),  # where adding a half first would round up
        (nextafter(-0.5, -1.0), 0, -1),
        (-5e-324, 971, 0),
        (5e-324, -1074, 1),
        (4503599627370497.5, 0, 4503599627370498),
        (9007199254740991.0, 0, 9007199254740991),
        (1.0, -2, 4),
        (0.3, -3, 2),
    ],
)
def test_nearest_lattice_numbers(x: float, exponent: int, k: int) -> None:
    """Clauses: GEOM-LATTICE-2, GEOM-LATTICE-5."""
    line = Positions(Precision.F64, (x, 0.0, 0.0))
    assert quantise(line, exponent) == Accepted(Quantised(exponent, (k, 0, 0)))


def test_a_lattice_finer_than_the_numbers_is_refused() -> None:
    """Clause: GEOM-LATTICE-3."""
    line = Positions(Precision.F64, (0.0, 0.0, 0.0, 0.0, 0.0, 9007199254740992.0))
    found = refusal(quantise(line, 0))
    assert (found.reason, found.where) == (Reason.NOT_REPRESENTABLE, AtVertex(1))
    assert isinstance(quantise(line, 1), Accepted)


@pytest.mark.parametrize("exponent", [-1075, 972])
def test_exponents_outside_binary64_are_refused(exponent: int) -> None:
    """Clause: GEOM-LATTICE-1."""
    line = Positions(Precision.F64, (0.0, 0.0, 0.0))
    assert refusal(quantise(line, exponent)).reason is Reason.BAD_LATTICE


def test_restored_positions_are_single_where_they_can_be() -> None:
    """Clauses: GEOM-LATTICE-4, GEOM-POSITION-5."""
    assert restore(Quantised(-4, (1 << 24, 0, 3))).precision is Precision.F32
    assert restore(Quantised(-4, ((1 << 24) + 1, 0, 3))).precision is Precision.F64


@pytest.mark.parametrize(
    ("width", "bits", "exponent"),
    [(1.0, 1, 0), (1.0, 2, -1), (1.0, 4, -3), (15.0, 4, 0), (15.5, 4, 1), (15.4, 4, 0)],
)
def test_exponent_for_bits(width: float, bits: int, exponent: int) -> None:
    """From 0 to 15.5 there are sixteen steps of 1 once 15.5 is rounded up.

    Clause: GEOM-CHOICE-1.
    """
    line = Positions(Precision.F64, (0.0, 0.0, 0.0, width, 0.0, 0.0))
    assert exponent_for_bits(line, bits) == Accepted(exponent)


@pytest.mark.parametrize("exponent", [-1074, -1073, 970, 971])
def test_the_least_and_the_greatest_exponents_for_bits(exponent: int) -> None:
    """So wide that not one step more is there. Clause: GEOM-CHOICE-1."""
    line = Positions(Precision.F64, (0.0, 0.0, 0.0, ldexp(2**30 - 1, exponent), 0.0, 0.0))
    assert exponent_for_bits(line, 30) == Accepted(exponent)


def test_one_place_is_kept() -> None:
    """Clause: GEOM-CHOICE-1."""
    line = Positions(Precision.F64, (0.1, 0.1, 0.1) * 3)
    exponent = exponent_for_bits(line, 1)
    assert exponent == Accepted(-56)  # 0.1 is an odd multiple of 2^-55; 2^53 bounds its number
    found = quantise(line, -56)
    assert isinstance(found, Accepted)
    assert restore(found.value).coordinates == line.coordinates


@pytest.mark.parametrize("bits", [0, 31, -1])
def test_bits_out_of_range(bits: int) -> None:
    """Clause: GEOM-CHOICE-1."""
    assert refusal(exponent_for_bits(Positions(Precision.F64, ()), bits)).reason is (
        Reason.BAD_LATTICE
    )


def test_no_lattice_is_wide_enough() -> None:
    """Clause: GEOM-CHOICE-1."""
    line = Positions(Precision.F64, (-1e308, 0.0, 0.0, 1e308, 0.0, 0.0))
    assert refusal(exponent_for_bits(line, 30)).clause is Clause.GEOM_CHOICE_1


@pytest.mark.parametrize(
    ("bound", "exponent"), [(0.5, 0), (0.4, -1), (1.0, 1), (1e308, 971), (5e-324, -1073)]
)
def test_exponent_for_error(bound: float, exponent: int) -> None:
    """Clause: GEOM-CHOICE-2."""
    assert exponent_for_error(bound) == Accepted(exponent)


@pytest.mark.parametrize("bound", [0.0, -1.0, inf, nan])
def test_error_bounds_that_ask_for_nothing(bound: float) -> None:
    """Clause: GEOM-CHOICE-2."""
    assert refusal(exponent_for_error(bound)).reason is Reason.BAD_LATTICE


def test_box_of_thirty_bits() -> None:
    """Clause: GEOM-BOX-2."""
    assert isinstance(boxed(Quantised(0, (-1, 0, 0, (1 << 30) - 2, 0, 0))), Accepted)
    found = refusal(boxed(Quantised(0, (-1, 0, 0, (1 << 30) - 1, 0, 0))))
    assert (found.reason, found.clause) == (Reason.BAD_LATTICE, Clause.GEOM_BOX_2)
