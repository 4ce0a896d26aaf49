"""Range coder and rANS: codes worked out by hand, and each rejection at its smallest."""

from collections.abc import Sequence
from typing import Final

import pytest

from clers.arithmetic.bits import Bits
from clers.arithmetic.coder import Coder, Reading
from clers.arithmetic.range_coder import RANGE_CODER
from clers.arithmetic.range_steps import Range, ending, narrow, shifted, states
from clers.arithmetic.rans import RANS
from clers.arithmetic.rans_steps import Pushed, Stretched, pop, push, stretched
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol, Where, Whole
from clers.information.adaptive import Adaptive
from clers.information.combined import Until, times
from clers.information.model import MAXIMUM_TOTAL, Model, Slot, cumulative
from clers.information.static import END, Static

MIDDLE: Final = Static(cumulative((1, 2, 1)))
BYTES: Final = Static(range(257))
NARROWEST: Final = Static((0, 1, MAXIMUM_TOTAL - 1, MAXIMUM_TOTAL))
TOO_LARGE: Final = Static((0, 1, MAXIMUM_TOTAL + 1))
BOTH: Final = (RANGE_CODER, RANS)


def given(text: str) -> Bits:
    data = bytes.fromhex(text)
    return Bits(data, 8 * len(data))


def code(coder: Coder, model: Model, symbols: Sequence[int]) -> str:
    coded = coder.encode(model, symbols)
    assert isinstance(coded, Accepted)
    assert coded.value.length == 8 * len(coded.value.data)
    assert coder.decode(model, coded.value, len(symbols)) == Accepted(tuple(symbols))
    return coded.value.data.hex(" ")


def test_empty_messages() -> None:
    """ARITH-RANGE-4: two bytes of zero. ARITH-RANS-3: the state 2^48."""
    assert code(RANGE_CODER, END, ()) == "00 00"
    assert code(RANS, END, ()) == "01 00 00 00 00 00 00"


def test_range_coder_of_bytes() -> None:
    """ARITH-RANGE-3: of 256 equal symbols each is its own digit; the end is two zeros."""
    assert code(RANGE_CODER, BYTES, (0x12, 0xFF, 0x00, 0xFF)) == "12 ff 00 ff 00 00"
    assert code(RANGE_CODER, BYTES, (0xFF, 0xFF)) == "ff ff 00 00"


def test_range_coder_three_symbols() -> None:
    """ARITH-RANGE-2. 1/4 + 1/8 is the lower end of 1, 1, 0: 2^14 + 2^13 of 2^16."""
    assert code(RANGE_CODER, MIDDLE, (1, 1, 0)) == "60 00"
    slot = Slot(1, 3, 4)
    assert narrow(Range(), slot) == Range(2**54, 2**55)
    assert narrow(narrow(Range(), slot), slot) == Range(2**54 + 2**53, 2**54)


def test_range_coder_carries() -> None:
    """ARITH-RANGE-4, ARITH-RANGE-5: digits 127, 255, 320, 0; and 127, 255, 128, 0 without."""
    assert code(RANGE_CODER, MIDDLE, [1] * 16 + [2]) == "80 00 40 00"
    assert code(RANGE_CODER, MIDDLE, [1] * 16 + [0]) == "7f ff 80 00"
    assert code(RANGE_CODER, MIDDLE, [1] * 32 + [2]) == "80 00 00 00 40 00"
    last = states([Slot(1, 3, 4)] * 16 + [Slot(3, 4, 4)])[-1]
    assert last == Range(2**56 + 2**54, 2**54, 127 * 256 + 255, 2)
    assert ending(last) == given("80004000")


def test_range_coder_rounds_up_at_the_end() -> None:
    """ARITH-RANGE-4. 1/3 is 5555.55… of 2^16, so 5556 is sent; 2/3 is aaaa.aa…, so aaab."""
    thirds = Static((0, 1, 2, 3))
    assert code(RANGE_CODER, thirds, (1,)) == "55 56"
    assert code(RANGE_CODER, thirds, (2,)) == "aa ab"


def test_range_coder_gives_the_last_symbol_the_rest() -> None:
    """ARITH-RANGE-2: 2^56 is 3·(2^56 - 1)/3 + 1, and the 1 goes to the last third."""
    third = (2**56 - 1) // 3
    assert narrow(Range(), Slot(1, 2, 3)) == Range(third, third)
    assert narrow(Range(), Slot(2, 3, 3)) == Range(2 * third, third + 1)
    assert narrow(Range(5, 2**56, 3, 2), Slot(0, 3, 3)) == Range(5, 2**56, 3, 2)


