"""Codes of words: every law, and lengths and bits worked out by hand."""

from itertools import product
from math import log2, sqrt

import pytest

from clers.codes import golden, plain
from clers.codes.laws import LAWS
from clers.codes.registry import PARTIAL, CodeName, decode, encode, most_symbols
from clers.conventions.law import AnyLaw
from clers.conventions.reason import Fault, Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol
from clers.edgebreaker.encode import encode as encode_surface
from clers.edgebreaker.examples import CUBE, TETRAHEDRON, TORUS
from clers.edgebreaker.stream import Stream
from laws import run


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_law(law: AnyLaw) -> None:
    """Clauses are in the laws."""
    run(law)


def test_plain_writes_the_codewords_after_the_implied_c() -> None:
    """CODE-PLAIN-1, CODE-IMPLIED-1: the tetrahedron is C, then R 101 and E 111."""
    bits = encode(CodeName.PLAIN, encode_surface(TETRAHEDRON).stream)
    assert isinstance(bits, Accepted)
    assert bits.value.digits() == "101111"


def test_plain_of_a_word_with_boundary_codes_every_symbol() -> None:
    """CODE-IMPLIED-1: nothing is implied where a component has boundary."""
    bits = encode(CodeName.PLAIN, Stream("RE", (), 1))
    assert isinstance(bits, Accepted)
    assert bits.value.digits() == "101111"
    assert decode(CodeName.PLAIN, bits.value, 2, 1) == Accepted("RE")
    assert decode(CodeName.PLAIN, bits.value, 3, 0) == Accepted("CRE")


def test_plain_rejects_bits_too_few_and_too_many() -> None:
    """CODE-PLAIN-2."""
    bits = plain.encode("RE")
    assert isinstance(bits, Accepted)
    short, long = plain.decode(bits.value, 3), plain.decode(bits.value, 1)
    assert isinstance(short, Rejected)
    assert (short.reason, short.where) == (Reason.TRUNCATED_BITS, AtSymbol(2))
    assert isinstance(long, Rejected)
    assert long.reason is Reason.TRAILING_BITS


def test_a_closed_word_must_begin_with_c() -> None:
    """CODE-IMPLIED-2."""
    for code in CodeName:
        refused, empty = encode(code, Stream("RE", (), 0)), encode(code, Stream("", (), 0))
        assert isinstance(refused, Rejected)
        assert (refused.reason, refused.where) == (Reason.NOT_IN_ALPHABET, AtSymbol(0))
        assert isinstance(empty, Rejected)
        bits = plain.encode("")
        assert isinstance(bits, Accepted)
        none = decode(code, bits.value, 0, 0)
        assert isinstance(none, Rejected)
        assert none.reason is Reason.EMPTY_WORD


def test_which_words_each_code_refuses() -> None:
    """CODE-NAME-6: all words of at most three symbols, with boundary and without."""
    words = ["".join(word) for n in range(1, 4) for word in product("CLERS", repeat=n)]
    for boundary, word in product((0, 1), words):
        coded = {
            code
            for code in CodeName
            if isinstance(encode(code, Stream(word, (), boundary)), Accepted)
        }
        if not boundary and word[0] != "C":
            assert not coded
            continue
        assert coded >= {CodeName.PLAIN, CodeName.HUFFMAN, CodeName.BEST}
        partial = {CodeName.KING_ROSSIGNAC, CodeName.GOLDEN, CodeName.ADAPTIVE_1}
        assert coded & partial == (set() if "CL" in word or "CE" in word else partial), word
        assert (CodeName.ENUMERATIVE in coded) == (word == "CRE" and not boundary)


def test_every_code_refuses_a_stranger() -> None:
    """CODE-NAME-6."""
    for code in CodeName:
        refused = encode(code, Stream("CRXE"))
        assert isinstance(refused, Rejected)
        expected = (Reason.NOT_IN_ALPHABET, AtSymbol(1))
        if code is CodeName.ENUMERATIVE:
            expected = (Reason.UNKNOWN_SYMBOL, AtSymbol(2))
        assert (refused.reason, refused.where) == expected
        assert refused.fault is Fault.INVALID


