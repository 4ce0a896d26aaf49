"""The dunce hat does not collapse; but four expansions make a complex that collapses to a point."""

from moved import after

from clers.complexes.known import DUNCE
from clers.complexes.simplicial import Complex, closure, dimension, of_dimension
from clers.conventions.result import Accepted
from clers.operators.moves.collapsible import (
    Collapsible,
    NotCollapsible,
    Stuck,
    Undecided,
    collapse_to_point,
)
from clers.operators.moves.move import Collapse, Expand
from clers.operators.moves.text import read

EXPANSIONS = (
    "expand 4 7 / 4 5 7; expand 2 4 5 / 0 2 4 5; expand 4 6 / 2 4 6; expand 1 6 7 / 0 1 6 7"
)

COLLAPSES = """
collapse 0 1 7 / 0 1 6 7; collapse 0 2 4 / 0 2 4 5
collapse 0 4 / 0 4 5; collapse 0 5 / 0 2 5; collapse 4 6 / 2 4 6; collapse 0 7 / 0 6 7
collapse 0 2 / 0 2 3; collapse 0 3 / 0 1 3; collapse 4 7 / 4 5 7; collapse 0 6 / 0 1 6
collapse 2 3 / 2 3 7; collapse 1 3 / 1 3 4; collapse 3 4 / 3 4 5; collapse 3 5 / 3 5 7
collapse 4 5 / 2 4 5; collapse 2 4 / 1 2 4; collapse 2 5 / 2 5 6; collapse 2 7 / 1 2 7
collapse 5 6 / 5 6 7; collapse 1 2 / 1 2 6; collapse 1 6 / 1 6 7
collapse 5 / 5 7; collapse 4 / 1 4; collapse 0 / 0 1; collapse 2 / 2 6; collapse 3 / 3 7
collapse 6 / 6 7; collapse 1 / 1 7
"""


def test_it_is_contractible() -> None:
    """Found by chance, and replayed. Clauses: OPER-COLLAPSE-1, OPER-COLLAPSE-3, OPER-MOVE-8."""
    up, down = read(EXPANSIONS), read(COLLAPSES)
    assert isinstance(up, Accepted)
    assert isinstance(down, Accepted)
    assert all(isinstance(move, Expand) for move in up.value)
    assert all(isinstance(move, Collapse) for move in down.value)
    grown = after(DUNCE.complex, *up.value)
    assert dimension(grown) == 3
    assert len(of_dimension(grown, 3)) == 2
    assert after(grown, *down.value).simplices == {frozenset([7])}


RENAMED = {1: 4, 6: 5, 7: 6, 2: 7, 4: 8, 5: 9, 0: 10, 3: 11}
"""So that the free walls added last are the first to be tried: they lead back to the hat."""


def test_the_search_goes_back_from_the_hat() -> None:
    """One tetrahedron more is collapsed first, and must stay so. Clause: OPER-COLLAPSE-6."""
    up = read(EXPANSIONS)
    assert isinstance(up, Accepted)
    grown = after(DUNCE.complex, *up.value)
    renamed = frozenset(frozenset(RENAMED[v] for v in s) for s in grown.simplices)
    k = Complex(renamed | closure([(1, 2, 3, 4)]).simplices)
    found = collapse_to_point(k)
    assert isinstance(found, Collapsible)
    assert len(after(k, *found.moves).simplices) == 1
    # the third collapse leads to the hat, and another in its place does not
    assert collapse_to_point(k, 3) == Undecided(3)
    assert collapse_to_point(k, 4) == found
    assert [move.coface for move in found.moves[:2]] == [(1, 2, 3, 4), (4, 5, 6, 10)]


def test_it_does_not_collapse() -> None:
    """No simplex is free. Clause: OPER-COLLAPSE-7."""
    assert collapse_to_point(DUNCE.complex) == NotCollapsible(Stuck(()))
