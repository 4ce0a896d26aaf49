"""Moves chosen by numbers: their order, and what is done where none applies; by hand."""

from clers.complexes.known import BALLS, SPHERES
from clers.complexes.manifolds.kind import Ball, Sphere
from clers.complexes.simplicial import Complex, closure, of_dimension
from clers.conventions.result import Accepted
from clers.operators.moves.apply import apply
from clers.operators.moves.candidates import (
    KINDS,
    chosen,
    collapses,
    contractions,
    flips,
    new_vertex,
    simplices,
    splits,
    subdivisions,
    vary,
)
from clers.operators.moves.collapse import free_pairs
from clers.operators.moves.move import Bistellar, Collapse, Contract, Split, Subdivide
from clers.operators.moves.recognise import recognise
from clers.operators.moves.split import spanning

TRIANGLE = closure([(0, 1, 2)])
SQUARE = closure([(0, 1, 2), (0, 2, 3)])
PATH = closure([(0, 1), (1, 2)])


def test_order() -> None:
    """Highest dimension first, then lexicographic."""
    assert [sorted(s) for s in simplices(PATH)] == [[0, 1], [1, 2], [0], [1], [2]]
    assert new_vertex(PATH) == 3
    assert new_vertex(closure([(7,)])) == 8
    assert new_vertex(Complex(frozenset())) == 0


def test_kinds() -> None:
    """Clauses: OPER-STELLAR-1, OPER-BISTELLAR-1, OPER-CONTRACT-1, OPER-CONTRACT-4."""
    assert list(subdivisions(PATH)) == [Subdivide((0, 1), 3), Subdivide((1, 2), 3)]
    assert list(flips(PATH)) == [
        Bistellar((0,), (1,)),
        Bistellar((1,), (0, 2)),
        Bistellar((2,), (1,)),
    ]
    assert list(contractions(PATH)) == [Contract(0, 1), Contract(1, 2)]
    assert list(collapses(PATH)) == [Collapse((0,), (0, 1)), Collapse((2,), (1, 2))]
    assert list(splits(PATH))[:2] == [Split(0, 3, ((1,),), ()), Split(1, 3, ((0,),), ())]
    assert next(splits(SQUARE)) == Split(0, 4, ((1, 2),), ((2,),))
    assert next(iter(flips(TRIANGLE))) == Bistellar((0, 1), (2,))


def test_choices() -> None:
    """The kind by the remainder, the place by the quotient; the next that applies is taken."""
    assert (contractions, flips, subdivisions, splits) == KINDS
    assert chosen(PATH, 0) == Contract(0, 1)
    assert chosen(PATH, 4) == Contract(1, 2)
    assert chosen(PATH, 8) == Contract(0, 1)
    assert chosen(PATH, 1) == Bistellar((1,), (0, 2))
    assert chosen(PATH, 9) == Bistellar((1,), (0, 2))
    assert chosen(PATH, 2) == Subdivide((0, 1), 3)
    assert chosen(PATH, 6) == Subdivide((1, 2), 3)
    assert chosen(SQUARE, 0, (contractions,)) == Contract(0, 1)
    assert chosen(SQUARE, 1, (contractions,)) == Contract(0, 3)
    assert chosen(TRIANGLE, 0) is None
    assert chosen(Complex(frozenset()), 2) is None


def test_vary() -> None:
    """Clause: OPER-MOVE-7."""
    assert vary(PATH, ()) == PATH
    assert vary(TRIANGLE, [0, 2]) == vary(TRIANGLE, [2]) != TRIANGLE
    assert vary(PATH, [0]) == closure([(0, 2)])
    assert vary(PATH, [0, 0]) == closure([(0, 2)])
    assert vary(PATH, [2], most=3) == PATH
    assert vary(PATH, [2], most=4) == closure([(0, 3), (1, 3), (1, 2)])
    assert vary(PATH, [2, 0], most=3) == closure([(0, 2)])
    assert vary(PATH, [5], kinds=(subdivisions,)) == closure([(0, 1), (1, 3), (2, 3)])
    assert len(of_dimension(vary(TRIANGLE, [2] * 20), 0)) == 12


def test_what_is_varied_stays_what_it_is() -> None:
    for seed in range(5):
        choices = [seed * 37 + i * 101 for i in range(8)]
        assert recognise(vary(SPHERES[3].complex, choices, 8)) == Sphere(3)
        assert recognise(vary(BALLS[3].complex, choices, 8)) == Ball(3)


def test_every_kind_can_apply() -> None:
    for k in (PATH, SQUARE, SPHERES[2].complex, BALLS[3].complex):
        for kind in (subdivisions, splits):
            assert any(isinstance(apply(move, k), Accepted) for move in kind(k))


def test_order_is_that_of_numbers_not_of_sets() -> None:
    """A set of 8 and 1 is walked 8 first."""
    k = closure([(1, 8), (2, 3)])
    assert [sorted(s) for s in simplices(k)] == [[1, 8], [2, 3], [1], [2], [3], [8]]
    free = [sorted(pair[0]) for pair in free_pairs(closure([(1, 8, 9)]))]
    assert free == [[1, 8], [1, 9], [8, 9]]
    assert spanning(frozenset({frozenset([8]), frozenset([1]), frozenset([2])})) == (
        (1,),
        (2,),
        (8,),
    )
