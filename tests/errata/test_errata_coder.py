"""ERRATUM-16 to 19: the arithmetic coder as printed; chapter 2 has it mended."""

from fractions import Fraction
from typing import Final

from printed_coder import HALF, MANY, decode_one, encode, slot

from clers.arithmetic import coder, exact
from clers.conventions.result import Accepted
from clers.information.model import cumulative
from clers.information.static import Static

COLOURS: Final = tuple(Fraction(tenths, 10) for tenths in (1, 1, 4, 3, 1))
BLACK, RED, DARK, LIGHT, WHITE = range(5)
QUARTERS: Final = (Fraction(1, 4), Fraction(3, 4))
FIRST, STOP = range(2)


def test_printed_intervals_are_not_nested() -> None:
    """ERRATUM-16: after red the table of 3(a) has [0.16, 0.19) for light blue. ARITH-NARROW-1."""
    trace = exact.intervals(Static(cumulative((1, 1, 4, 3, 1))), (RED, LIGHT))
    assert isinstance(trace, Accepted)
    assert (trace.value[2].low, trace.value[2].high) == (Fraction("0.16"), Fraction("0.19"))
    assert slot(COLOURS, LIGHT) == (Fraction("0.6"), Fraction("0.9"))


def test_printed_decoder_names_the_next_symbol() -> None:
    """ERRATUM-16: of two equal symbols, 1/4 lies in the first and is decoded as the second.

    ARITH-DECODE-2. Fewer symbols than two leave nothing to decode.
    """
    symbol, interval = decode_one((HALF, HALF), Fraction(1, 4))
    assert interval == (Fraction(0), HALF)
    assert symbol == 2


def test_printed_loop_does_not_end() -> None:
    """ERRATUM-17: red, the first symbol of the tutorial's own message. ARITH-STATE-2.

    [0.4, 0.8) is shorter than a half and in none of the three halves, so it is doubled for ever.
    """
    bits, passed = encode(COLOURS, (RED,))
    lows = [10 * low for low, _ in passed[:5]]
    assert lows == [Fraction(x) for x in (1, 2, 4, 8, 16)]
    assert all(high == 2 * low for low, high in passed)
    assert (bits, len(passed)) == ("00", MANY + 1)
    ours = coder.encode(Static(cumulative((1, 1, 4, 3, 1))), (RED,))
    assert isinstance(ours, Accepted)
    assert ours.value.digits().startswith("00")


def test_printed_coder_sends_nothing_at_the_end() -> None:
    """ERRATUM-18: of two symbols, 1/4 and 3/4, the second alone is sent as no bits. ARITH-END-1."""
    bits, passed = encode(QUARTERS, (STOP,))
    assert bits == ""
    assert passed == [(Fraction(1, 4), Fraction(1))]
    model = Static((0, 1, 4))
    assert exact.decode(model, exact.of_number(0, 0), 1) == Accepted((FIRST,))
    ours = coder.encode(model, (STOP,))
    assert isinstance(ours, Accepted)
    assert coder.decode(model, ours.value, 1) == Accepted((STOP,))


def test_the_central_half_knows_one_bit_at_most() -> None:
    """ERRATUM-19: [1/3, 2/3) lies in the central half and holds numbers 0.01… and 0.10….

    ARITH-SHIFT-1, ARITH-SHIFT-2. Four times as long it is longer than 1.
    """
    low, high = Fraction(1, 3), Fraction(2, 3)
    assert low < Fraction(0b0111, 16) < high
    assert low < Fraction(0b1001, 16) < high
    assert HALF / 2 <= low < high <= 3 * HALF / 2
    assert 4 * (high - low) > 1
