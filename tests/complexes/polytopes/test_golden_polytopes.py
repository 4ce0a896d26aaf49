"""Polytopes from books: their counts, kinds, duals and graphs."""

from itertools import combinations

import networkx as nx
import pytest
from golden_polytopes import (
    CROSS_POLYTOPE,
    CUBE,
    DODECAHEDRON,
    FOUR_SIMPLEX,
    GRID_TORUS,
    KLEIN_FACES,
    PROJECTIVE_PLANE,
    SEVEN_TORUS,
    TETRAHEDRON,
    TRIANGLE,
    cells,
    made,
    simplicial,
)

from clers.complexes.polytopes.cells import (
    CellList,
    Polytope,
    boundary,
    components,
    counts,
    dimension,
    euler,
    figure,
    interior,
    is_pure,
    star,
    vertices_of,
)
from clers.complexes.polytopes.construct import polytope
from clers.complexes.polytopes.definition import is_polytope
from clers.complexes.polytopes.dual import Graph, dual, dual_graph, primal_graph
from clers.complexes.polytopes.flags import flags, is_orientable
from clers.complexes.polytopes.kind import Kind, kinds
from clers.complexes.polytopes.manifold import is_manifold
from clers.complexes.polytopes.order import from_complex, order_complex, to_complex
from clers.complexes.polytopes.polygons import PolygonList, cell_list
from clers.complexes.polytopes.products import circle, cube, polygon, skeleton, times
from clers.complexes.simplicial import Complex
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtCell


def links(of: object) -> Graph:
    """A graph of networkx as links of numbers."""
    return tuple((int(a), int(b)) for a, b in nx.convert_node_labels_to_integers(of).edges)


def isomorphic(a: Graph, b: Graph) -> bool:
    """Networkx is the witness."""
    return bool(nx.is_isomorphic(nx.Graph(list(a)), nx.Graph(list(b))))


@pytest.mark.parametrize(
    ("of", "numbers", "primal", "of_dual"),
    [
        (TETRAHEDRON, (4, 6, 4), links(nx.tetrahedral_graph()), links(nx.tetrahedral_graph())),
        (CUBE, (8, 12, 6), links(nx.cubical_graph()), links(nx.octahedral_graph())),
        (DODECAHEDRON, (20, 30, 12), links(nx.dodecahedral_graph()), links(nx.icosahedral_graph())),
        (SEVEN_TORUS, (7, 21, 14), links(nx.complete_graph(7)), links(nx.heawood_graph())),
        (PROJECTIVE_PLANE, (6, 15, 10), links(nx.complete_graph(6)), links(nx.petersen_graph())),
        (FOUR_SIMPLEX, (5, 10, 10, 5), links(nx.complete_graph(5)), links(nx.complete_graph(5))),
        (
            CROSS_POLYTOPE,
            (8, 24, 32, 16),
            links(nx.complete_multipartite_graph(2, 2, 2, 2)),
            links(nx.hypercube_graph(4)),
        ),
    ],
)
def test_duals_of_books(
    of: Polytope, numbers: tuple[int, ...], primal: Graph, of_dual: Graph
) -> None:
    """Graphs named by networkx witness both. Clauses: CPLX-DUAL-1 … CPLX-DUAL-4, CPLX-GRAPH-1."""
    other = dual(of)
    assert isinstance(other, Accepted)
    assert counts(of) == numbers
    assert is_polytope(of)
    assert counts(other.value) == numbers[::-1]
    assert isomorphic((primal_graph(of)), primal)
    assert isomorphic((dual_graph(of)), of_dual)
    assert isomorphic((primal_graph(other.value)), of_dual)
    assert dual(other.value) == Accepted(of)


def test_the_grid_torus_is_its_own_dual() -> None:
    """Nine squares around nine vertices: both graphs are C3 × C3. Clause: CPLX-DUAL-4."""
    other = dual(GRID_TORUS)
    assert isinstance(other, Accepted)
    both = links(nx.cartesian_product(nx.cycle_graph(3), nx.cycle_graph(3)))
    assert counts(GRID_TORUS) == counts(other.value) == (9, 18, 9)
    assert isomorphic((primal_graph(GRID_TORUS)), both)
    assert isomorphic((primal_graph(other.value)), both)
    assert kinds(other.value) == (Kind(0, 0, True),)


