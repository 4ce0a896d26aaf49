"""Codes worked out by hand, and each rejection at its smallest."""

from typing import Final

import pytest

from clers.arithmetic import coder, exact
from clers.arithmetic.bits import Bits, pack, packed
from clers.arithmetic.coder import Reading
from clers.arithmetic.steps import HALF, QUARTER, TOP, State, narrow
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtByte, AtSymbol, Where, Whole
from clers.information.combined import Until, times
from clers.information.model import MAXIMUM_TOTAL, Model, Slot, cumulative
from clers.information.static import END, Static

COIN: Final = Static(cumulative((1, 1)))
MIDDLE: Final = Static(cumulative((1, 2, 1)))
TOO_LARGE: Final = Static((0, 1, MAXIMUM_TOTAL + 1))


def bits(digits: str) -> Bits:
    return pack(int(digit) for digit in digits)


def digits_of(model: Model, *symbols: int) -> str:
    coded = coder.encode(model, symbols)
    assert isinstance(coded, Accepted)
    return coded.value.digits()


def test_empty_message() -> None:
    """ARITH-END-1: all of the state is left, so its second quarter is named."""
    assert digits_of(COIN) == "01"
    assert digits_of(END) == "01"


def test_coin() -> None:
    """ARITH-SHIFT-2, ARITH-BITS-1: each toss is a bit; then the ending of an untouched state."""
    assert digits_of(COIN, 1, 0, 1, 1) == "1011" + "01"


def test_symbols_that_are_certain_cost_nothing() -> None:
    """ARITH-NARROW-1: the whole interval is the only part."""
    certain = Static((0, MAXIMUM_TOTAL))
    assert digits_of(certain, *[0] * 50) == "01"
    assert coder.decode(certain, bits("01"), 50) == Accepted((0,) * 50)


def test_one_of_the_largest_total() -> None:
    """INFO-MODEL-2, ARITH-NARROW-1: of 2^32 integers the first 4, or the last 4, are left."""
    for symbol, digits in ((0, "0" * 30 + "01"), (2, "1" * 30 + "01")):
        model = Static((0, 1, MAXIMUM_TOTAL - 1, MAXIMUM_TOTAL))
        assert digits_of(model, symbol) == digits
        assert coder.decode(model, bits(digits), 1) == Accepted((symbol,))
        assert exact.decode(model, bits(digits), 1) == Accepted((symbol,))


@pytest.mark.parametrize("count", [0, 1, 2, 31, 32, 33, 1000])
def test_pending_bits(count: int) -> None:
    """ARITH-SHIFT-2, ARITH-END-1, ARITH-CARRY-1: [1/4, 3/4) again and again leaves all pending.

    The interval is 1/2 ± 2^-(count+1). Its second quarter begins at 1/2 - 2^-(count+2).
    The upper quarter of it is 1/2 and then count zeros, and a one.
    """
    middles = [1] * count
    assert digits_of(MIDDLE, *middles) == "0" + "1" * (count + 1)
    assert digits_of(MIDDLE, *middles, 2) == "1" + "0" * count + "1" + "01"
    assert digits_of(MIDDLE, *middles, 0) == "0" + "1" * count + "0" + "01"


def test_ending_in_the_upper_half() -> None:
    """ARITH-END-1, ARITH-STRICT-4. [1/4, 1) has low = 2^30, so the third quarter is named."""
    model = Static(cumulative((1, 3)))
    assert digits_of(model, 1) == "10"
    assert digits_of(model, 0) == "00" + "01"
    assert coder.decode(model, bits("10"), 1) == Accepted((1,))
    assert isinstance(coder.decode(model, bits("01"), 1), Rejected)  # in the interval as well


def test_zeros_follow_the_bits() -> None:
    """ARITH-DECODE-1, ARITH-DECODE-2, ARITH-DECODE-4: 1 says 1, 0, 0, coded 10001."""
    assert coder.read(COIN, bits("1"), 3) == Accepted(Reading((1, 0, 0), 5, canonical=False))


def test_a_message_within_a_longer_string() -> None:
    """ARITH-DECODE-4, ARITH-END-2: the second message starts where the first is seen to end."""
    both = digits_of(COIN, 1, 1) + digits_of(MIDDLE, 1, 2)
    first = coder.read(COIN, bits(both), 2)
    assert first == Accepted(Reading((1, 1), 4, canonical=True))
    assert coder.decode(MIDDLE, bits(both[4:]), 2) == Accepted((1, 2))


def test_a_model_that_ends_stops_the_decoder() -> None:
    """ARITH-DECODE-3, INFO-MODEL-3."""
    until = Until(COIN, stop=1)
    assert coder.decode(until, bits(digits_of(until, 0, 0, 1)), 1000) == Accepted((0, 0, 1))
    two = times(COIN, 2)
    assert coder.decode(two, bits("1101"), 1000) == Accepted((1, 1))


