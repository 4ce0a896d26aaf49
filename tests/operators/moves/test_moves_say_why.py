"""Rejected moves in one line, as they are printed."""

import pytest
from moved import Simplices

from clers.complexes.simplicial import closure
from clers.conventions.result import Rejected
from clers.operators.moves.apply import apply
from clers.operators.moves.move import Bistellar, Collapse, Contract, Move, Split, Subdivide

LINES: tuple[tuple[Move, Simplices, str], ...] = (
    (
        Collapse((1, 0), (0, 1, 2)),
        ((0, 1, 2),),
        "malformed: bad-operand of the whole input [OPER-MOVE-2]: "
        "(1, 0) is not a list of vertices from 0 in increasing order",
    ),
    (
        Collapse((0,), (0, 1, 2)),
        ((0, 1, 2),),
        "malformed: bad-operand of the whole input [OPER-MOVE-2]: "
        "(0, 1, 2) is not (0,) and one vertex more",
    ),
    (
        Collapse((1, 0), (2, 1, 0)),
        ((0, 1, 2),),
        "malformed: bad-operand of the whole input [OPER-MOVE-2]: "
        "(1, 0) is not a list of vertices from 0 in increasing order",
    ),
    (
        Contract(-1, -2),
        ((0, 1, 2),),
        "malformed: bad-operand of the whole input [OPER-MOVE-2]: "
        "(-1,) is not a list of vertices from 0 in increasing order",
    ),
    (
        Subdivide((1, 0), -2),
        ((0, 1, 2),),
        "malformed: bad-operand of the whole input [OPER-MOVE-2]: "
        "(1, 0) is not a list of vertices from 0 in increasing order",
    ),
    (
        Bistellar((1, 0), (3, 2)),
        ((0, 1, 2),),
        "malformed: bad-operand of the whole input [OPER-MOVE-2]: "
        "(1, 0) is not a list of vertices from 0 in increasing order",
    ),
    (
        Contract(2, 2),
        ((0, 1, 2),),
        "malformed: bad-operand of the whole input [OPER-MOVE-2]: an edge has two ends",
    ),
    (
        Split(0, 3, ((0, 1),), ()),
        ((0, 1, 2),),
        "malformed: bad-operand of the whole input [OPER-MOVE-2]: vertex 0 is not in its own link",
    ),
    (
        Subdivide((0, 5), 7),
        ((0, 1, 2),),
        "invalid: missing-simplex at simplex {0, 5} [OPER-STELLAR-1]",
    ),
    (
        Contract(0, 1),
        ((0, 1, 2),),
        "invalid: link-condition at simplex {0, 1} [OPER-CONTRACT-1]: "
        "the boundary would be pinched, or would be too short",
    ),
    (
        Contract(1, 0),
        ((0, 1), (1, 2), (0, 2)),
        "invalid: link-condition at simplices {0, 1} and {2} [OPER-CONTRACT-1]",
    ),
    (
        Contract(0, 3),
        ((0, 1, 2), (0, 3)),
        "invalid: wrong-link at simplex {0} [OPER-CONTRACT-5]: "
        "its link is no ball or sphere of dimension 1",
    ),
)


@pytest.mark.parametrize(("move", "facets", "line"), LINES)
def test_line(move: Move, facets: Simplices, line: str) -> None:
    """Clauses: OPER-MOVE-2, OPER-CONTRACT-5."""
    result = apply(move, closure(facets))
    assert isinstance(result, Rejected)
    assert result.line() == line