@pytest.mark.parametrize(
    ("of", "kind", "genus", "crosscaps"),
    [
        (CUBE, Kind(2, 0, True), 0, 0),
        (SEVEN_TORUS, Kind(0, 0, True), 1, 0),
        (PROJECTIVE_PLANE, Kind(1, 0, False), 0, 1),
        (made(polytope(cell_list(PolygonList(KLEIN_FACES, 9)))), Kind(0, 0, False), 0, 2),
        (TRIANGLE, Kind(1, 1, True), 0, 0),
        (made(polytope(times(circle(5), cube(1)))), Kind(0, 2, True), 0, 0),
        (
            made(polytope(cell_list(PolygonList(((0, 1, 4, 3), (1, 2, 5, 4), (2, 3, 0, 5)), 6)))),
            Kind(0, 1, False),
            0,
            1,
        ),
    ],
)
def test_kinds_of_surfaces(of: Polytope, kind: Kind, genus: int, crosscaps: int) -> None:
    """Sphere, torus, projective plane, Klein bottle, disc, annulus, Möbius band: POLYMANIFOLD-5."""
    assert kinds(of) == (kind,)
    assert (kind.genus, kind.crosscaps) == (genus, crosscaps)
    assert is_orientable(of) == kind.orientable


def test_tesseract() -> None:
    """Its f-vector is 16, 32, 24, 8, and 1; its boundary a 3-sphere. Clause: CPLX-POLYTOPE-12."""
    assert counts(cube(4)) == (16, 32, 24, 8, 1)
    hull = made(polytope(skeleton(cube(4), 3)))
    assert (euler(hull), is_manifold(hull), boundary(hull)) == (0, True, frozenset())
    other = dual(hull)
    assert isinstance(other, Accepted)
    k = to_complex(other.value)
    assert k is not None
    assert counts(other.value) == (8, 24, 32, 16)
    assert isomorphic(primal_graph(other.value), links(nx.complete_multipartite_graph(2, 2, 2, 2)))
    assert to_complex(hull) is None


def test_the_cube_cell_by_cell() -> None:
    """Clauses: CPLX-CELL-1 … CPLX-CELL-4."""
    assert (dimension(CUBE), euler(CUBE), is_pure(CUBE)) == (2, 2, True)
    assert boundary(CUBE) == frozenset()
    assert len(interior(CUBE)) == 26
    assert sorted(star(CUBE, (0, 0)))[0] == (0, 0)
    assert [m for m, _ in sorted(star(CUBE, (0, 0)))] == [0, 1, 1, 1, 2, 2, 2]
    assert counts(figure(CUBE, (0, 0))) == (3, 3)
    assert figure(CUBE, (1, 0)) == CellList(2, ())
    assert vertices_of(CUBE, (2, 0)) == {0, 1, 2, 3}
    assert len(flags(CUBE)) == 48
    assert len(components(CUBE)) == 1
    assert len(order_complex(CUBE).simplices) == 26 + 72 + 48


def test_the_triangle_cell_by_cell() -> None:
    """Clause: CPLX-CELL-3."""
    assert boundary(TRIANGLE) == {(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2)}
    assert interior(TRIANGLE) == {(2, 0)}


def test_nothing_is_a_polytope() -> None:
    """No cell at all: dimension −1. Clauses: CPLX-CELL-1, CPLX-POLYTOPE-1."""
    nothing = made(polytope(CellList(0, ((), ()))))
    assert from_complex(Complex(frozenset())) == CellList(0, ())
    assert nothing == Polytope(0, ())
    assert (dimension(nothing), euler(nothing), counts(nothing)) == (-1, 0, ())
    assert dual(nothing) == Accepted(nothing)
    assert dual(made(polytope(CellList(3, ())))) == Accepted(Polytope(3, ()))


