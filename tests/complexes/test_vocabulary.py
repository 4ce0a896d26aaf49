"""The words of complexes in every dimension, on examples worked out by hand."""

import pytest

from clers.complexes.complex_text import read_complex, write_complex
from clers.complexes.facets import MOST_VERTICES, facets, from_facets, row, top_simplices
from clers.complexes.known import ONE_OF_EACH
from clers.complexes.neighbourhood import closed_star, valence
from clers.complexes.parts import f_vector, is_subcomplex, join, skeleton
from clers.complexes.purity import impure_at, interior, pure_boundary
from clers.complexes.simplex import are_adjacent, faces, frontier, is_incident, join_simplices
from clers.complexes.simplicial import (
    Complex,
    Simplex,
    boundary,
    closure,
    dimension,
    euler,
    is_pure,
    link,
    pieces,
    star,
)
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtFace, AtSimplex, AtVertex

X = closure([(0, 1, 2, 3), (3, 4, 5), (5, 6), (7,)])
"""The example of the page: one facet of each dimension from 3 to 0."""

EMPTY = Complex(frozenset())
LOLLIPOP = closure([(0, 1, 2), (0, 2, 3), (0, 1, 3), (0, 1, 4)])
"""The cone over a circle of three edges and a fourth edge at it."""


def s(*vertices: int) -> Simplex:
    return frozenset(vertices)


def test_faces_of_a_triangle() -> None:
    """Clause: CPLX-SIMPLEX-1."""
    edges = {s(4, 5), s(4, 6), s(5, 6)}
    points = {s(4), s(5), s(6)}
    triangle = s(4, 5, 6)
    assert faces(triangle) == edges | points | {triangle}
    assert [faces(triangle, m) for m in range(-2, 4)] == [
        *(set(), set()),
        *(points, edges, {triangle}, set()),
    ]
    assert frontier(triangle) == edges | points
    assert frontier(s(4)) == set()


def test_incident_and_adjacent() -> None:
    """Clause: CPLX-SIMPLEX-2."""
    assert is_incident(s(0, 1), s(0))
    assert not is_incident(s(0), s(0, 1))
    assert not is_incident(s(0), s(0))
    assert not is_incident(s(0, 1), s(2))
    assert not is_incident(s(0, 1), frozenset())
    assert are_adjacent(s(0, 1), s(1, 2))
    assert are_adjacent(s(0, 1), s(0, 1, 2))
    assert not are_adjacent(s(0, 1), s(0, 1))
    assert not are_adjacent(s(0, 1), s(2, 3))
    assert not are_adjacent(s(0), s(0, 1))


def test_join_of_simplices() -> None:
    """Clause: CPLX-SIMPLEX-3."""
    assert join_simplices(s(0, 2), s(1)) == Accepted(s(0, 1, 2))
    rejected = join_simplices(s(0, 3, 2), s(3, 4, 2))
    assert isinstance(rejected, Rejected)
    assert (rejected.reason, rejected.clause, rejected.where) == (
        *(Reason.SHARED_VERTEX, Clause.CPLX_SIMPLEX_3, AtVertex(2)),
    )


def test_the_empty_complex() -> None:
    """Clauses: CPLX-FACET-1, CPLX-PART-3, CPLX-PURE-1."""
    assert from_facets([]) == Accepted(EMPTY)
    assert (dimension(EMPTY), euler(EMPTY), f_vector(EMPTY)) == (-1, 0, ())
    assert (facets(EMPTY), pieces(EMPTY), top_simplices(EMPTY)) == ((), (), ())
    assert is_pure(EMPTY)
    assert impure_at(EMPTY) is None
    assert pure_boundary(EMPTY) == Accepted(EMPTY)
    assert (write_complex(EMPTY), read_complex("[]")) == ("[]\n", Accepted(EMPTY))


