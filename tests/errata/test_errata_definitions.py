"""ERRATUM-26 to 30: what the words of sections 5(a) and 6(a) let through, or shut out."""

from collections import Counter
from itertools import combinations

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.simplicial import Complex, closure, euler, link, of_dimension, pieces, star
from clers.conventions.reason import Reason
from clers.conventions.result import Rejected
from clers.operators.handle_table import row
from clers.operators.handles import TwoHandle

Segment = tuple[int, int]
"""A closed simplex on a line, from end to end; a vertex from itself to itself."""


def coherent_as_printed(simplices: set[Segment]) -> bool:
    """5(a): all faces are there, and of any two the closures meet in nothing or in one of them."""
    faces = all((end, end) in simplices for simplex in simplices for end in simplex)
    meets = ((max(a, c), min(b, d)) for (a, b), (c, d) in combinations(simplices, 2))
    return faces and all(low > high or (low, high) in simplices for low, high in meets)


def test_a_vertex_may_lie_inside_an_edge() -> None:
    """ERRATUM-26: an edge and a vertex in its middle pass for a complex, of another χ.

    CPLX-COMPLEX-1. Fewer than one edge and one more vertex have nothing to meet.
    """
    edge: set[Segment] = {(-1, -1), (1, 1), (-1, 1)}
    assert coherent_as_printed(edge)
    assert coherent_as_printed(edge | {(0, 0)})
    plain = closure([(-1, 1)])
    with_middle = Complex(plain.simplices | {frozenset({0})})
    assert (euler(plain), euler(with_middle)) == (1, 2)  # of one and the same point set
    assert len(pieces(with_middle)) == 2  # an abstract complex sees a point beside an edge


def star_as_printed(k: Complex, vertex: int) -> Complex:
    """5(a): the joins of a vertex with the simplices of its link, and all their faces."""
    return closure(tau | {vertex} for tau in link(k, frozenset({vertex})).simplices)


def test_the_open_star_leaves_out_its_centre() -> None:
    """ERRATUM-27: a vertex alone has an empty star, and a vertex of a sphere no open disk.

    CPLX-COMPLEX-4. An open disk has χ = 1, cells counted; the joins alone have 0.
    """
    point = closure([(0,)])
    assert not star_as_printed(point, 0).simplices
    assert star(point, frozenset({0})) == {frozenset({0})}
    sphere = closure(combinations(range(4), 3))
    joins = {tau | {0} for tau in link(sphere, frozenset({0})).simplices}
    ours = star(sphere, frozenset({0}))
    assert ours - joins == {frozenset({0})}
    assert [sum((-1) ** (len(s) - 1) for s in cells) for cells in (joins, ours)] == [0, 1]


def is_surface_as_printed(triangles: tuple[tuple[int, ...], ...]) -> bool:
    """5(a), Surfaces: each edge in one or two triangles, and the boundary does not pinch."""
    edges = Counter(edge for t in triangles for edge in combinations(sorted(t), 2))
    border = Counter(v for edge, times in edges.items() if times == 1 for v in edge)
    return max(edges.values()) <= 2 and all(times == 2 for times in border.values())


def test_an_interior_pinch_passes_for_a_surface() -> None:
    """ERRATUM-28: three triangles around a vertex and a fourth that touches it there.

    CPLX-SURFACE-1, CPLX-REJECT-8.
    """
    pinched = ((0, 1, 2), (0, 2, 3), (0, 3, 1), (0, 4, 5))
    assert is_surface_as_printed(pinched)
    refused = surface(FaceList(pinched, 6))
    assert isinstance(refused, Rejected)
    assert refused.reason is Reason.PINCHED_VERTEX


def test_no_three_triangles_have_an_interior_pinch() -> None:
    """ERRATUM-28: found by enumeration; three that hang together have seven vertices at most."""
    for size in (1, 2, 3):
        for some in combinations(combinations(range(7), 3), size):
            if is_surface_as_printed(some):
                assert not _is_pinched(some)


def _is_pinched(triangles: tuple[tuple[int, ...], ...]) -> bool:
    k = closure(triangles)
    return any(len(pieces(link(k, v))) > 1 for v in of_dimension(k, 0))


def test_m_vertices_span_dimension_m_minus_1() -> None:
    """ERRATUM-29: `any m < n vertices` give a triangle three 1-faces, of one vertex each.

    CPLX-COMPLEX-2.
    """
    n, triangle = 2, range(3)
    printed = {m: list(combinations(triangle, m)) for m in range(1, n)}
    assert printed == {1: [(0,), (1,), (2,)]}
    assert of_dimension(closure([triangle]), 1) == tuple(
        frozenset(pair) for pair in ((0, 1), (0, 2), (1, 2))
    )


def test_closing_a_curve_changes_the_euler_characteristic() -> None:
    """ERRATUM-30: M SG on a tetrahedron without a face. OPER-EFFECT-1."""
    faces = list(combinations(range(4), 3))
    assert (euler(closure(faces[:3])), euler(closure(faces))) == (1, 2)
    assert row(TwoHandle()).euler == 1