def test_the_golden_tables_are_fibonacci_numbers() -> None:
    """CODE-GOLDEN-1, CODE-GOLDEN-2, EB-WORD-1: by hand, in the order C, L, E, R, S."""
    assert golden.fibonacci(24) == 46368
    assert golden.AUTOMATON.frequencies == (
        (17711, 6765, 10946, 6765, 4181),
        (28657, 0, 0, 10946, 6765),
    )
    assert all(sum(row) == 46368 for row in golden.AUTOMATON.frequencies)


def test_golden_probabilities_are_powers_of_phi() -> None:
    """CODE-GOLDEN-6: the tables differ from powers of φ by less than 10^-7 bits a symbol."""
    phi = (1 + sqrt(5)) / 2
    for units in (golden.UNITS_ELSEWHERE, golden.UNITS_AFTER_C):
        assert abs(sum(phi**-cost for cost in units.values()) - 1) < 1e-12
        for cost in units.values():
            table = -log2(golden.fibonacci(24 - cost) / golden.fibonacci(24))
            assert abs(table - cost * log2(phi)) < 1e-7


def test_golden_units_of_the_examples() -> None:
    """CODE-GOLDEN-3 … CODE-GOLDEN-5, by hand.

    CRE: C 2, R after C 3, E 3, together 8 = 5·4/2 − 2. The cube has 12 triangles: 28. The torus
    has 18 and genus 1: 45 − 2 + 8 = 51.
    """
    assert golden.units(encode_surface(TETRAHEDRON).stream.word) == 8
    assert golden.units(encode_surface(CUBE).stream.word) == 28
    assert golden.units(encode_surface(TORUS).stream.word) == 51


def test_golden_does_not_know_cl_and_ce() -> None:
    """CODE-GOLDEN-1: L and E have no frequency after C."""
    for word in ("CLE", "CE"):
        refused = encode(CodeName.GOLDEN, Stream(word, (), 0))
        assert isinstance(refused, Rejected)
        assert (refused.reason, refused.where) == (Reason.NOT_IN_ALPHABET, AtSymbol(0))


def test_a_long_run_of_the_cheapest_symbol_is_still_believed() -> None:
    """CODE-NAME-3: C after C costs log2 φ in golden; the bounds hold for nothing but Cs."""
    tight = {CodeName.PLAIN: 1.01, CodeName.GOLDEN: 1.01, CodeName.HUFFMAN: 1.01}
    for code in CodeName:
        symbols = "C" * 5000
        bits = encode(code, Stream("C" + symbols, (), 0))
        if not isinstance(bits, Accepted):
            assert code not in tight
            continue
        most = most_symbols(code, bits.value.length)
        assert len(symbols) + 1 <= most
        assert code not in tight or most < tight[code] * len(symbols) + 100


def test_what_a_reader_believes_of_few_bits() -> None:
    """CODE-NAME-3, by the table."""
    assert most_symbols(CodeName.PLAIN, 7) == 8
    assert most_symbols(CodeName.GOLDEN, 7) == 12  # 7 / 0.6942 is 10.08
    assert [most_symbols(CodeName.HUFFMAN, n) for n in (0, 15, 16)] == [1, 1, 2]
    assert [most_symbols(CodeName.ADAPTIVE_3, n) for n in (0, 1)] == [2, 1422]


def test_only_codes_that_say_so_refuse_a_surface() -> None:
    """CODE-NAME-5: only the codes for some surfaces can refuse the torus, as not representable."""
    for code in CodeName:
        found = encode(code, encode_surface(TORUS).stream)
        assert code in PARTIAL or isinstance(found, Accepted)
        assert not isinstance(found, Rejected) or found.reason is Reason.NOT_REPRESENTABLE