def test_facets_of_the_example() -> None:
    """Clauses: CPLX-FACET-2, CPLX-PART-2, CPLX-KNOWN-1."""
    assert ONE_OF_EACH.complex == X
    assert facets(X) == ((0, 1, 2, 3), (3, 4, 5), (5, 6), (7,))
    assert top_simplices(X) == (s(0, 1, 2, 3),)
    assert f_vector(X) == (8, 10, 5, 1)
    assert euler(X) == 2
    assert row(s(5, 1, 3)) == (1, 3, 5)


@pytest.mark.parametrize(
    ("rows", "reason", "at"),
    [
        ([(0, 1), ()], Reason.EMPTY_SIMPLEX, 1),
        ([(0, -1)], Reason.INDEX_OUT_OF_RANGE, 0),
        ([(0,), (1,), (2, 3, 2)], Reason.REPEATED_INDEX, 2),
        ([(-1, -1), ()], Reason.INDEX_OUT_OF_RANGE, 0),
        ([tuple(range(17))], Reason.TOO_MANY_VERTICES, 0),
        ([(3,), (-1,) * 17], Reason.TOO_MANY_VERTICES, 1),
        ([(-1,) * 16], Reason.INDEX_OUT_OF_RANGE, 0),
    ],
)
def test_rows_that_are_rejected(rows: list[tuple[int, ...]], reason: Reason, at: int) -> None:
    """Clause: CPLX-FACET-3."""
    assert from_facets(rows) == Rejected(reason, Clause.CPLX_FACET_3, AtFace(at))


def test_rows_that_are_read() -> None:
    """Clause: CPLX-FACET-3. Order and faces of others do not matter; sixteen vertices are read."""
    assert from_facets([(7,), (6, 5), (3,), (5, 4, 3), (3, 2, 1, 0), (1, 3)]) == Accepted(X)
    assert MOST_VERTICES == 16
    longest = from_facets([range(16)])
    assert isinstance(longest, Accepted)
    assert len(longest.value.simplices) == 2**16 - 1


def test_text() -> None:
    """Clause: CPLX-FACET-4."""
    assert write_complex(X) == "[[0,1,2,3],[3,4,5],[5,6],[7]]\n"
    assert read_complex(" [[7], [6,5],[3,4,5],\n[0,1,2,3]]") == Accepted(X)
    assert write_complex(closure([(10**30, 2)])) == f"[[2,{10**30}]]\n"
    assert read_complex("[[1],[1,1]]") == Rejected(
        Reason.REPEATED_INDEX, Clause.CPLX_FACET_3, AtFace(1)
    )


@pytest.mark.parametrize(
    "text",
    [
        *("", "[", "{}", "null", "[0]", "[[0.0]]", "[[1e3]]", '[["0"]]', "[[true]]", "[[0]] x"),
        *("\ud800", "[" * 100_000),
    ],
)
def test_text_that_is_rejected(text: str) -> None:
    """Clause: CPLX-FACET-4."""
    rejected = read_complex(text)
    assert isinstance(rejected, Rejected)
    assert (rejected.reason, rejected.clause, rejected.where) == (
        *(Reason.UNREADABLE_FILE, Clause.CPLX_FACET_4, WHOLE),
    )
    assert rejected.detail


def test_stars_of_the_example() -> None:
    """Clauses: CPLX-STAR-1, CPLX-STAR-2, CPLX-STAR-3."""
    assert len(star(X, s(3))) == 8 + 3
    assert link(X, s(3)) == closure([(0, 1, 2), (4, 5)])
    assert closed_star(X, s(3)) == closure([(0, 1, 2, 3), (3, 4, 5)])
    assert closed_star(X, s(5, 6)) == closure([(5, 6)])
    assert closed_star(X, s(3, 6)) == EMPTY
    assert [valence(X, s(v)) for v in range(9)] == [1, 1, 1, 2, 1, 2, 1, 1, 0]
    assert valence(X, s(3, 4)) == 1


