"""Huffman and adaptive codes: tables and bits worked out by hand, and what is refused."""

from math import ceil, log2

import pytest

from clers.arithmetic.bits import Bits, pack
from clers.codes import adaptive, huffman
from clers.codes.code import Shape
from clers.codes.registry import CodeName, decode, encode
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtSymbol, Where
from clers.edgebreaker.stream import Stream

ADAPTIVE = (CodeName.ADAPTIVE_1, CodeName.ADAPTIVE_3, CodeName.ADAPTIVE_6)


def bits(digits: str) -> Bits:
    """Bits as one writes them, blanks left out."""
    return pack(int(x) for x in digits.replace(" ", ""))


@pytest.mark.parametrize(
    ("symbols", "digits"),
    [
        # R and E once each: lengths 1, of which E comes first.
        ("RE", "000 000 001 001 000  1 0"),
        # C five times, R three, E twice, S and L once each: the two rarest joined, 1+1=2 with E's
        # 2 or so: depths C 1, R 2, E 3, L 4, S 4. Canonical: 0, 10, 110, 1110, 1111.
        ("CCCCCRRREESL", "001 100 011 010 100 00000 101010 110110 1111 1110"),
        # A single symbol has a word of one digit all the same.
        ("E", "000 000 001 000 000  0"),
        ("", "000 000 000 000 000"),
    ],
)
def test_huffman_by_hand(symbols: str, digits: str) -> None:
    """CODE-HUFFMAN-1, CODE-HUFFMAN-2: the table in the order C, L, E, R, S, then the words."""
    assert huffman.encode(symbols, Shape()) == Accepted(bits(digits))
    assert huffman.decode(bits(digits), len(symbols), Shape()) == Accepted(symbols)


@pytest.mark.parametrize(
    ("digits", "count", "reason", "clause", "where"),
    [
        ("000 000 001 001 00", 0, Reason.TRUNCATED_BITS, Clause.CODE_HUFFMAN_3, WHOLE),
        ("001 001 001 000 000", 1, Reason.BAD_TABLE, Clause.INFO_KRAFT_2, WHOLE),
        ("000 000 001 001 000 1", 2, Reason.TRUNCATED_BITS, Clause.INFO_PREFIX_3, AtSymbol(1)),
        ("000 000 001 001 000 101", 2, Reason.TRAILING_BITS, Clause.INFO_PREFIX_3, WHOLE),
        # E alone, but R in the table; E and R, with lengths that are too long
        ("000 000 001 001 000 0", 1, Reason.NOT_CANONICAL, Clause.CODE_HUFFMAN_3, WHOLE),
        ("000 000 010 010 000 01 00", 2, Reason.NOT_CANONICAL, Clause.CODE_HUFFMAN_3, WHOLE),
        ("000 000 000 000 001", 0, Reason.NOT_CANONICAL, Clause.CODE_HUFFMAN_3, WHOLE),
    ],
)
def test_huffman_takes_no_other_bits(
    digits: str, count: int, reason: Reason, clause: Clause, where: Where
) -> None:
    """CODE-HUFFMAN-3."""
    refused = huffman.decode(bits(digits), count, Shape())
    assert isinstance(refused, Rejected)
    assert (refused.reason, refused.clause, refused.where) == (reason, clause, where)


def test_strangers_are_refused() -> None:
    """CODE-HUFFMAN-1, CODE-ADAPTIVE-1."""
    for code, clause in (
        (CodeName.HUFFMAN, Clause.CODE_HUFFMAN_1),
        (CodeName.ADAPTIVE_3, Clause.CODE_ADAPTIVE_1),
    ):
        refused = encode(code, Stream("CRXE"))
        assert isinstance(refused, Rejected)
        assert (refused.reason, refused.clause) == (Reason.NOT_IN_ALPHABET, clause)
        assert refused.where == AtSymbol(1)


def test_adaptive_by_hand() -> None:
    """CODE-ADAPTIVE-1: the tetrahedron's RE after C.

    R after C has 1 of 3, E after R (or CR) 1 of 5; information log2 15 = 3.9. The first narrows
    0 … 2^32-1 to its middle third, from 0.0101… to 0.1010…; of that the third fifth, from 7/15 to
    8/15, which is 0.0111… to 0.1000…: the central half is taken five times (the width is 1/15, and
    7/15-1/2 = -1/30, so that after n doublings the ends are 1/2 -+ 2^n/30; the interval leaves the
    central half when 2^n/30 > 1/4, at n = 3). Then low is below a quarter: 0 and four ones.
    """
    for code in ADAPTIVE:
        found = encode(code, Stream("CRE"))
        assert isinstance(found, Accepted)
        assert found.value.digits() == "01111"
        assert found.value.length <= ceil(log2(15)) + 2
        assert decode(code, found.value, 3, 0) == Accepted("CRE")


def test_adaptive_does_not_know_cl_and_ce() -> None:
    """CODE-ADAPTIVE-1: L and E have no frequency after C."""
    for code in ADAPTIVE:
        for word in ("CLE", "CE", "CRCE"):
            refused = encode(code, Stream(word))
            assert isinstance(refused, Rejected)
            assert refused.reason is Reason.NOT_IN_ALPHABET


def test_adaptive_counts_in_contexts_of_its_order() -> None:
    """CODE-ADAPTIVE-1: a run of R costs what add-half says; halving begins over 4096.

    In order 1 the context R is fresh once. Of 100 R after the first, number j has 1+2j of 5+2j.
    """
    word = "R" * 101
    ideal = log2(5) + sum(log2((5 + 2 * j) / (1 + 2 * j)) for j in range(100))
    found = adaptive.encode(1, word, "")
    assert isinstance(found, Accepted)
    assert ideal < found.value.length <= ideal + 2.1
    assert (adaptive.INCREMENT, adaptive.LIMIT) == (2, 4096)
