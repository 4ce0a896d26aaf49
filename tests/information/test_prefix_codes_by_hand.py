"""Prefix codes, Kraft's inequality and Huffman's code, each number from print or by hand."""

from fractions import Fraction

import pytest

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol, Where, Whole
from clers.information.canonical import by_sums, canonical
from clers.information.huffman import by_merging, huffman, huffman_lengths
from clers.information.prefix import PrefixCode, decode, encode, kraft, prefix_code
from clers.information.unique import ambiguity

SEASCAPE = PrefixCode(("110", "1110", "0", "10", "1111"))
"""Black, red, dark blue, light blue, white: the tutorial's Figure 2, made canonical."""


def test_seascape() -> None:
    """INFO-HUFFMAN-1, INFO-HUFFMAN-2: the depths that the tutorial prints are 3, 4, 1, 2, 4."""
    assert huffman((2, 1, 8, 4, 1)) == Accepted(SEASCAPE)
    assert SEASCAPE.lengths == (3, 4, 1, 2, 4)
    assert kraft(SEASCAPE.lengths) == 1


def test_rfc_1951() -> None:
    """INFO-KRAFT-3: the example of RFC 1951, section 3.2.2, letters A to H."""
    lengths = (3, 3, 3, 3, 3, 2, 4, 4)
    words = ("010", "011", "100", "101", "110", "00", "1110", "1111")
    assert canonical(lengths) == by_sums(lengths) == Accepted(PrefixCode(words))


def test_ties_are_broken_by_number() -> None:
    """INFO-HUFFMAN-1. Of 2, 1, 1, 1, 1: 1+2 make tree 5, 3+4 tree 6; then 0 and 5, of weight 2."""
    assert huffman_lengths((2, 1, 1, 1, 1)) == Accepted((2, 3, 3, 2, 2))
    assert by_merging((2, 1, 1, 1, 1)) == (2, 3, 3, 2, 2)


def test_the_flatter_of_two_best_codes() -> None:
    """INFO-HUFFMAN-3: for 2, 2, 1, 1 the lengths 2, 2, 2, 2 and 1, 2, 3, 3 both sum to 12."""
    assert huffman_lengths((2, 2, 1, 1)) == Accepted((2, 2, 2, 2))


def test_symbols_that_do_not_occur() -> None:
    """INFO-HUFFMAN-2, INFO-PREFIX-4."""
    assert huffman((0, 3, 0, 1)) == Accepted(PrefixCode((None, "0", None, "1")))
    assert by_merging((0, 3, 0, 1)) == (None, 1, None, 1)
    assert huffman((0, 7)) == Accepted(PrefixCode((None, "")))
    assert decode(PrefixCode((None, "")), "", 3) == Accepted((1, 1, 1))
    assert decode(PrefixCode((None, "")), "", -3) == Accepted(())


@pytest.mark.parametrize(
    ("frequencies", "where"), [((), Whole()), ((0, 0), Whole()), ((1, -1), AtSymbol(1))]
)
def test_tables_without_a_code(frequencies: tuple[int, ...], where: Where) -> None:
    """INFO-HUFFMAN-2."""
    for got in (huffman(frequencies), huffman_lengths(frequencies)):
        assert isinstance(got, Rejected)
        assert (got.reason, got.where) == (Reason.BAD_TABLE, where)


def test_lucas_numbers_reach_the_greatest_length() -> None:
    """INFO-HUFFMAN-5: 1, 1 and the Lucas numbers 1, 3, 4, …, L(41) sum to L(43) - 1."""
    lucas = [1, 3]
    while len(lucas) < 41:
        lucas.append(lucas[-1] + lucas[-2])
    row = (1, 1, *lucas)
    assert sum(row) == 969_323_029 - 1 <= 2**30
    lengths = huffman_lengths(row)
    assert lengths == Accepted((42, 42, *range(41, 0, -1)))


@pytest.mark.parametrize(
    ("lengths", "where"),
    [
        ((1, 1, 64), Whole()),
        ((0, 0), Whole()),
        ((1, None, -1), AtSymbol(2)),
        ((65, -1), AtSymbol(0)),
    ],
)
def test_lengths_without_a_code(lengths: tuple[int | None, ...], where: Where) -> None:
    """INFO-KRAFT-2."""
    for got in (canonical(lengths), by_sums(lengths)):
        assert isinstance(got, Rejected)
        assert (got.reason, got.clause, got.where) == (
            Reason.BAD_TABLE,
            Clause.INFO_KRAFT_2,
            where,
        )


