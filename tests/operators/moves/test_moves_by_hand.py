"""Each move on complexes of a few simplices, and each of its rejections; worked out by hand."""

import pytest
from moved import BAD, after, at, pair, refusal

from clers.complexes.simplicial import Complex, closure
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted
from clers.conventions.where import Where
from clers.operators.moves.apply import apply, inverse, replay
from clers.operators.moves.effect import effect
from clers.operators.moves.move import (
    Bistellar,
    Collapse,
    Contract,
    Expand,
    Move,
    Split,
    Subdivide,
    Weld,
)

Facets = tuple[tuple[int, ...], ...]

TRIANGLE: Facets = ((0, 1, 2),)
SQUARE: Facets = ((0, 1, 2), (0, 2, 3))
TETRAHEDRON: Facets = ((0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3))
BIPYRAMID: Facets = ((0, 1, 3), (1, 2, 3), (0, 2, 3), (0, 1, 4), (1, 2, 4), (0, 2, 4))
OCTAHEDRON: Facets = tuple((a, b, c) for a in (0, 1) for b in (2, 3) for c in (4, 5))
PATH: Facets = ((0, 1), (1, 2))
CIRCLE: Facets = ((0, 1), (1, 2), (0, 2))

APPLIES: tuple[tuple[Facets, Move, Facets, tuple[int, ...]], ...] = (
    # the tutorial's KEV, KTE, MEV, MTE
    (PATH, Collapse((2,), (1, 2)), ((0, 1),), (-1, -1)),
    (TRIANGLE, Collapse((0, 1), (0, 1, 2)), ((0, 2), (1, 2)), (0, -1, -1)),
    (((0, 1),), Expand((2,), (1, 2)), PATH, (1, 1)),
    (((0, 2), (1, 2)), Expand((0, 1), (0, 1, 2)), TRIANGLE, (0, 1, 1)),
    (((0, 1, 2, 3),), Collapse((0, 1, 2), (0, 1, 2, 3)), TETRAHEDRON[1:], (0, 0, -1, -1)),
    # a free face of a tetrahedron in the middle of nothing, and its vertex once it is alone
    (((0, 1),), Collapse((0,), (0, 1)), ((1,),), (-1, -1)),
    # subdivisions: a face, an edge with two faces, an edge alone, a vertex (its name)
    (TRIANGLE, Subdivide((0, 1, 2), 9), ((0, 1, 9), (0, 2, 9), (1, 2, 9)), (1, 3, 2)),
    (
        SQUARE,
        Subdivide((0, 2), 9),
        ((0, 1, 9), (1, 2, 9), (0, 3, 9), (2, 3, 9)),
        (1, 3, 2),
    ),
    (PATH, Subdivide((0, 1), 3), ((0, 3), (1, 3), (1, 2)), (1, 1)),
    (PATH, Subdivide((1,), 9), ((0, 9), (2, 9)), ()),
    (BIPYRAMID, Weld((0, 1, 2), 4), TETRAHEDRON, (-1, -3, -2)),
    (PATH, Weld((0, 2), 1), ((0, 2),), (-1, -1)),
    (PATH, Weld((9,), 0), ((1, 2), (1, 9)), ()),
    # bistellar moves in dimension 1, 2 and 3
    (PATH, Bistellar((0, 1), (3,)), ((0, 3), (1, 3), (1, 2)), (1, 1)),
    (PATH, Bistellar((1,), (0, 2)), ((0, 2),), (-1, -1)),
    (SQUARE, Bistellar((0, 2), (1, 3)), ((0, 1, 3), (1, 2, 3)), ()),
    (BIPYRAMID, Bistellar((4,), (0, 1, 2)), TETRAHEDRON, (-1, -3, -2)),
    (
        ((0, 1, 2, 3), (0, 1, 2, 4)),
        Bistellar((0, 1, 2), (3, 4)),
        ((0, 1, 3, 4), (0, 2, 3, 4), (1, 2, 3, 4)),
        (0, 1, 2, 1),
    ),
    (
        ((0, 1, 2, 3),),
        Bistellar((0, 1, 2, 3), (4,)),
        ((0, 1, 2, 4), (0, 1, 3, 4), (0, 2, 3, 4), (1, 2, 3, 4)),
        (1, 4, 6, 3),
    ),
    (((5,),), Bistellar((5,), (7,)), ((7,),), ()),
    # a vertex under another name: no number changes
    (((0, 2, 7),), Weld((1,), 0), ((1, 2, 7),), ()),
    (((0, 2, 7),), Subdivide((2,), 3), ((0, 3, 7),), ()),
    # contractions: of a path, of a square of edges, of an edge at the boundary, of one inside
    (PATH, Contract(0, 1), ((0, 2),), (-1, -1)),
    (((0, 1), (1, 2), (2, 3), (0, 3)), Contract(3, 0), ((1, 2), (2, 3), (1, 3)), (-1, -1)),
    (SQUARE, Contract(0, 1), ((0, 2, 3),), (-1, -2, -1)),
    (BIPYRAMID, Contract(0, 4), TETRAHEDRON, (-1, -3, -2)),
    (
        OCTAHEDRON,
        Contract(0, 2),
        ((0, 3, 4), (0, 3, 5), (0, 1, 4), (0, 1, 5), (1, 3, 4), (1, 3, 5)),
        (-1, -3, -2),
    ),
    # splits: new ends of a path, a new face at the boundary, a vertex of degree three
    (((0, 2),), Split(0, 1, ((2,),), ()), PATH, (1, 1)),
    (((0, 2), (1, 2)), Split(1, 3, (), ()), ((0, 2), (1, 2), (1, 3)), (1, 1)),
    (((0, 2, 3),), Split(0, 1, ((2,),), ((2,),)), SQUARE, (1, 2, 1)),
    (
        TETRAHEDRON,
        Split(0, 4, ((1, 2),), ((1,), (2,))),
        ((0, 1, 3), (1, 2, 3), (0, 2, 3), (0, 1, 4), (1, 2, 4), (0, 2, 4)),
        (1, 3, 2),
    ),
)


