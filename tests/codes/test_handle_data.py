"""Bits of handle data: sizes and digits by hand, long numbers, what is refused."""

from math import log2

import pytest

from clers.arithmetic.bits import Bits, pack
from clers.codes import handle_data
from clers.codes.closings import Closing
from clers.codes.laws_handles import LAWS, most_bits
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds
from clers.edgebreaker.examples import TORUS
from clers.edgebreaker.stream import Kind, Record, Side, Stream
from clers.information.adaptive import Adaptive
from clers.information.model import cumulative
from clers.kernels import closing

FIRST = Closing(0, Kind.HANDLE, Side.RIGHT, 0)


def coded(seen: tuple[Closing, ...], symbols: int) -> Bits:
    found = handle_data.encode(seen, symbols)
    assert isinstance(found, Accepted), found
    assert handle_data.decode(found.value, len(seen), symbols) == Accepted(seen)
    return found.value


def test_sizes() -> None:
    """CODE-HAND-4: as many as the number of symbols has binary digits."""
    assert [handle_data.sizes(n) for n in (0, 1, 2, 3, 4, 7, 8)] == [1, 1, 2, 2, 3, 3, 4]


@pytest.mark.parametrize(
    ("seen", "symbols", "digits"),
    [
        ((), 5, "01"),
        # sizes 1/2 and 1/2, kind and side 1/2: four times the lower half, then 0 and 1
        ((FIRST,), 3, "000001"),
        # one size only, of which nothing is said: kind 1 and side 1
        ((Closing(0, Kind.BOUNDARY, Side.LEFT, 0),), 1, "1101"),
        # 1 has the size 1 of two and the digit 0; 2 the same and 1
        ((Closing(1, Kind.HANDLE, Side.LEFT, 2),), 3, "10 0 1 11 01"),
        # the second time 0 has 3 of 4 in each field: 81/256 of a sixteenth: below half of it
        ((FIRST, FIRST), 3, "0000001"),
    ],
)
def test_by_hand(seen: tuple[Closing, ...], symbols: int, digits: str) -> None:
    """CODE-HAND-4, ARITH-END-1."""
    assert coded(seen, symbols).digits() == digits.replace(" ", "")


def test_long_numbers_are_cut_into_pieces() -> None:
    """CODE-HAND-4, INFO-COMBINE-7: more than sixteen digits."""
    numbers = (
        0,
        1,
        65534,
        65535,
        65536,
        (1 << 17) - 2,
        (1 << 17) - 1,
        (1 << 25) + 5,
        (1 << 26) - 1,
    )
    seen = tuple(Closing(n, Kind.HANDLE, Side.LEFT, m) for n in numbers for m in numbers)
    assert len(coded(seen, 1 << 26).data) < 81 * 8


def test_what_is_refused() -> None:
    """CODE-HAND-5: by the strict reader of chapter 2."""
    bits = coded((FIRST,), 3)
    cases = {
        Reason.TRUNCATED_BITS: pack(bits.values()[:-1]),
        Reason.TRAILING_BITS: bits.followed_by(pack([0])),
        Reason.NOT_CANONICAL: pack([0, 0, 0, 0, 0, 0]),
    }
    for reason, other in cases.items():
        refused = handle_data.decode(other, 1, 3)
        assert isinstance(refused, Rejected)
        assert refused.reason is reason
        assert refused.clause in (
            Clause.ARITH_STRICT_2,
            Clause.ARITH_STRICT_3,
            Clause.ARITH_STRICT_4,
        )


def test_the_bound_by_hand() -> None:
    """CODE-HAND-6: two closings of 17 symbols, five sizes: those of the torus."""
    seen = (
        Closing(2, Kind.HANDLE, Side.RIGHT, 2),
        Closing(0, Kind.HANDLE, Side.RIGHT, 4),
    )
    expected = 5 + 0.002 + 5 * 1 + 2 * log2(5) + (1 + 1) + (0 + 2) + 2 * (2 + 2 * log2(5))
    assert abs(most_bits(seen, 17) - expected) < 1e-9


def test_the_laws_can_fail(monkeypatch: pytest.MonkeyPatch) -> None:
    """CODE-HAND-5, CODE-HAND-6: a decoder that is not strict, an alphabet far too large."""
    back, short, *_ = LAWS
    assert (back.check(TORUS), short.check(TORUS)) == (Holds(), Holds())
    with monkeypatch.context() as planted:
        planted.setattr(handle_data, "decode", lambda bits, count, symbols: Accepted(()))
        assert isinstance(back.check(TORUS), Fails)
    with monkeypatch.context() as planted:
        wide = Adaptive(cumulative((1,) * 4096), 2, 1 << 30)
        planted.setattr(handle_data, "_fresh", lambda size: wide)
        assert isinstance(short.check(TORUS), Fails)


def test_the_laws_of_definitions_can_fail(monkeypatch: pytest.MonkeyPatch) -> None:
    """CODE-HAND-2, CODE-HAND-3: a sweep that takes an edge too far, and one that finds none."""
    *_, seen, undone = LAWS
    stream = Stream("SSEE", (Record(Kind.HANDLE, 0, 1, Side.LEFT),))
    assert (seen.check(stream), undone.check(stream)) == (Holds(), Holds())
    with monkeypatch.context() as planted:
        planted.setattr(closing, "between", lambda *_: [2])
        assert isinstance(seen.check(stream), Fails)
    with monkeypatch.context() as planted:
        planted.setattr(closing, "closers", lambda *_: [closing.NONE])
        assert isinstance(undone.check(stream), Fails)
