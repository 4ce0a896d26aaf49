"""The search for collapses to a point, on complexes whose answer is known."""

from itertools import combinations

import pytest
from moved import after

from clers.complexes.known import BALLS, DUNCE, KNOWN, MOORE, Known
from clers.complexes.simplicial import Complex, closure, dimension, of_dimension
from clers.conventions.verdict import Holds
from clers.operators.moves.collapse import free_pairs
from clers.operators.moves.collapsible import (
    Collapsible,
    Exhausted,
    NotCollapsible,
    Stuck,
    Undecided,
    WrongHomology,
    collapse_to_point,
    greedy,
)
from clers.operators.moves.laws_collapse import LAWS
from clers.operators.moves.move import Collapse

SMALL = [of for of in KNOWN if sum(of.f_vector) < 100]


@pytest.mark.parametrize("of", SMALL, ids=lambda of: of.name)
def test_known(of: Known) -> None:
    """Clauses: OPER-COLLAPSE-5, OPER-COLLAPSE-6, OPER-COLLAPSE-7."""
    found = collapse_to_point(of.complex)
    assert isinstance(found, Collapsible) == of.collapsible
    if isinstance(found, Collapsible):
        assert len(found.moves) == (sum(of.f_vector) - 1) // 2
        assert len(after(of.complex, *found.moves).simplices) == 1
    elif of.gf2 != (1,) + (0,) * of.dimension:
        assert found == NotCollapsible(WrongHomology(of.gf2))


def test_the_empty_complex_is_no_point() -> None:
    assert collapse_to_point(Complex(frozenset())) == NotCollapsible(WrongHomology(()))


def test_a_point_needs_no_collapse() -> None:
    assert collapse_to_point(closure([(4,)])) == Collapsible(())


def test_homology_is_that_over_two_elements() -> None:
    """Torsion of order three is not seen; what cannot be collapsed is stuck all the same."""
    assert collapse_to_point(MOORE.complex) == NotCollapsible(Stuck(()))


def test_stuck_after_a_while() -> None:
    """A dunce hat with a hair of two edges: the hair goes, end first."""
    k = Complex(DUNCE.complex.simplices | closure([(0, 8), (8, 9)]).simplices)
    hair = (Collapse((9,), (8, 9)), Collapse((8,), (0, 8)))
    assert collapse_to_point(k) == NotCollapsible(Stuck(hair))


def test_exhausted() -> None:
    """A tetrahedron on a triangle of the dunce hat has four free walls; none helps.

    Three lead back to the hat, the fourth to the hat with a vertex in that triangle. So there are
    five complexes: the first, and one after each collapse of the tetrahedron.
    """
    facet = min(map(sorted, of_dimension(DUNCE.complex, 2)))
    k = Complex(DUNCE.complex.simplices | closure([(*facet, 8)]).simplices)
    assert collapse_to_point(k) == NotCollapsible(Exhausted(5))
    assert collapse_to_point(k, 4) == NotCollapsible(Exhausted(5))
    assert collapse_to_point(k, 3) == Undecided(3)


def test_exhausted_meets_each_complex_once() -> None:
    """Two tetrahedra on two triangles: 1 + 8 + 16 complexes, each of the 16 reached twice."""
    first, second = sorted(map(sorted, of_dimension(DUNCE.complex, 2)))[:2]
    more = closure([(*first, 8), (*second, 9)])
    k = Complex(DUNCE.complex.simplices | more.simplices)
    assert collapse_to_point(k) == NotCollapsible(Exhausted(25))
    # 8 collapses of one, and 4 of the other after each: 40 are tried
    assert collapse_to_point(k, 40) == NotCollapsible(Exhausted(25))
    assert collapse_to_point(k, 39) == Undecided(39)


def test_budget() -> None:
    """The tetrahedron is one collapse and a disc. Clause: OPER-COLLAPSE-5."""
    ball = BALLS[3].complex
    assert isinstance(collapse_to_point(ball, 1), Collapsible)
    assert collapse_to_point(ball, 0) == Undecided(0)
    assert isinstance(collapse_to_point(BALLS[2].complex, 0), Collapsible)
    assert collapse_to_point(DUNCE.complex, 0) == NotCollapsible(Stuck(()))


def test_highest_dimensions_go_first() -> None:
    k = closure([(0, 1, 2, 3), (0, 4)])
    found = collapse_to_point(k)
    assert isinstance(found, Collapsible)
    sizes = [len(move.coface) for move in found.moves]
    assert sizes == sorted(sizes, reverse=True) == [4, 3, 3, 3, 2, 2, 2, 2]


def test_backtracking_in_dimension_three() -> None:
    """A ball of tetrahedra on a line: every order of collapses is a success."""
    k = closure([(i, i + 1, i + 2, i + 3) for i in range(4)])
    found = collapse_to_point(k)
    assert isinstance(found, Collapsible)
    assert len(after(k, *found.moves).simplices) == 1


@pytest.mark.parametrize("of", SMALL, ids=lambda of: of.name)
def test_the_tutorials_condition_for_a_collapse(of: Known) -> None:
    """6(a), right as printed: only one simplex of the next dimension. Clause: OPER-COLLAPSE-2."""
    (law,) = [law for law in LAWS if law.name == "collapse-applies-exactly"]
    assert law.check(of.complex) == Holds()


def test_free_pairs_are_in_order() -> None:
    pairs = free_pairs(closure([(0, 1, 2), (2, 3)]))
    assert [(sorted(a), sorted(b)) for a, b in pairs] == [
        ([0, 1], [0, 1, 2]),
        ([0, 2], [0, 1, 2]),
        ([1, 2], [0, 1, 2]),
        ([3], [2, 3]),
    ]
    assert free_pairs(closure([(0,)])) == ()


def test_greedy_leaves_nothing_free() -> None:
    moves, left = greedy(closure([(0, 1, 2), (2, 3), (3, 4), (2, 4)]))
    assert left == closure([(2, 3), (3, 4), (2, 4)])
    assert len(moves) == 3


def by_all_orders(k: Complex) -> bool:
    """Is there an order of collapses to a point? All are tried."""
    seen, todo = {k}, [k]
    while todo:
        now = todo.pop()
        if len(now.simplices) == 1:
            return True
        for pair in free_pairs(now):
            less = Complex(now.simplices - set(pair))
            if less not in seen:
                seen.add(less)
                todo.append(less)
    return False


def test_all_complexes_on_four_vertices() -> None:
    """By facets: every set of simplices none of which contains another. Clause: OPER-COLLAPSE-5."""
    simplices = [frozenset(s) for size in (1, 2, 3, 4) for s in combinations(range(4), size)]
    families: list[tuple[frozenset[int], ...]] = [()]
    for s in simplices:
        families += [(*f, s) for f in families if not any(t < s for t in f)]
    complexes = {closure(f) for f in families if f}
    assert len(complexes) == 166  # Dedekind's number for four, less the empty family and {∅}
    for k in complexes:
        found = collapse_to_point(k)
        assert not isinstance(found, Undecided)
        assert isinstance(found, Collapsible) == by_all_orders(k), k
        assert dimension(k) <= 3