def test_range_coder_of_the_largest_total() -> None:
    """ARITH-RANGE-3: 2^-30 leaves 2^26, and three shifts make it 2^50."""
    assert code(RANGE_CODER, NARROWEST, (0,)) == "00 00 00 00 00"
    # The last of 2^30 begins at 2^56 - 2^26: digits ff ff ff, then fc of the fourth byte.
    assert code(RANGE_CODER, NARROWEST, (2,)) == "ff ff ff fc 00"


def test_a_range_is_shifted_at_the_bottom() -> None:
    """ARITH-RANGE-3: 2^48 is not settled, 2^48 + 1 is."""
    assert states([Slot(0, 1, 256)])[-1].shifts == 1
    assert shifted(Range(2**56 + 2**48 + 3, 2**40, 9, 4)) == Range(3 * 256, 2**48, 9 * 256 + 257, 5)
    assert states([Slot(255, 256, 256)] * 2)[-1] == Range(0, 2**56, 65535, 2)
    # 2^56 = 255·r + 1, so the last of 255 has r + 1 = 2^48 + 2^40 + … + 2.
    assert states([Slot(254, 255, 255)])[-1].shifts == 0


def test_rans_three_symbols() -> None:
    """ARITH-RANS-2, ARITH-RANS-3: the table of the page, x = 2^53 + 6·2^30 + 2^28."""
    assert code(RANS, MIDDLE, (1, 0, 2)) == "20 00 01 90 00 00 00"
    first = push(Pushed(2**48, b""), Stretched(3 * 2**28, 2**28))
    assert first == Pushed(2**50 + 3 * 2**28, b"")
    second = push(first, Stretched(0, 2**28))
    assert second == Pushed(2**52 + 3 * 2**30, b"")
    assert push(second, Stretched(2**28, 2**29)) == Pushed(2**53 + 6 * 2**30 + 2**28, b"")
    assert pop(second, Stretched(0, 2**28)) == first


def test_rans_sends_bytes() -> None:
    """ARITH-RANS-2: one of 2^30 sends three bytes of 2^48, then x = 2^30·2^24, and its place."""
    assert code(RANS, NARROWEST, (0,)) == "40 00 00 00 00 00 00" + " 00 00 00"
    assert code(RANS, NARROWEST, (2,)) == "40 00 00 3f ff ff ff" + " 00 00 00"
    state = Pushed(2**48 + 0x123456, b"\x07")
    assert push(state, Stretched(5, 1)) == Pushed(2**54 + 5, b"\x12\x34\x56\x07")
    assert pop(Pushed(2**54 + 5, b"\x12\x34\x56\x07"), Stretched(5, 1)) == state
    assert pop(Pushed(2**54 + 5, b"\x12"), Stretched(5, 1)) == Pushed(2**48 + 0x120000, b"")


def test_rans_sends_at_the_threshold() -> None:
    """ARITH-RANS-2: at 2^26·F a byte goes, just below it none."""
    half = Stretched(0, 2**29)
    assert push(Pushed(2**55, b""), half) == Pushed(2**48, b"\0")
    assert push(Pushed(2**55 - 1, b""), half) == Pushed(2**56 - 2**29 - 1, b"")


def test_slots_are_stretched() -> None:
    """ARITH-RANS-1: thirds of 2^30 = 3·357913941 + 1; and the largest total stays as it is."""
    third = 357_913_941
    assert stretched(Slot(0, 1, 3)) == Stretched(0, third)
    assert stretched(Slot(2, 3, 3)) == Stretched(2 * third, third + 1)
    assert stretched(Slot(1, 2, 2**30)) == Stretched(1, 1)


@pytest.mark.parametrize("coder", BOTH)
def test_adaptive_models(coder: Coder) -> None:
    """ARITH-RANS-3: slots are looked up forward, whatever way they are pushed."""
    model = Adaptive((0, 1, 2, 3), 2, 20)
    word = (0, 0, 1, 2, 2, 2, 0, 1, 1, 1, 1, 2) * 3
    code(coder, model, word)


@pytest.mark.parametrize("coder", BOTH)
def test_models_that_end(coder: Coder) -> None:
    """ARITH-BYTES-1: the decoder stops by itself."""
    until = Until(MIDDLE, stop=2)
    for model, word in ((until, (0, 1, 2)), (times(MIDDLE, 2), (2, 2))):
        coded = coder.encode(model, word)
        assert isinstance(coded, Accepted)
        assert coder.decode(model, coded.value, 1000) == Accepted(word)


@pytest.mark.parametrize("coder", BOTH)
def test_no_number_of_symbols_is_none(coder: Coder) -> None:
    """ARITH-BYTES-1."""
    coded = coder.encode(MIDDLE, ())
    assert isinstance(coded, Accepted)
    assert coder.decode(MIDDLE, coded.value, -5) == Accepted(())


