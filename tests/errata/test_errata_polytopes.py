"""What section 5(a) says of polytopes and their duals, and where it fails."""

from itertools import combinations
from typing import Final

from clers.complexes.polytopes.cells import (
    CellList,
    Polytope,
    counts,
    euler,
    figure,
    of_dimension,
    star,
    vertices_of,
)
from clers.complexes.polytopes.construct import polytope
from clers.complexes.polytopes.dual import dual, dual_graph, reversed_incidences
from clers.complexes.polytopes.order import from_complex
from clers.complexes.polytopes.products import cube, skeleton
from clers.complexes.simplicial import closure
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtCell

TRIANGLE: Final = from_complex(closure([(0, 1, 2)]))
SEVEN_TORUS: Final = from_complex(
    closure(
        ((i, (i + a) % 7, (i + 3) % 7) for i in range(7) for a in (1, 2)),
    )
)


def accepted(given: CellList) -> Polytope:
    answer = polytope(given)
    assert isinstance(answer, Accepted), answer
    return answer.value


def test_reversing_a_triangle_gives_edges_with_one_end() -> None:
    """A boundary edge is the facet of one triangle. CPLX-DUAL-1. ERRATUM-32."""
    turned = reversed_incidences(TRIANGLE)
    assert turned.cells[0] == (frozenset([0]),) * 3
    assert polytope(turned) == Rejected(Reason.BAD_FRONTIER, Clause.CPLX_POLYTOPE_4, AtCell(1, 0))
    answer = dual(accepted(TRIANGLE))
    assert answer == Rejected(Reason.HAS_BOUNDARY, Clause.CPLX_DUAL_1, AtCell(1, 0))
    assert dual_graph(accepted(TRIANGLE)) == ()


def test_the_dual_of_a_torus_has_no_room_for_convex_cells() -> None:
    """Angles in units of π: 28 in the polygons, at most 28 at the vertices. CPLX-DUAL-2.

    ERRATUM-33. Three polygons at a vertex have angles of 2π together only if they lie in one plane.
    """
    answer = dual(accepted(SEVEN_TORUS))
    assert isinstance(answer, Accepted)
    of = answer.value
    assert counts(of) == (14, 21, 7)
    assert euler(of) == 0
    polygons = [vertices_of(of, cell) for cell in of_dimension(of, 2)]
    assert [len(polygon) for polygon in polygons] == [6] * 7
    assert all(sum(v in polygon for polygon in polygons) == 3 for v in range(14))
    assert sum(len(polygon) - 2 for polygon in polygons) == 28 == 2 * of.vertices


def test_the_link_of_a_cubes_vertex_by_joins_is_three_points() -> None:
    """No two neighbours of a vertex are joined, and yet it is in three squares. CPLX-CELL-4.

    ERRATUM-34.
    """
    of = accepted(skeleton(cube(3), 2))
    edges = {vertices_of(of, edge) for edge in of_dimension(of, 1)}
    near = {v for edge in edges if 0 in edge for v in edge - {0}}
    assert len(near) == 3
    assert not any(frozenset(pair) in edges for pair in combinations(near, 2))
    assert sum(1 for m, _ in star(of, (0, 0)) if m == 2) == 3
    assert counts(figure(of, (0, 0))) == (3, 3)
