"""Polygon lists: each rejection, orientation, stars and fans by hand."""

import pytest
from golden_polytopes import (
    CUBE,
    CUBE_FACES,
    DODECAHEDRON_FACES,
    KLEIN_FACES,
    PROJECTIVE_PLANE,
    TETRAHEDRON,
    cells,
    made,
    simplicial,
)

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.polytopes.cells import Polytope
from clers.complexes.polytopes.construct import polytope
from clers.complexes.polytopes.oriented import polygon_list
from clers.complexes.polytopes.polygons import (
    Polygon,
    PolygonList,
    cell_list,
    following,
    polygon_surface,
    sides,
)
from clers.complexes.polytopes.triangulate import fanned, starred
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtCell, AtEdge, AtFace, AtVertex, Where

HALF = ((0, 1, 2, 3),)


@pytest.mark.parametrize(
    ("faces", "vertices", "reason", "where"),
    [
        ((), 0, Reason.EMPTY_MESH, WHOLE),
        (((0, 1, 2), (0, 1, 4, 3)), 4, Reason.INDEX_OUT_OF_RANGE, AtFace(1)),
        (((0, 1, -1),), 4, Reason.INDEX_OUT_OF_RANGE, AtFace(0)),
        ((*HALF, (0, 1)), 4, Reason.REPEATED_INDEX, AtFace(1)),
        ((*HALF, (0, 1, 2, 0)), 4, Reason.REPEATED_INDEX, AtFace(1)),
        ((*HALF, (1, 0, 4), (3, 2, 1, 0)), 5, Reason.DUPLICATE_FACE, AtFace(2)),
        ((*HALF, (1, 0, 4, 5), (6, 1, 0)), 7, Reason.EDGE_WITH_THREE_FACES, AtEdge(1, 0, 2)),
        ((*HALF, (5, 4, 0, 1)), 6, Reason.EDGE_TWICE_IN_ONE_DIRECTION, AtEdge(0, 1, 1)),
        ((*HALF, (2, 4, 5, 6)), 7, Reason.PINCHED_VERTEX, AtVertex(2)),
        (HALF, 5, Reason.ISOLATED_VERTEX, AtVertex(4)),
        # two squares with two edges in common
        ((*HALF, (0, 3, 2, 4)), 5, Reason.INCOHERENT_CELLS, AtFace(1)),
    ],
)
def test_rejections_of_polygons(
    faces: tuple[Polygon, ...], vertices: int, reason: Reason, where: Where
) -> None:
    """Clause: CPLX-POLYGON-2."""
    answer = polygon_surface(PolygonList(faces, vertices))
    assert isinstance(answer, Rejected)
    assert (answer.reason, answer.clause, answer.where) == (reason, Clause.CPLX_POLYGON_2, where)


def test_a_pinch_is_counted() -> None:
    """Clause: CPLX-POLYGON-2."""
    answer = polygon_surface(PolygonList(((0, 1, 2, 3), (0, 4, 5), (0, 6, 7)), 8))
    assert isinstance(answer, Rejected)
    assert answer.detail == "its star is 3 fans"