@pytest.mark.parametrize(
    ("given", "count", "reason", "where"),
    [
        ("", 0, Reason.TRUNCATED_BITS, AtSymbol(0)),
        ("0", 0, Reason.TRUNCATED_BITS, AtSymbol(0)),
        ("1011", 3, Reason.TRUNCATED_BITS, AtSymbol(2)),
        ("101", 3, Reason.TRUNCATED_BITS, AtSymbol(1)),
        ("010", 0, Reason.TRAILING_BITS, Whole()),
        ("101010", 3, Reason.TRAILING_BITS, Whole()),
        ("00", 0, Reason.NOT_CANONICAL, Whole()),
        ("10", 0, Reason.NOT_CANONICAL, Whole()),
        ("11", 0, Reason.NOT_CANONICAL, Whole()),
        ("10100", 3, Reason.NOT_CANONICAL, Whole()),
        ("10101", 10**12, Reason.TRUNCATED_BITS, AtSymbol(3)),
    ],
)
def test_rejections(given: str, count: int, reason: Reason, where: Where) -> None:
    """ARITH-STRICT-2, ARITH-STRICT-3, ARITH-STRICT-4. No count keeps the decoder busy."""
    got = coder.decode(COIN, bits(given), count)
    assert isinstance(got, Rejected)
    assert (got.reason, got.where) == (reason, where)


def test_a_table_that_is_too_large() -> None:
    """INFO-MODEL-6: encoder and decoder say so, at the symbol that meets it."""
    for got in (
        coder.encode(TOO_LARGE, [1]),
        coder.read(TOO_LARGE, bits("01"), 1),
        coder.decode(TOO_LARGE, bits("01"), 1),
        exact.encode(TOO_LARGE, [1]),
        exact.decode(TOO_LARGE, bits("01"), 1),
    ):
        assert isinstance(got, Rejected)
        assert (got.reason, got.where) == (Reason.BAD_TABLE, AtSymbol(0))
        assert str(MAXIMUM_TOTAL + 1) in got.detail


@pytest.mark.parametrize("symbol", [-1, 1, 3])
def test_symbols_that_are_not_there(symbol: int) -> None:
    """INFO-MODEL-5, ARITH-ENCODE-1: below the first, of frequency 0, above the last."""
    got = coder.encode(Static((0, 1, 1, 2)), [0, 2, symbol, 0])
    assert isinstance(got, Rejected)
    assert (got.reason, got.where) == (Reason.NOT_IN_ALPHABET, AtSymbol(2))


def test_packing() -> None:
    """ARITH-BITS-2, ARITH-BITS-3."""
    assert bits("10100000011").data == b"\xa0\x60"
    assert bits("").data == b""
    assert packed(b"\xa0\x60", 11) == Accepted(bits("10100000011"))
    assert packed(b"", 0) == Accepted(bits(""))
    assert packed(b"\x01", 8) == Accepted(bits("00000001"))
    assert packed(b"\xff\x80", 9) == Accepted(bits("111111111"))


@pytest.mark.parametrize(
    ("data", "length", "reason", "where"),
    [
        (b"\xa0", 9, Reason.TRUNCATED_BITS, Whole()),
        (b"", -1, Reason.TRUNCATED_BITS, Whole()),
        (b"\xa0\x00", 8, Reason.TRAILING_BITS, AtByte(1)),
        (b"\xa0\x00", 0, Reason.TRAILING_BITS, AtByte(0)),
        (b"\xff\xa1", 15, Reason.TRAILING_BITS, AtByte(1)),
        (b"\xff\x81", 9, Reason.TRAILING_BITS, AtByte(1)),
        (b"\x00\x00\x20", 18, Reason.TRAILING_BITS, AtByte(2)),
    ],
)
def test_bytes_that_do_not_fit(data: bytes, length: int, reason: Reason, where: Where) -> None:
    """ARITH-BITS-3."""
    got = packed(data, length)
    assert isinstance(got, Rejected)
    assert (got.reason, got.where) == (reason, where)


def test_why_totals_end_at_a_quarter() -> None:
    """INFO-MODEL-2, ARITH-STATE-1, ARITH-NARROW-2: the narrowest settled state and its first slot.

    It has 2^30 + 2 integers: enough for a total of 2^30 + 2, and not for one more.
    """
    narrowest = State(QUARTER - 1, HALF)
    assert narrowest.width == QUARTER + 2
    enough, empty = (narrow(narrowest, Slot(0, 1, QUARTER + more)) for more in (2, 3))
    assert enough.width == 1
    assert empty.width == 0
    assert State().high == TOP


def test_bits_are_cut_anywhere() -> None:
    """ARITH-BITS-2: each part is packed anew, and both parts together are the whole."""
    whole = bits("110100111010110")
    for count in range(whole.length + 1):
        front, back = whole.upto(count), whole.after(count)
        assert (front, back) == (bits(whole.digits()[:count]), bits(whole.digits()[count:]))
        assert front.followed_by(back) == whole
    assert whole.upto(99) == whole
