"""The tutorial's table of section 3(a): five colours of probability 0.1, 0.1, 0.4, 0.3, 0.1."""

from fractions import Fraction
from itertools import pairwise
from typing import Final

from clers.arithmetic import coder, exact
from clers.conventions.result import Accepted
from clers.information.model import cumulative
from clers.information.static import Static

BLACK, RED, DARK, LIGHT, WHITE = range(5)

MODEL: Final = Static(cumulative((1, 1, 4, 3, 1)))

IMAGE: Final = (RED, LIGHT, DARK, LIGHT, LIGHT, LIGHT, BLACK, LIGHT, LIGHT, DARK, LIGHT, DARK)

PRINTED: Final = (
    ("0", "1"),
    ("0.1", "0.2"),
    ("0.16", "0.19"),
    ("0.166", "0.178"),
    ("0.1732", "0.1768"),
    ("0.17536", "0.17644"),
    ("0.176008", "0.176332"),
    ("0.176008", "0.1760404"),
    ("0.17602744", "0.17603716"),
    ("0.176033272", "0.176036188"),
    ("0.1760338552", "0.1760350216"),
    ("0.17603455504", "0.17603490496"),
    ("0.176034625024", "0.176034764992"),
)


def test_printed_intervals() -> None:
    """ARITH-EXACT-1: every printed end is exact, so equality it is."""
    trace = exact.intervals(MODEL, IMAGE)
    assert isinstance(trace, Accepted)
    ends = tuple((interval.low, interval.high) for interval in trace.value)
    assert ends == tuple((Fraction(low), Fraction(high)) for low, high in PRINTED)


def test_printed_widths() -> None:
    """ARITH-EXACT-4: each width is the one before times the printed probability."""
    chances = {BLACK: "0.1", RED: "0.1", DARK: "0.4", LIGHT: "0.3", WHITE: "0.1"}
    widths = [Fraction(high) - Fraction(low) for low, high in PRINTED]
    for symbol, (before, after) in zip(IMAGE, pairwise(widths), strict=True):
        assert after == before * Fraction(chances[symbol])


def test_bits_of_the_image() -> None:
    """ARITH-EXACT-2. 0.176034625024 · 2^24 = 2953370.93, and 2953372 / 2^24 = 0.176034689 fits.

    With 23 bits the least number is 1476686, and 1476687 / 2^23 = 0.176034808 is above the end.
    """
    assert exact.encode(MODEL, IMAGE) == Accepted(exact.of_number(2953371, 24))
    assert exact.decode(MODEL, exact.of_number(2953371, 24), len(IMAGE)) == Accepted(IMAGE)


def test_32_bits_name_the_same_interval() -> None:
    """ARITH-ENCODE-1: with so short a message the integer coder's number lies in it too."""
    coded = coder.encode(MODEL, IMAGE)
    assert isinstance(coded, Accepted)
    number = Fraction(int(coded.value.digits(), 2), 2**coded.value.length)
    assert Fraction("0.176034625024") <= number < Fraction("0.176034764992")
    assert coder.decode(MODEL, coded.value, len(IMAGE)) == Accepted(IMAGE)