def test_cells_of_two_polygons() -> None:
    """Edges by first appearance. Clause: CPLX-POLYGON-1."""
    two = PolygonList(((0, 1, 2, 3), (1, 0, 4)), 5)
    expected = cells(5, ((0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (4, 1)), ((0, 1, 2, 3), (0, 4, 5)))
    assert cell_list(two) == expected
    assert following(two) == (1, 2, 3, 0, 5, 6, 4)
    assert [(s.tail, s.head, s.face) for s in sides(two)][3:5] == [(3, 0, 0), (1, 0, 1)]


def test_the_cube_is_oriented_again() -> None:
    """Square 0 is 0, 1, 2, 3 from its lowest vertex; the others follow. Clause: CPLX-POLYGON-4."""
    assert polygon_list(CUBE) == Accepted(
        PolygonList(
            ((0, 1, 2, 3), (4, 7, 6, 5), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (0, 3, 7, 4)), 8
        )
    )


@pytest.mark.parametrize(
    ("of", "reason", "where"),
    [
        # the first two neighbours of face 0 meet in a face that cannot agree with both
        (PROJECTIVE_PLANE, Reason.NON_ORIENTABLE, None),
        (simplicial((0, 1, 2), (2, 3, 4)), Reason.NOT_A_MANIFOLD, AtCell(0, 2)),
        (simplicial((0, 1), (1, 2)), Reason.NOT_A_MANIFOLD, WHOLE),
        (simplicial((0, 1, 2, 3)), Reason.NOT_A_MANIFOLD, WHOLE),
    ],
)
def test_no_polygon_list(of: Polytope, reason: Reason, where: Where | None) -> None:
    """Clause: CPLX-POLYGON-4."""
    answer = polygon_list(of)
    assert isinstance(answer, Rejected)
    assert (answer.reason, answer.clause) == (reason, Clause.CPLX_POLYGON_4)
    assert where is None or answer.where == where


def test_the_polygon_that_makes_it_one_sided() -> None:
    """The lowest that cannot be oriented with those before it. Clause: CPLX-POLYGON-4."""
    klein = made(polytope(cell_list(PolygonList(KLEIN_FACES, 9))))
    answer = polygon_list(klein)
    assert isinstance(answer, Rejected)
    assert isinstance(answer.where, AtCell)
    first = PolygonList(KLEIN_FACES[: answer.where.number], 9)
    assert answer.where == AtCell(2, 6)  # the first square of the row that is glued upside down
    assert isinstance(polygon_list(used(first)), Accepted)


def used(of: PolygonList) -> Polytope:
    """The polytope of a polygon list without the vertices that no polygon names."""
    names = sorted({v for face in of.faces for v in face})
    faces = tuple(tuple(names.index(v) for v in face) for face in of.faces)
    return made(polytope(cell_list(PolygonList(faces, len(names)))))


def test_a_square_starred_and_fanned() -> None:
    """Clauses: CPLX-POLYGON-5, CPLX-POLYGON-6."""
    square = PolygonList(((2, 3, 0, 1),), 4)
    assert starred(square) == FaceList(((2, 3, 4), (3, 0, 4), (0, 1, 4), (1, 2, 4)), 5)
    assert fanned(square) == FaceList(((0, 1, 2), (0, 2, 3)), 4)


@pytest.mark.parametrize(
    ("of", "stars", "fans"),
    [(CUBE_FACES, (24, 14), (12, 8)), (DODECAHEDRON_FACES, (60, 32), (36, 20))],
)
def test_solids_triangulated(
    of: PolygonList, stars: tuple[int, int], fans: tuple[int, int]
) -> None:
    """Triangles and vertices: Σk and n + F, Σ(k − 2) and n. CPLX-POLYGON-5, CPLX-POLYGON-6."""
    assert (len(starred(of).faces), starred(of).vertices) == stars
    assert (len(fanned(of).faces), fanned(of).vertices) == fans
    assert isinstance(surface(starred(of)), Accepted)
    assert isinstance(surface(fanned(of)), Accepted)


def test_fans_of_incoherent_polygons_meet() -> None:
    """Two squares with two edges in common, and the same diagonal. Clause: CPLX-POLYGON-7."""
    doublet = PolygonList(((0, 1, 2, 3), (0, 3, 2, 4)), 5)
    answer = surface(fanned(doublet))
    assert isinstance(answer, Rejected)
    assert answer.reason is Reason.DUPLICATE_FACE
    assert isinstance(surface(starred(doublet)), Accepted)


def test_triangles_are_fanned_to_themselves() -> None:
    """Clause: CPLX-POLYGON-6."""
    listed = polygon_list(TETRAHEDRON)
    assert isinstance(listed, Accepted)
    assert fanned(listed.value).faces == listed.value.faces
