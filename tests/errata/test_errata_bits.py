"""ERRATUM-2: what the three codes of King and Rossignac guarantee, as the tutorial says of [34]."""

from fractions import Fraction
from itertools import pairwise
from typing import Final

import pytest

from clers.codes.registry import CodeName
from clers.codes.registry import encode as encode_word
from clers.conventions.result import Accepted
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import TETRAHEDRON
from clers.edgebreaker.grammar import sphere_words
from clers.edgebreaker.stream import Stream

AFTER_C: Final = {"C": 1, "S": 2, "R": 2}
"""The lengths of 0, 10, 11. No L or E follows a C."""

OTHERWISE: Final = (
    {"C": 1, "S": 3, "R": 3, "L": 3, "E": 3},
    {"C": 2, "S": 3, "R": 2, "L": 3, "E": 2},
    {"C": 2, "S": 3, "R": 3, "L": 2, "E": 2},
)
"""The lengths in codes I, II and III, at the start of the word too."""

SELECTOR: Final = 2
"""Bits that say which of the three is used."""


def bits(word: str, *, first_implied: bool) -> int:
    """The best of the three codes with its selector."""
    after = [AFTER_C[y] if x == "C" else None for x, y in pairwise(word)]
    return SELECTOR + min(
        (0 if first_implied else code[word[0]])
        + sum(code[y] if known is None else known for known, y in zip(after, word[1:], strict=True))
        for code in OTHERWISE
    )


def test_the_codes_are_complete_prefix_codes() -> None:
    """ERRATUM-2: Kraft's sum is 1 for each, so that no shorter lengths were meant."""
    for code in (AFTER_C, *OTHERWISE):
        assert sum(Fraction(1, 2**length) for length in code.values()) == 1


def test_the_tetrahedron_takes_eight_bits() -> None:
    """ERRATUM-2: with all symbols coded, 8 bits exceed both 1.83 · 4 and 11/6 · 4 = 7⅓."""
    word = encode(TETRAHEDRON).stream.word
    assert bits(word, first_implied=False) == 8 > Fraction(11, 6) * 4


@pytest.mark.parametrize("triangles", range(4, 15, 2))
def test_with_the_first_c_implied_11_6_holds(triangles: int) -> None:
    """ERRATUM-2, CODE-IMPLIED-1: every sphere of T triangles takes at most 11T/6 − 1 bits.

    And the bound without it, 11T/6 + 2/3, is reached for T = 4: nothing smaller is closed.
    """
    words = list(sphere_words(triangles // 2 + 2))
    assert max(bits(w, first_implied=True) for w in words) <= Fraction(11 * triangles, 6) - 1
    most = max(bits(w, first_implied=False) for w in words)
    assert most == int(Fraction(11 * triangles, 6) + Fraction(2, 3))


@pytest.mark.parametrize(("m", "over"), [(82, False), (83, False), (84, True), (200, True)])
def test_no_decimal_below_11_6_is_a_guarantee(m: int, over: bool) -> None:
    """ERRATUM-2: (CCCRLR)^m E has 6m + 2 triangles and takes 11m + 2 bits, the first C implied.

    That is 1.83 bits a triangle at T = 500, and more for every greater m; and always below 11T/6.
    """
    word, triangles = "CCCRLR" * m + "E", 6 * m + 2
    assert isinstance(decode(Stream(word)), Accepted)
    taken = bits(word, first_implied=True)
    assert taken == 11 * m + 2 < Fraction(11 * triangles, 6)
    assert (taken > Fraction(183, 100) * triangles) is over


def test_what_chapter_6_guarantees_instead() -> None:
    """ERRATUM-2, CODE-GOLDEN-7: golden takes at most 11T/6 bits, here too."""
    for m in (1, 84):
        coded = encode_word(CodeName.GOLDEN, Stream("CCCRLR" * m + "E"))
        assert isinstance(coded, Accepted)
        assert coded.value.length <= Fraction(11 * (6 * m + 2), 6)