def test_lengths_at_the_limit() -> None:
    """INFO-KRAFT-2, INFO-KRAFT-1: no length at all, the length 0, the length 64."""
    assert canonical(()) == Accepted(PrefixCode(()))
    assert kraft(()) == kraft((None,)) == 0
    assert canonical((0,)) == Accepted(PrefixCode(("",)))
    assert canonical((64, 1)) == Accepted(PrefixCode(("1" + "0" * 63, "0")))
    assert kraft((64, 1)) == Fraction(1, 2) + Fraction(1, 2**64)


@pytest.mark.parametrize(
    ("words", "symbol"),
    [
        (("0", "01"), 1),
        (("01", "0"), 1),
        (("0", "10", "0"), 2),
        (("", None, "1"), 2),
        (("1", "0", ""), 2),
        (("0", "0", "x"), 2),
        (("0", "1x"), 1),
    ],
)
def test_words_that_are_no_code(words: tuple[str | None, ...], symbol: int) -> None:
    """INFO-PREFIX-1. A character that is no digit is blamed before a beginning is."""
    got = prefix_code(words)
    assert isinstance(got, Rejected)
    assert (got.reason, got.clause) == (Reason.BAD_TABLE, Clause.INFO_PREFIX_1)
    assert got.where == AtSymbol(symbol)


def test_a_message() -> None:
    """INFO-PREFIX-2."""
    assert encode(SEASCAPE, (2, 0, 3, 4)) == Accepted("0" + "110" + "10" + "1111")
    assert decode(SEASCAPE, "0110101111", 4) == Accepted((2, 0, 3, 4))
    assert prefix_code(SEASCAPE.words) == Accepted(SEASCAPE)
    for symbol in (-1, 5):
        got = encode(SEASCAPE, (2, symbol))
        assert isinstance(got, Rejected)
        assert (got.reason, got.where) == (Reason.NOT_IN_ALPHABET, AtSymbol(1))


@pytest.mark.parametrize(
    ("digits", "count", "reason", "where"),
    [
        ("", 1, Reason.TRUNCATED_BITS, AtSymbol(0)),
        ("00", 3, Reason.TRUNCATED_BITS, AtSymbol(2)),
        ("10" + "110", 2, Reason.TRUNCATED_BITS, AtSymbol(1)),
        ("0" + "111", 2, Reason.NOT_CANONICAL, AtSymbol(1)),
        ("0" + "1x", 2, Reason.BAD_NUMBER, AtSymbol(1)),
        ("x", 1, Reason.BAD_NUMBER, AtSymbol(0)),
        ("00", 1, Reason.TRAILING_BITS, Whole()),
        ("0", 0, Reason.TRAILING_BITS, Whole()),
        ("0", -1, Reason.TRAILING_BITS, Whole()),
    ],
)
def test_digits_that_are_no_message(digits: str, count: int, reason: Reason, where: Where) -> None:
    """INFO-PREFIX-3, with the words 0, 10, 1100, 1101: 111 begins none."""
    code = PrefixCode(("0", "10", "1100", None, "1101"))
    got = decode(code, digits, count)
    assert isinstance(got, Rejected)
    assert (got.reason, got.clause, got.where) == (reason, Clause.INFO_PREFIX_3, where)


def test_the_empty_word_reads_nothing() -> None:
    """INFO-PREFIX-3, INFO-PREFIX-4."""
    got = decode(PrefixCode(("",)), "1", 1)
    assert isinstance(got, Rejected)
    assert got.reason == Reason.TRAILING_BITS


def test_ambiguities() -> None:
    """INFO-UNIQUE-1. 0, 01, 11 is uniquely decodable but no prefix code; 0, 01, 10 is not."""
    assert ambiguity(("0", "01", "11")) is None
    assert set(ambiguity(("0", "01", "10")) or ()) == {(0, 2), (1, 0)}
    assert set(ambiguity(("1", "0", "1")) or ()) == {(0,), (2,)}
    assert ambiguity(("0", "")) == ((), (1,))
    assert ambiguity(()) is None
    words = ("1", "011", "01110", "1110", "10011")
    found = ambiguity(words)
    assert found is not None
    one, other = ("".join(words[s] for s in message) for message in found)
    assert one == other
    assert found[0] != found[1]