BOUNDED = (
    (TRIANGLE, Reason.HAS_BOUNDARY, (1, 0)),
    (made(polytope(cube(1))), Reason.HAS_BOUNDARY, (0, 0)),
    (made(polytope(cube(3))), Reason.HAS_BOUNDARY, (2, 0)),
    (simplicial((0, 1, 2), (2, 3, 4)), Reason.NOT_A_MANIFOLD, (0, 2)),
    (simplicial((0, 1, 2), (2, 3)), Reason.NOT_A_MANIFOLD, (0, 2)),
    (simplicial((0, 1, 2), (3,)), Reason.NOT_A_MANIFOLD, (0, 3)),
    (simplicial((0, 1), (0, 2), (0, 3)), Reason.NOT_A_MANIFOLD, (0, 0)),
    (simplicial((0, 1, 2, 3), (3, 4, 5, 6)), Reason.NOT_A_MANIFOLD, (0, 3)),
    (simplicial((0, 1), (2,)), Reason.NOT_A_MANIFOLD, (0, 2)),
    (simplicial((0, 1, 2), (0, 1, 3), (0, 1, 4)), Reason.NOT_A_MANIFOLD, (0, 0)),
)


@pytest.mark.parametrize(("of", "reason", "cell"), BOUNDED)
def test_no_dual(of: Polytope, reason: Reason, cell: tuple[int, int]) -> None:
    """Clause: CPLX-DUAL-1."""
    assert dual(of) == Rejected(reason, Clause.CPLX_DUAL_1, AtCell(*cell))
    assert is_manifold(of) == (reason is Reason.HAS_BOUNDARY)


def test_the_dual_graph_of_a_strip_is_a_path() -> None:
    """A surface with boundary has a dual graph all the same. Clause: CPLX-GRAPH-1."""
    strip = made(polytope(times(polygon(4), CellList(1, ()))))
    assert dual_graph(strip) == ()
    two = simplicial((0, 1, 2), (1, 2, 3), (2, 3, 4))
    assert dual_graph(two) == ((0, 1), (1, 2))
    assert primal_graph(two) == ((0, 1), (0, 2), (1, 2), (1, 3), (2, 3), (2, 4), (3, 4))