@pytest.mark.parametrize("coder", BOTH)
def test_tables_that_are_too_large(coder: Coder) -> None:
    """ARITH-BYTES-1, INFO-MODEL-6."""
    zeros = given("01" + "00" * 9)
    for got in (
        coder.encode(TOO_LARGE, [1]),
        coder.read(TOO_LARGE, zeros, 1),
        coder.decode(TOO_LARGE, zeros, 1),
    ):
        assert isinstance(got, Rejected)
        assert (got.clause, got.where) == (Clause.INFO_MODEL_6, AtSymbol(0))


@pytest.mark.parametrize(
    ("text", "count", "reason", "where"),
    [
        ("", 0, Reason.TRUNCATED_BITS, AtSymbol(0)),
        ("00", 0, Reason.TRUNCATED_BITS, AtSymbol(0)),
        ("000000", 0, Reason.TRAILING_BITS, Whole()),
        ("0001", 0, Reason.NOT_CANONICAL, Whole()),
        ("12ff0000", 1, Reason.TRAILING_BITS, Whole()),
        ("12ff00", 2, Reason.TRUNCATED_BITS, AtSymbol(1)),
        ("12ff01", 1, Reason.NOT_CANONICAL, Whole()),
        ("12ff00", 10**12, Reason.TRUNCATED_BITS, AtSymbol(1)),
    ],
)
def test_range_coder_rejections(text: str, count: int, reason: Reason, where: Where) -> None:
    """ARITH-BYTES-2, ARITH-RANGE-6, ARITH-RANGE-7, of 256 equal symbols."""
    got = RANGE_CODER.decode(BYTES, given(text), count)
    assert isinstance(got, Rejected)
    assert (got.reason, got.clause, got.where) == (reason, Clause.ARITH_BYTES_2, where)


HEAD: Final = "01000000000000"


@pytest.mark.parametrize(
    ("text", "count", "reason", "clause", "where"),
    [
        ("", 0, Reason.TRUNCATED_BITS, Clause.ARITH_BYTES_2, AtSymbol(0)),
        (HEAD[:-2], 0, Reason.TRUNCATED_BITS, Clause.ARITH_BYTES_2, AtSymbol(0)),
        ("00ffffffffffff", 0, Reason.NOT_CANONICAL, Clause.ARITH_RANS_5, Whole()),
        (HEAD + "00", 0, Reason.TRAILING_BITS, Clause.ARITH_BYTES_2, Whole()),
        ("01000000000001", 0, Reason.NOT_CANONICAL, Clause.ARITH_BYTES_2, Whole()),
        (HEAD + "00", 2, Reason.TRUNCATED_BITS, Clause.ARITH_BYTES_2, AtSymbol(1)),
        (HEAD, 10**12, Reason.TRUNCATED_BITS, Clause.ARITH_BYTES_2, AtSymbol(0)),
    ],
)
def test_rans_rejections(
    text: str, count: int, reason: Reason, clause: Clause, where: Where
) -> None:
    """ARITH-BYTES-2, ARITH-RANS-4, ARITH-RANS-5: of 256 equal symbols, each pops one byte."""
    got = RANS.decode(BYTES, given(text), count)
    assert isinstance(got, Rejected)
    assert (got.reason, got.clause, got.where) == (reason, clause, where)


def test_zeros_follow_the_bytes() -> None:
    """ARITH-RANGE-6, ARITH-RANS-4, ARITH-BYTES-3."""
    assert RANGE_CODER.read(BYTES, given("12"), 3) == Accepted(Reading((0x12, 0, 0), 40, True))
    assert RANGE_CODER.read(BYTES, given("1234567890abcdef11"), 9) == Accepted(
        Reading((0x12, 0x34, 0x56, 0x78, 0x90, 0xAB, 0xCD, 0xEF, 0x11), 88, True)
    )
    assert RANS.read(BYTES, given(HEAD), 1) == Accepted(Reading((0,), 64, True))
    assert RANS.read(BYTES, given(HEAD + "05"), 1) == Accepted(Reading((0,), 64, False))


def test_a_message_within_a_longer_string() -> None:
    """ARITH-BYTES-3."""
    for coder in BOTH:
        one, other = code(coder, MIDDLE, [1] * 40 + [2]), code(coder, BYTES, (7, 9))
        both = given(one.replace(" ", "") + other.replace(" ", ""))
        read = coder.read(MIDDLE, both, 41)
        assert read == Accepted(Reading((1,) * 40 + (2,), 8 * len(bytes.fromhex(one)), True))
        rest = both.data[len(bytes.fromhex(one)) :]
        assert coder.decode(BYTES, Bits(rest, 8 * len(rest)), 2) == Accepted((7, 9))
