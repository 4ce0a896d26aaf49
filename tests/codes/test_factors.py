"""Impossible factors: views by hand, the shortest ones as listed, true words without them."""

from itertools import product

import pytest

from clers.codes.factors import (
    GAP,
    UNKNOWN,
    Edge,
    Name,
    View,
    following,
    impossible,
    impossible_factors,
)
from clers.complexes.corner_table import surface
from clers.conventions.result import Accepted
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.grammar import sphere_words
from clers.edgebreaker.stream import SYMBOLS, Stream
from clers.generate.irregular import irregular_sphere

RARE = (
    *("CCCCCCCCRCSSSSEEEEE", "CCRCCCCCCCSESSSEEEE", "CCCCCCCRLSLSEEE", "CCCCCCCRLSSREEE"),
    *("CCCCCRCSSRCREEE", "CCCRCCCCCSLESSEEE", "CCCRCCCCCSRESSEEE", "CCRCCCCCCSESRSEEE"),
    *("CCRCCCCCCSESSLEEE", "CCRCCCCCCSESSREEE", "CCCCCCCCRLSSSEEEE", "CCCCCCCRCSLSSEEEE"),
    *("CCCCCCCRCSRSSEEEE", "CCCCCCCRCSSSLEEEE"),
)
"""Words of spheres with the factors that are seldom met."""

LISTED = ("CL", "CE", "CCRE", "CCSEE", "CCCRLE", "CCCRRE", "CCRCRE", "CCSLEE", "CCSREE")


def edges(*pairs: tuple[int, int]) -> frozenset[Edge]:
    """Edges from pairs of numbers."""
    return frozenset(frozenset(map(Name, pair)) for pair in pairs)


def loop(*names: int) -> tuple[Name, ...]:
    """A loop from numbers."""
    return tuple(map(Name, names))


AFTER_C = View((loop(0, 1, 2, GAP, 3),), edges((0, 1), (0, 3), (1, 2), (1, 3)))
AFTER_S = View((loop(0, 1, 2, GAP), loop(3, 0, 4, GAP)), edges((0, 1), (1, 2), (0, 3), (0, 4)))


@pytest.mark.parametrize(
    ("view", "symbol", "after"),
    [
        (UNKNOWN, "C", {AFTER_C}),
        (UNKNOWN, "R", {UNKNOWN}),  # the side is new, then a vertex beyond it
        (UNKNOWN, "L", {UNKNOWN}),  # a vertex before the gate; without one the loop has three edges
        (UNKNOWN, "E", {UNKNOWN}),  # the loop has three edges; what is below is not known
        (UNKNOWN, "S", {AFTER_S}),  # the apex in the gap; the named vertex is next to the gate
        (AFTER_C, "E", set()),
        (AFTER_C, "L", set()),  # 3 and 1 are joined
        (AFTER_S, "E", {View((loop(0, 1, 2, GAP),), edges((0, 1), (1, 2)))}),
        (View((loop(0, 1, 2),), edges((0, 1), (1, 2), (0, 2))), "R", set()),
        (View((loop(0, 1, 2),), edges((0, 1), (1, 2), (0, 2))), "L", set()),
        (View((loop(0, 1, 2),), edges((0, 1), (1, 2), (0, 2))), "S", set()),
        # A gap that cannot be empty, for its ends are joined already.
        (View((loop(0, 1, 2, GAP),), edges((0, 1), (1, 2), (0, 2))), "E", set()),
    ],
)
def test_views_by_hand(view: View, symbol: str, after: set[View]) -> None:
    """CODE-FACTOR-1."""
    assert set(following(view, symbol)) == after


def test_a_loop_of_four_splits_nowhere_and_one_of_five_once() -> None:
    """CODE-FACTOR-1: between the apex and each end of the gate there is another vertex."""
    around = [(k, (k + 1) % 4) for k in range(4)]
    assert set(following(View((loop(0, 1, 2, 3),), edges(*around)), "S")) == set()
    around = [(k, (k + 1) % 5) for k in range(5)]
    five = View((loop(0, 1, 2, 3, 4),), edges(*around))
    (split,) = set(following(five, "S"))
    assert split.loops == (loop(0, 1, 2), loop(3, 0, 4))
    joined = View(five.loops, five.edges | edges((0, 3)))
    assert set(following(joined, "S")) == set()
    joined = View(five.loops, five.edges | edges((1, 3)))
    assert set(following(joined, "S")) == set()


def test_r_and_l_on_a_loop_of_four() -> None:
    """CODE-FACTOR-1: they leave three, unless the new side is an edge."""
    around = [(k, (k + 1) % 4) for k in range(4)]
    four = View((loop(0, 1, 2, 3),), edges(*around))
    three = View((loop(0, 1, 2),), edges((0, 1), (1, 2), (0, 2)))
    assert set(following(four, "R")) == {three}
    assert set(following(four, "L")) == {three}
    assert set(following(View(four.loops, four.edges | edges((0, 2))), "R")) == set()
    assert set(following(View(four.loops, four.edges | edges((1, 3))), "L")) == set()


def test_the_shortest_impossible_factors() -> None:
    """CODE-FACTOR-3: to six symbols as listed, nine of seven; each alone is impossible."""
    found = impossible_factors(7)
    assert found[: len(LISTED)] == LISTED
    assert [len(factor) for factor in found[len(LISTED) :]] == [7] * 9
    assert all(map(impossible, found))
    assert impossible("RRCCREC")
    assert not impossible("")


def test_nothing_else_of_four_symbols_is_impossible() -> None:
    """CODE-FACTOR-2, CODE-FACTOR-3: factors of true words, and what is said to be none."""
    assert all(isinstance(decode(Stream(word)), Accepted) for word in RARE)
    words = [*RARE, *(word for vertices in range(4, 10) for word in sphere_words(vertices))]
    for faces in (5_000, 20_000):
        built = surface(irregular_sphere(faces, 0))
        assert isinstance(built, Accepted)
        words.append(encode(built.value).stream.word)
    seen = {w[i : i + n] for w in words for n in range(1, 5) for i in range(len(w) - n + 1)}
    strings = {"".join(x) for n in range(1, 5) for x in product(SYMBOLS, repeat=n)}
    assert strings - seen == {x for x in strings if any(factor in x for factor in LISTED)}
