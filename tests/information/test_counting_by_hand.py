"""Ranks, runs and numbers worked out by hand, and each rejection at its smallest."""

from math import comb
from random import Random
from time import process_time

import pytest

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol, Where, Whole
from clers.information.enumerative import (
    Urn,
    decode,
    encode,
    rank,
    rearrangements,
    unrank,
    width,
)
from clers.information.measure import content
from clers.information.model import differences, has_ended
from clers.information.numbers import MOST_ONES, Read, gamma, golomb, read_gamma, read_golomb
from clers.information.runs import Run, joined, runs


def test_the_rearrangements_of_two_pairs() -> None:
    """INFO-ENUM-1: 0011, 0101, 0110, 1001, 1010, 1100."""
    words = [(0, 0, 1, 1), (0, 1, 0, 1), (0, 1, 1, 0), (1, 0, 0, 1), (1, 0, 1, 0), (1, 1, 0, 0)]
    assert [rank(2, word) for word in words] == [Accepted(n) for n in range(6)]
    assert [unrank((2, 2), n) for n in range(6)] == [Accepted(word) for word in words]
    assert rearrangements((2, 2)) == 6
    assert width((2, 2)) == 3


def test_three_symbols() -> None:
    """INFO-ENUM-2. 2 0 1 0: of 12 words 12·3/4 begin with less; then 001, 010, 100 remain."""
    assert rank(3, (2, 0, 1, 0)) == Accepted(9 + 1)
    assert encode(3, (2, 0, 1, 0)) == Accepted("1010")
    assert decode((2, 1, 1), "1010") == Accepted((2, 0, 1, 0))


def test_words_that_need_no_digits() -> None:
    """INFO-ENUM-4."""
    for counts, word in (((), ()), ((0, 0), ()), ((0, 3), (1, 1, 1))):
        assert (width(counts), rearrangements(counts)) == (0, 1)
        assert encode(len(counts), word) == Accepted("")
        assert decode(counts, "") == unrank(counts, 0) == Accepted(word)


def test_symbols_of_another_alphabet() -> None:
    """INFO-ENUM-4."""
    for symbol in (-1, 2):
        for got in (rank(2, (0, symbol)), encode(2, (0, symbol))):
            assert isinstance(got, Rejected)
            assert (got.reason, got.where) == (Reason.NOT_IN_ALPHABET, AtSymbol(1))


@pytest.mark.parametrize(
    ("counts", "digits", "reason", "where"),
    [
        ((1, -1, -2), "x", Reason.BAD_TABLE, AtSymbol(1)),
        ((2, 2), "1x", Reason.BAD_NUMBER, AtSymbol(1)),
        ((2, 2), "10", Reason.TRUNCATED_BITS, Whole()),
        ((2, 2), "1000", Reason.TRAILING_BITS, Whole()),
        ((0, 2), "0", Reason.TRAILING_BITS, Whole()),
        ((2, 2), "110", Reason.NOT_CANONICAL, Whole()),
    ],
)
def test_digits_that_are_no_rank(
    counts: tuple[int, ...], digits: str, reason: Reason, where: Where
) -> None:
    """INFO-ENUM-4: 110 is 6, and there are six words."""
    got = decode(counts, digits)
    assert isinstance(got, Rejected)
    assert (got.reason, got.clause, got.where) == (reason, Clause.INFO_ENUM_4, where)


@pytest.mark.parametrize(
    ("counts", "number", "reason"),
    [
        ((2, 2), -1, Reason.NOT_CANONICAL),
        ((2, 2), 6, Reason.NOT_CANONICAL),
        ((), 1, Reason.NOT_CANONICAL),
        ((-1,), 0, Reason.BAD_TABLE),
    ],
)
def test_numbers_that_are_no_rank(counts: tuple[int, ...], number: int, reason: Reason) -> None:
    """INFO-ENUM-4."""
    got = unrank(counts, number)
    assert isinstance(got, Rejected)
    assert (got.reason, got.clause) == (reason, Clause.INFO_ENUM_4)


def test_an_urn() -> None:
    """INFO-ENUM-6."""
    urn = Urn((2, 1))
    assert differences(urn.cumulative) == (2, 1)
    assert urn.after(0) == Urn((1, 1))
    assert urn.after(1) == Urn((2, 0))
    assert has_ended(urn.after(0).after(1).after(0))
    assert has_ended(Urn(()))


def test_a_long_word() -> None:
    """INFO-ENUM-2, INFO-ENUM-5: 20,000 symbols come back, within the entropy, in seconds."""
    draw = Random(7)
    word = tuple(draw.choices((0, 1, 2), (5, 2, 1), k=20_000))
    counts = tuple(word.count(symbol) for symbol in range(3))
    began = process_time()
    found = rank(3, word)
    assert isinstance(found, Accepted)
    assert unrank(counts, found.value) == Accepted(word)
    assert process_time() - began < 10
    bits = content(Urn(counts), word)
    assert isinstance(bits, Accepted)
    assert bits.value <= width(counts) < bits.value + 1
    assert rearrangements((10_000, 10_000)) == comb(20_000, 10_000)


def test_runs() -> None:
    """INFO-RUN-1."""
    assert runs((4, 4, 1, 4)) == (Run(4, 2), Run(1, 1), Run(4, 1))
    assert runs(()) == ()
    assert joined((Run(4, 2), Run(1, 1), Run(4, 1)), 4) == Accepted((4, 4, 1, 4))
    assert joined((), 0) == Accepted(())