@pytest.mark.parametrize(("facets", "move", "result", "change"), APPLIES)
def test_move(facets: Facets, move: Move, result: Facets, change: tuple[int, ...]) -> None:
    """Clauses: OPER-MOVE-1, OPER-COLLAPSE-4, OPER-BISTELLAR-1; and those of each move."""
    k = closure(facets)
    assert after(k, move) == closure(result)
    assert after(closure(result), inverse(move, k)) == k
    assert effect(move, k) == change


M, P = Reason.MISSING_SIMPLEX, Reason.PRESENT_SIMPLEX
W, L, F = Reason.WRONG_LINK, Reason.LINK_CONDITION, Reason.NOT_FREE
C1, C3 = Clause.OPER_COLLAPSE_1, Clause.OPER_COLLAPSE_3
S1, S2, B1 = Clause.OPER_STELLAR_1, Clause.OPER_STELLAR_2, Clause.OPER_BISTELLAR_1
K1, K4, K5 = Clause.OPER_CONTRACT_1, Clause.OPER_CONTRACT_4, Clause.OPER_CONTRACT_5

BOOK: Facets = ((0, 1, 2), (0, 1, 3), (0, 1, 4))
ANNULUS: Facets = ((0, 1, 3), (1, 3, 4), (1, 2, 4), (2, 4, 5), (0, 2, 5), (0, 3, 5))

