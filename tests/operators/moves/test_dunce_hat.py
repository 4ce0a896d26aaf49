"""The dunce hat does not collapse; but four expansions make a complex that collapses to a point."""

from moved import after

from clers.complexes.known import DUNCE
from clers.complexes.simplicial import dimension, of_dimension
from clers.conventions.result import Accepted
from clers.operators.moves.collapsible import NotCollapsible, Stuck, collapse_to_point
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


def test_it_does_not_collapse() -> None:
    """No simplex is free. Clause: OPER-COLLAPSE-7."""
    assert collapse_to_point(DUNCE.complex) == NotCollapsible(Stuck(()))