@pytest.mark.parametrize(
    ("parts", "count", "reason", "where"),
    [
        ((Run(1, 1), Run(0, 0)), 1, Reason.NOT_CANONICAL, AtSymbol(1)),
        ((Run(1, -1),), -1, Reason.NOT_CANONICAL, AtSymbol(0)),
        ((Run(1, 1), Run(0, 1), Run(0, 2)), 9, Reason.NOT_CANONICAL, AtSymbol(2)),
        ((Run(1, 10**15),), 9, Reason.COUNT_MISMATCH, Whole()),
        ((), 1, Reason.COUNT_MISMATCH, Whole()),
        ((Run(1, 1),), 0, Reason.COUNT_MISMATCH, Whole()),
    ],
)
def test_pairs_that_are_no_runs(
    parts: tuple[Run, ...], count: int, reason: Reason, where: Where
) -> None:
    """INFO-RUN-2. A length is not believed before the sum is seen."""
    got = joined(parts, count)
    assert isinstance(got, Rejected)
    assert (got.reason, got.clause, got.where) == (reason, Clause.INFO_RUN_2, where)


def test_gamma_by_hand() -> None:
    """INFO-NUMBER-1: Elias's code of 1, 2, 3, 4, 9 for 0, 1, 2, 3, 8."""
    words = {0: "1", 1: "010", 2: "011", 3: "00100", 8: "0001001"}
    for number, word in words.items():
        assert gamma(number) == Accepted(word)
        assert read_gamma("0" + word + "1", 1) == Accepted(Read(number, 1 + len(word)))


def test_golomb_by_hand() -> None:
    """INFO-NUMBER-2. With 5 the remainders are 00, 01, 10, 110, 111; with 1 empty."""
    words = {0: "000", 1: "001", 2: "010", 3: "0110", 4: "0111", 5: "1000", 13: "110110"}
    for number, word in words.items():
        assert golomb(5, number) == Accepted(word)
        assert read_golomb(5, "1" + word + "1", 1) == Accepted(Read(number, 1 + len(word)))
    assert golomb(4, 7) == Accepted("1011")
    assert golomb(1, 3) == Accepted("1110")
    assert golomb(2, 1) == Accepted("01")
    assert read_golomb(1, "1110") == Accepted(Read(3, 4))


def test_numbers_at_the_limit() -> None:
    """INFO-NUMBER-3."""
    assert MOST_ONES == 2**20
    most = golomb(2, 2**21 - 1)
    assert isinstance(most, Accepted)
    assert len(most.value) == 2**20 + 1
    assert read_golomb(2, most.value) == Accepted(Read(2**21 - 1, 2**20 + 1))
    for got in (gamma(-1), golomb(2, -1), golomb(2, 2**21), read_golomb(1, "1" * 2**20 + "0")):
        assert isinstance(got, Rejected)
        assert (got.reason, got.clause, got.where) == (
            Reason.NOT_IN_ALPHABET,
            Clause.INFO_NUMBER_3,
            Whole(),
        )
    for got in (golomb(0, 0), golomb(2**30 + 1, 0), read_golomb(0, "0"), read_golomb(-1, "0")):
        assert isinstance(got, Rejected)
        assert (got.reason, got.clause) == (Reason.BAD_TABLE, Clause.INFO_NUMBER_3)
    assert isinstance(read_golomb(2**30 + 1, "0"), Rejected)
    assert golomb(2**30, 1) == Accepted("0" + "0" * 29 + "1")


@pytest.mark.parametrize(
    ("digits", "reason", "place"),
    [
        ("", Reason.TRUNCATED_BITS, 0),
        ("00", Reason.TRUNCATED_BITS, 2),
        ("0010", Reason.TRUNCATED_BITS, 4),
        ("001x0", Reason.BAD_NUMBER, 3),
        ("00x", Reason.BAD_NUMBER, 2),
    ],
)
def test_gamma_codes_that_are_none(digits: str, reason: Reason, place: int) -> None:
    """INFO-NUMBER-3."""
    got = read_gamma(digits)
    assert isinstance(got, Rejected)
    assert (got.reason, got.clause, got.where) == (reason, Clause.INFO_NUMBER_3, AtSymbol(place))


@pytest.mark.parametrize(
    ("digits", "reason", "place"),
    [
        ("", Reason.TRUNCATED_BITS, 0),
        ("11", Reason.TRUNCATED_BITS, 2),
        ("11x", Reason.BAD_NUMBER, 2),
        ("10", Reason.TRUNCATED_BITS, 2),
        ("101", Reason.TRUNCATED_BITS, 3),
        ("1011", Reason.TRUNCATED_BITS, 4),
        ("101x", Reason.BAD_NUMBER, 3),
        ("1011x", Reason.BAD_NUMBER, 4),
    ],
)
def test_golomb_codes_that_are_none(digits: str, reason: Reason, place: int) -> None:
    """INFO-NUMBER-3, with the parameter 5."""
    got = read_golomb(5, digits)
    assert isinstance(got, Rejected)
    assert (got.reason, got.clause, got.where) == (reason, Clause.INFO_NUMBER_3, AtSymbol(place))