REFUSED: tuple[tuple[Move, Facets, tuple[Reason, Clause, Where]], ...] = (
    (Collapse((), (0,)), TRIANGLE, BAD),
    (Collapse((0,), (0,)), TRIANGLE, BAD),
    (Collapse((0,), (0, 1, 2)), TRIANGLE, BAD),
    (Collapse((0,), (1, 2)), TRIANGLE, BAD),
    (Collapse((0, 1), (1, 2)), TRIANGLE, BAD),
    (Collapse((1, 0), (0, 1, 2)), TRIANGLE, BAD),
    (Collapse((0,), (1, 0)), TRIANGLE, BAD),
    (Collapse((0, 0), (0, 0, 1)), TRIANGLE, BAD),
    (Collapse((0,), (-1, 0)), TRIANGLE, BAD),
    (Collapse((0, 3), (0, 1, 3)), TRIANGLE, (M, C1, at(0, 3))),
    (Collapse((0, 1), (0, 1, 3)), TRIANGLE, (M, C1, at(0, 1, 3))),
    (Collapse((0,), (0, 1)), TRIANGLE, (F, C1, at(0, 2))),
    (Collapse((0, 1), (0, 1, 3)), BOOK, (F, C1, at(0, 1, 2))),
    (Collapse((1,), (1, 2)), PATH, (F, C1, at(0, 1))),
    (Expand((0,), (0, 1, 2)), PATH, BAD),
    (Expand((2, 0), (0, 1, 2)), PATH, BAD),
    (Expand((3,), (2, 3)), ((0, 1),), (M, C3, at(2))),
    (Expand((0, 2), (0, 1, 2)), ((0, 1), (2,)), (M, C3, at(1, 2))),
    (Expand((0, 1), (0, 1, 2)), CIRCLE, (P, C3, at(0, 1))),
    (Expand((0, 1), (0, 1, 2)), TRIANGLE, (P, C3, at(0, 1))),
    (Subdivide((), 5), TRIANGLE, BAD),
    (Subdivide((0, 1), -1), TRIANGLE, BAD),
    (Subdivide((0, 3), 5), TRIANGLE, (M, S1, at(0, 3))),
    (Subdivide((0, 1), 2), TRIANGLE, (P, S1, at(2))),
    (Weld((1, 0), 2), TRIANGLE, BAD),
    (Weld((0, 1), -1), TRIANGLE, BAD),
    (Weld((0, 1), 5), PATH, (M, S2, at(5))),
    (Weld((0, 1), 2), CIRCLE, (P, S2, at(0, 1))),
    (Weld((0, 3), 1), PATH, (W, S2, at(3))),
    (Weld((0, 2), 1), ((0, 1), (1, 2), (1, 3)), (W, S2, at(0, 3))),
    (Weld((1, 3), 0), ((0, 1, 2), (0, 3)), (W, S2, at(2, 3))),
    (Bistellar((0, 2), (3, 1)), SQUARE, BAD),
    (Bistellar((), (3,)), SQUARE, BAD),
    (Bistellar((1, 3), (0, 2)), SQUARE, (M, B1, at(1, 3))),
    (Bistellar((0, 2), (1, 3)), (*SQUARE, (1, 3)), (P, B1, at(1, 3))),
    (Bistellar((0, 2), (1, 4)), SQUARE, (W, B1, at(3))),
    (Bistellar((0, 2), (4,)), SQUARE, (W, B1, at(1))),
    (Bistellar((0, 1), (2, 4)), BOOK, (W, B1, at(3))),
    (Bistellar((0,), (1, 3)), SQUARE, (W, B1, at(2))),
    (Contract(1, 1), TRIANGLE, BAD),
    (Contract(-1, 0), TRIANGLE, BAD),
    (Contract(0, -1), TRIANGLE, BAD),
    (Contract(0, 3), SQUARE[:1], (M, K1, at(0, 3))),
    (Contract(3, 1), SQUARE, (M, K1, at(1, 3))),
    # a circle of three edges, a sphere of four faces: nothing shorter is a circle, a sphere
    (Contract(0, 1), CIRCLE, (L, K1, pair((0, 1), (2,)))),
    (Contract(2, 1), TETRAHEDRON, (L, K1, pair((1, 2), (0, 3)))),
    # a triangle without a face around the bipyramid
    (Contract(0, 1), BIPYRAMID, (L, K1, pair((0, 1), (2,)))),
    # boundaries: an edge alone, a face alone, across a strip, across an annulus
    (Contract(0, 1), ((0, 1),), (L, K1, at(0, 1))),
    (Contract(0, 1), TRIANGLE, (L, K1, at(0, 1))),
    (Contract(0, 2), SQUARE, (L, K1, at(0, 2))),
    (Contract(1, 3), ANNULUS, (L, K1, at(1, 3))),
    # the two sides of one boundary curve of three edges; here the third vertex is to blame
    (Contract(0, 1), ANNULUS, (L, K1, pair((0, 1), (2,)))),
    # a hair on a triangle cannot be contracted away, nor a triangle grow one
    (Contract(0, 3), ((0, 1, 2), (0, 3)), (W, K5, at(0))),
    (Contract(3, 0), ((0, 1, 2), (0, 3)), (W, K5, at(3))),
    (Split(0, 3, (), ()), TRIANGLE, (W, K5, at(0))),
    (Split(-1, 3, (), ()), TRIANGLE, BAD),
    (Split(0, -3, (), ()), TRIANGLE, BAD),
    (Split(0, 3, ((),), ()), TRIANGLE, BAD),
    (Split(0, 3, ((1,),), ((2, 1),)), TRIANGLE, BAD),
    (Split(0, 3, ((0, 1),), ()), TRIANGLE, BAD),
    (Split(0, 3, ((1,),), ((0,),)), TRIANGLE, BAD),
    (Split(4, 3, (), ()), TRIANGLE, (M, K4, at(4))),
    (Split(0, 4, ((1, 3),), ()), SQUARE, (M, K4, at(0, 1, 3))),
    (Split(0, 2, ((1,),), ()), TRIANGLE, (P, K4, at(2))),
    (Split(0, 0, (), ()), TRIANGLE, (P, K4, at(0))),
    # L outside D; a face of what stays, in D and not in L; the same two ways with more to blame
    (Split(0, 3, ((1,),), ((2,),)), TRIANGLE, (W, K4, at(1))),
    (Split(0, 3, (), ((2,),)), TRIANGLE, (W, K4, at(2))),
    (Split(0, 4, ((1,),), ()), TETRAHEDRON, (W, K4, at(1))),
    (Split(0, 4, ((1, 2),), ((2,),)), TETRAHEDRON, (W, K4, at(1))),
    # all of the link moves and all of it is shared: a solid where a surface was
    (
        Split(0, 4, ((1, 2), (1, 3), (2, 3)), ((1,), (2,), (3,))),
        TETRAHEDRON,
        (W, K5, at(0)),
    ),
    # an edge that becomes a circle's chord
    (Split(0, 3, (), ()), CIRCLE, (W, K5, at(0))),
    (Split(0, 1, (), ()), ((0,),), (L, K1, at(0, 1))),
)