@pytest.mark.parametrize(
    ("of", "clause", "reason", "where"),
    [
        (cells(-1), 2, Reason.IMPOSSIBLE_COUNT, None),
        (cells(2, ((0, 2),)), 2, Reason.INDEX_OUT_OF_RANGE, (1, 0)),
        (cells(2, ((0, 1), (-1, 1))), 2, Reason.INDEX_OUT_OF_RANGE, (1, 1)),
        (cells(3, ((0, 1),), ((0, 1),)), 2, Reason.INDEX_OUT_OF_RANGE, (2, 0)),
        (cube(4), 3, Reason.UNSUPPORTED_DIMENSION, (4, 0)),
        (cells(1, ((0,),)), 4, Reason.BAD_FRONTIER, (1, 0)),
        (cells(3, ((0, 1), (0, 1, 2))), 4, Reason.BAD_FRONTIER, (1, 1)),
        (cells(3, ((0, 1), (1, 2)), ((0, 1),)), 5, Reason.BAD_FRONTIER, (2, 0)),
        (cells(2, ((0, 1), (0, 1)), ((0, 1),)), 5, Reason.BAD_FRONTIER, (2, 0)),
        (cells(3, ((0, 1), (1, 2), (0, 2)), ((0, 1, 2), ())), 5, Reason.BAD_FRONTIER, (2, 1)),
        (
            cells(6, ((0, 1), (1, 2), (0, 2), (3, 4), (4, 5), (3, 5)), (tuple(range(6)),)),
            5,
            Reason.BAD_FRONTIER,
            (2, 0),
        ),
        (
            cells(4, ((0, 1), (1, 2), (0, 2), (0, 3)), ((0, 1, 2, 3),)),
            5,
            Reason.BAD_FRONTIER,
            (2, 0),
        ),
        (
            CellList(4, (*TETRAHEDRON.cells, (frozenset([0, 1, 2]),))),
            6,
            Reason.BAD_FRONTIER,
            (3, 0),
        ),
        (
            CellList(7, (*SEVEN_TORUS.cells, (frozenset(range(14)),))),
            6,
            Reason.BAD_FRONTIER,
            (3, 0),
        ),
        (CellList(4, (*TETRAHEDRON.cells, (frozenset(),))), 6, Reason.BAD_FRONTIER, (3, 0)),
        (cells(2, ((0, 1), (0, 1))), 7, Reason.INCOHERENT_CELLS, (1, 1)),
        (
            cells(3, ((0, 1), (1, 2), (0, 2)), ((0, 1, 2), (0, 1, 2))),
            7,
            Reason.INCOHERENT_CELLS,
            (2, 1),
        ),
        # two squares that share two edges
        (
            cells(
                5, ((0, 1), (1, 2), (2, 3), (0, 3), (2, 4), (0, 4)), ((0, 1, 2, 3), (0, 1, 4, 5))
            ),
            7,
            Reason.INCOHERENT_CELLS,
            (2, 1),
        ),
        # an edge that joins two opposite vertices of a square
        (
            cells(4, ((0, 1), (1, 2), (2, 3), (0, 3), (0, 2)), ((0, 1, 2, 3),)),
            7,
            Reason.INCOHERENT_CELLS,
            (2, 0),
        ),
    ],
)
def test_rejections(
    of: CellList, clause: int, reason: Reason, where: tuple[int, int] | None
) -> None:
    """Clauses: CPLX-POLYTOPE-2 … CPLX-POLYTOPE-8."""
    answer = polytope(of)
    assert isinstance(answer, Rejected)
    assert (answer.reason, answer.clause) == (reason, Clause(f"CPLX-POLYTOPE-{clause}"))
    assert not is_polytope(of)
    if where is not None:
        assert answer.where == AtCell(*where)


def test_which_cell_is_in_the_way() -> None:
    """The detail names the earlier cell. Clause: CPLX-POLYTOPE-7."""
    answer = polytope(cells(2, ((0, 1), (0, 1))))
    assert isinstance(answer, Rejected)
    assert answer.detail == "with 1-cell 0"
    assert answer.line() == (
        "invalid: incoherent-cells at 1-cell 1 [CPLX-POLYTOPE-7]: with 1-cell 0"
    )


def test_two_spheres_that_touch_twice_are_no_frontier() -> None:
    """χ = 2 and two polygons at each edge, but no way across edges. Clause: CPLX-POLYTOPE-6.

    Two octahedra that share two opposite vertices, 0 and 1.
    """
    ring = ((2, 3), (3, 4), (4, 5), (2, 5))
    first = [(pole, a, b) for pole in (0, 1) for a, b in ring]
    both = simplicial(*first, *((pole, a + 4, b + 4) for pole, a, b in first))
    assert euler(both) == 2
    touching = CellList(both.vertices, (*both.cells, (frozenset(range(16)),)))
    assert not is_polytope(touching)
    answer = polytope(touching)
    assert answer == Rejected(Reason.BAD_FRONTIER, Clause.CPLX_POLYTOPE_6, AtCell(3, 0))


def test_a_cone_over_a_sphere_and_a_torus_is_no_manifold() -> None:
    """χ = 2, closed, but not connected: the apex is to blame. Clause: CPLX-POLYMANIFOLD-1."""
    torus = [(i, (i + a) % 7, (i + 3) % 7, 11) for i in range(7) for a in (1, 2)]
    sphere = [(*triangle, 11) for triangle in combinations(range(7, 11), 3)]
    cone = simplicial(*torus, *sphere)
    assert dual(cone) == Rejected(Reason.NOT_A_MANIFOLD, Clause.CPLX_DUAL_1, AtCell(0, 11))
    assert is_manifold(simplicial(*sphere))
    assert not is_manifold(simplicial(*torus))
