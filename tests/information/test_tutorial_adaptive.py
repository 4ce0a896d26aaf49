"""The tutorial's table of section 3(c): from 1, 1, 4, 3, 1, and one more for each symbol."""

from fractions import Fraction
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.result import Accepted, Rejected
from clers.information.adaptive import Adaptive, adaptive, recount
from clers.information.measure import probability
from clers.information.model import Model, Slot, slots

BLACK, RED, DARK, LIGHT, WHITE = range(5)

IMAGE: Final = (
    *(RED, LIGHT, DARK, LIGHT, LIGHT, LIGHT, BLACK, LIGHT),
    *(LIGHT, DARK, LIGHT, DARK, DARK, BLACK, BLACK),
)

PRINTED_CUMULATIVE: Final = (
    (0, 1, 2, 6, 9, 10),
    (0, 1, 3, 7, 10, 11),
    (0, 1, 3, 7, 11, 12),
    (0, 1, 3, 8, 12, 13),
    (0, 1, 3, 8, 13, 14),
    (0, 1, 3, 8, 14, 15),
    (0, 1, 3, 8, 15, 16),
    (0, 2, 4, 9, 16, 17),
    (0, 2, 4, 9, 17, 18),
    (0, 2, 4, 9, 18, 19),
    (0, 2, 4, 10, 19, 20),
    (0, 2, 4, 10, 20, 21),
    (0, 2, 4, 11, 21, 22),
    (0, 2, 4, 12, 22, 23),
    (0, 3, 5, 13, 23, 24),
    (0, 4, 6, 14, 24, 25),
)

PRINTED_PARTS: Final = (
    *((1, 2, 10), (7, 10, 11), (3, 7, 12), (8, 12, 13), (8, 13, 14), (8, 14, 15), (0, 1, 16)),
    *((9, 16, 17), (9, 17, 18), (4, 9, 19), (10, 19, 20), (4, 10, 21), (4, 11, 22), (0, 2, 23)),
    (0, 3, 24),
)

PRINTED_WIDTHS: Final = (
    *("0.1", "0.027272", "0.009090", "0.002797", "0.000999", "0.000400", "2.49e-5", "1.02e-5"),
    *("4.57e-6", "1.20e-6", "5.41e-7", "1.54e-7", "4.92e-8", "4.27e-9", "0.53e-9"),
)


def start() -> Adaptive:
    made = adaptive((1, 1, 4, 3, 1), increment=1, limit=1 << 16)
    assert isinstance(made, Accepted)
    return made.value


def test_printed_frequencies() -> None:
    """INFO-ADAPT-1."""
    here: Model = start()
    seen = [here.cumulative]
    for symbol in IMAGE:
        here = here.after(symbol)
        seen.append(here.cumulative)
    assert tuple(seen) == PRINTED_CUMULATIVE


def test_printed_parts() -> None:
    """INFO-MODEL-1: the slot of each symbol is the part that the table prints."""
    found = slots(start(), IMAGE)
    assert found == Accepted(tuple(Slot(*part) for part in PRINTED_PARTS))


def test_printed_widths() -> None:
    """INFO-CONTENT-1. The print cuts most decimals and rounds one, so one last digit is allowed."""
    width = Fraction(1)
    for (below, upto, total), printed in zip(PRINTED_PARTS, PRINTED_WIDTHS, strict=True):
        width *= Fraction(upto - below, total)
        digits, _, exponent = printed.partition("e")
        last_digit = Fraction(10) ** (int(exponent or "0") - len(digits.partition(".")[2]))
        assert abs(width - Fraction(printed)) < last_digit


def test_learning_a_constant_costs_a_logarithm() -> None:
    """Section 3(c), Limits: 1/2 · 2/3 · … · n/(n+1) telescopes to 1/(n+1). INFO-CONTENT-1."""
    made = adaptive((1, 1), increment=1, limit=1 << 16)
    assert isinstance(made, Accepted)
    for count in (0, 1, 2, 10, 1000):
        assert probability(made.value, (0,) * count) == Accepted(Fraction(1, count + 1))


def test_halving_by_hand() -> None:
    """INFO-ADAPT-2: 1, 4, 0 becomes 1, 7, 0 of total 8, then 1, 10, 0, over 8: 1, 5, 0."""
    first = Adaptive((0, 1, 5, 5), increment=3, limit=8).after(1)
    assert first.cumulative == (0, 1, 8, 8)
    assert first.after(1).cumulative == (0, 1, 6, 6)
    assert recount(first, (1,)) == (1, 5, 0)


def test_white_is_still_allowed() -> None:
    """INFO-MODEL-5: each of the five symbols keeps a positive frequency; a sixth has none."""
    assert isinstance(slots(start(), (*IMAGE, WHITE)), Accepted)
    got = slots(start(), (*IMAGE, 5))
    assert isinstance(got, Rejected)
    assert got.clause == Clause.INFO_MODEL_5