def test_link_in_a_link() -> None:
    """Clause: CPLX-STAR-4. Edge 01 of the solid tetrahedron is opposite to edge 23."""
    assert link(link(X, s(0)), s(1)) == link(X, s(0, 1)) == closure([(2, 3)])


def test_parts_of_the_example() -> None:
    """Clause: CPLX-PART-1."""
    graph = skeleton(1, X)
    assert facets(graph) == (
        *((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)),
        *((3, 4), (3, 5), (4, 5), (5, 6), (7,)),
    )
    assert skeleton(0, X) == closure((v,) for v in range(8))
    assert skeleton(-1, X) == EMPTY
    assert skeleton(3, X) == X
    assert is_subcomplex(graph, X)
    assert not is_subcomplex(X, graph)
    assert is_subcomplex(X, X)


def test_components() -> None:
    """Clause: CPLX-PART-3."""
    assert [facets(part) for part in pieces(X)] == [facets(X)[:3], ((7,),)]


def test_join_of_two_circles() -> None:
    """Clauses: CPLX-JOIN-1, CPLX-JOIN-2. A 3-sphere of 6 vertices and 9 tetrahedra."""
    one, other = closure([(0, 1), (1, 2), (0, 2)]), closure([(3, 4), (4, 5), (3, 5)])
    whole = join(one, other)
    assert isinstance(whole, Accepted)
    assert f_vector(whole.value) == (6, 15, 18, 9)
    assert boundary(whole.value) == EMPTY
    assert facets(whole.value)[:2] == ((0, 1, 3, 4), (0, 1, 3, 5))


def test_join_of_an_edge_and_a_point() -> None:
    """Clause: CPLX-JOIN-1."""
    assert join(closure([(0, 1)]), closure([(2,)])) == Accepted(closure([(0, 1, 2)]))
    assert join(EMPTY, X) == join(X, EMPTY) == Accepted(X)
    shared = join(closure([(0, 3, 2)]), closure([(3, 4), (2, 5)]))
    assert shared == Rejected(Reason.SHARED_VERTEX, Clause.CPLX_JOIN_1, AtVertex(2))


def test_purity() -> None:
    """Clauses: CPLX-PURE-1, CPLX-PURE-2, CPLX-PURE-3."""
    assert impure_at(X) == s(3, 4, 5)
    rejected = Rejected(Reason.NOT_PURE, Clause.CPLX_PURE_2, AtSimplex((3, 4, 5)))
    assert pure_boundary(X) == rejected
    assert interior(X) == rejected
    points = closure([(0,), (4,)])
    assert impure_at(points) is None
    assert pure_boundary(points) == Accepted(EMPTY)
    assert interior(points) == Accepted(points.simplices)


def test_the_blamed_facet_is_sorted() -> None:
    """Clause: CPLX-PURE-2."""
    rejected = pure_boundary(closure([(0, 2, 3), (1, 8)]))
    assert isinstance(rejected, Rejected)
    assert rejected.where == AtSimplex((1, 8))


def test_interior_of_a_square() -> None:
    """Clause: CPLX-PURE-3."""
    square = closure([(0, 1, 2), (0, 2, 3)])
    assert pure_boundary(square) == Accepted(closure([(0, 1), (1, 2), (2, 3), (0, 3)]))
    assert interior(square) == Accepted(frozenset({s(0, 2), s(0, 1, 2), s(0, 2, 3)}))


def test_a_boundary_with_a_boundary() -> None:
    """Clause: CPLX-PURE-4. Edge 01 is in three triangles, and the boundary has one edge at 0."""
    rim = pure_boundary(LOLLIPOP)
    assert rim == Accepted(closure([(1, 2), (2, 3), (1, 3), (1, 4), (0, 4)]))
    assert boundary(closure([(1, 2), (2, 3), (1, 3), (1, 4), (0, 4)])) == closure([(0,)])
