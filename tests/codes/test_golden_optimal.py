"""Words on which no two tables, one after a C and one elsewhere, do better than golden.

Section 4 of the note on the golden code: C^N R u R^(p−3) E with random tokens u.
"""

from collections import Counter
from itertools import pairwise
from math import log2, sqrt
from random import Random

import pytest

from clers.codes.golden import UNIT, UNITS_AFTER_C, UNITS_ELSEWHERE, units
from clers.conventions.result import Accepted
from clers.edgebreaker.decode import decode
from clers.edgebreaker.stream import Stream

PHI = (1 + sqrt(5)) / 2
AFTER_C = (("C", PHI**-1), ("R", PHI**-3), ("SE", PHI**-4))
ELSEWHERE = (("C", PHI**-2), ("L", PHI**-4), ("R", PHI**-4), ("SE", PHI**-5))
GROWTH = {"C": 1, "R": -1, "L": -1, "SE": -2}
SHORTEST = 8


def token(draw: float, table: tuple[tuple[str, float], ...]) -> str:
    """The token that a number from 0 to 1 stands for, by the proportions of a table."""
    left = draw * sum(share for _, share in table)
    for name, share in table:
        left -= share
        if left < 0:
            return name
    return table[-1][0]


def dear(run: int, tokens: int, seed: int) -> str:
    """C^run R, then tokens; one that would make the loop too short is left out for a C."""
    draw = Random(seed).random
    word, loop = ["C"] * run + ["R"], run + 2
    for _ in range(tokens):
        found = token(draw(), AFTER_C if word[-1] == "C" else ELSEWHERE)
        if loop + GROWTH[found] < SHORTEST:
            found = "C"
        word.append(found)
        loop += GROWTH[found]
    return "".join(word) + "R" * (loop - 3) + "E"


@pytest.mark.parametrize("seed", range(40))
def test_such_words_are_valid(seed: int) -> None:
    """CODE-GOLDEN-1: the supply of words; with a short loop it is pressed against its limit."""
    assert isinstance(decode(Stream(dear(6 + seed % 5, 300, seed))), Accepted)


def test_their_entropy_is_what_golden_costs() -> None:
    """CODE-GOLDEN-1, CODE-GOLDEN-5: the frequencies fit, and no tables cost less."""
    word = dear(1000, 400_000, 1)
    assert isinstance(decode(Stream(word)), Accepted)
    triangles = len(word) + 1
    pairs = Counter(("C" if before == "C" else "", x) for before, x in pairwise(word))
    contexts = Counter[str]()
    for (before, _), count in pairs.items():
        contexts[before] += count
    for before, costs in (("C", UNITS_AFTER_C), ("", UNITS_ELSEWHERE)):
        for x, cost in costs.items():
            assert abs(pairs[before, x] / contexts[before] - PHI**-cost) < 0.008
    best = -sum(n * log2(n / contexts[before]) for (before, _), n in pairs.items())
    assert units(word) == 5 * triangles // 2 - 2
    assert 0 < units(word) * UNIT - best < 0.0005 * triangles