@pytest.mark.parametrize(("move", "facets", "expected"), REFUSED)
def test_refusal(move: Move, facets: Facets, expected: tuple[Reason, Clause, Where]) -> None:
    """Clauses: OPER-MOVE-2, OPER-MOVE-3, OPER-CONTRACT-5; and those named in the rejections."""
    assert refusal(move, *facets) == expected


def test_the_first_rejection_ends_a_list() -> None:
    """Clause: OPER-MOVE-4."""
    k = closure(PATH)
    good, bad, worse = Collapse((2,), (1, 2)), Collapse((2,), (1, 2)), Contract(0, 0)
    assert replay((good, bad, worse), k) == apply(bad, closure(((0, 1),)))
    assert replay((), k) == Accepted(k)


def test_a_hair_is_blamed_at_its_root() -> None:
    """The hair's end has a point for its link, which is a ball, but not of dimension 1."""
    assert refusal(Contract(3, 0), (0, 1, 2), (0, 3))[2] == at(3)


def test_moves_on_nothing() -> None:
    """The empty complex has no simplex to move, and a vertex joined to nothing is no expansion."""
    nothing = Complex(frozenset())
    for move in (Collapse((0,), (0, 1)), Subdivide((0,), 1), Weld((1,), 0), Contract(0, 1)):
        result = apply(move, nothing)
        assert not isinstance(result, Accepted)
        assert result.reason is Reason.MISSING_SIMPLEX
