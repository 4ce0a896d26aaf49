"""Components, curves, genus and homology of meshes whose numbers are in every book."""

import pytest
from golden_complexes import (
    ANNULUS,
    BAND,
    DOUBLE_TORUS,
    KLEIN_BOTTLE,
    MOEBIUS_5,
    OCTAHEDRON,
    PROJECTIVE_PLANE_6,
    SQUARE,
    TETRAHEDRON,
    TORUS_7,
    TORUS_9,
    TRIANGLE,
    TWO_AT_A_VERTEX,
    accepted,
    beside,
)

from clers.complexes.definition import is_orientable, is_surface
from clers.complexes.face_list import FaceList
from clers.complexes.homology import Field, betti, coherent_chains, rank_over_gf2, rank_over_q
from clers.complexes.simplicial import (
    boundary,
    closure,
    euler,
    is_arc,
    is_circle,
    link,
    pieces,
    star,
)
from clers.complexes.surface import BORDER, Corner, Face, face_of, next_corner, previous_corner
from clers.complexes.topology import (
    Component,
    component_of_faces,
    components,
    curve_at,
    curves,
)

# name, face list, vertices, edges, faces, boundary edges, curves, genus
CLASSIFIED: tuple[tuple[str, FaceList, tuple[int, int, int, int, int, int]], ...] = (
    ("triangle", TRIANGLE, (3, 3, 1, 3, 1, 0)),
    ("square", SQUARE, (4, 5, 2, 4, 1, 0)),
    ("tetrahedron", TETRAHEDRON, (4, 6, 4, 0, 0, 0)),
    ("octahedron", OCTAHEDRON, (6, 12, 8, 0, 0, 0)),
    ("band", BAND, (6, 12, 6, 6, 2, 0)),
    ("torus of 7 vertices", TORUS_7, (7, 21, 14, 0, 0, 1)),
    ("torus of 9 vertices", TORUS_9, (9, 27, 18, 0, 0, 1)),
    ("double torus", DOUBLE_TORUS, (13, 45, 30, 0, 0, 2)),
)


@pytest.mark.parametrize(
    ("given", "counts"), [row[1:] for row in CLASSIFIED], ids=[row[0] for row in CLASSIFIED]
)
def test_component_is_counted(given: FaceList, counts: tuple[int, int, int, int, int, int]) -> None:
    """Clauses: CPLX-COMPONENT-2, CPLX-COMPONENT-3."""
    vertices, edges, faces, border, loops, genus = counts
    chi = 2 - 2 * genus - loops
    assert chi == vertices - edges + faces
    expected = Component(Face(0), faces, vertices, edges, border, loops, genus, chi)
    assert components(accepted(given)) == (expected,)


@pytest.mark.parametrize(
    ("given", "over_gf2", "over_q"),
    [
        (TRIANGLE, (1, 0, 0), (1, 0, 0)),
        (TETRAHEDRON, (1, 0, 1), (1, 0, 1)),
        (BAND, (1, 1, 0), (1, 1, 0)),
        (TORUS_7, (1, 2, 1), (1, 2, 1)),
        (DOUBLE_TORUS, (1, 4, 1), (1, 4, 1)),
        (beside(TETRAHEDRON, TORUS_7), (2, 2, 2), (2, 2, 2)),
        (MOEBIUS_5, (1, 1, 0), (1, 1, 0)),
        (PROJECTIVE_PLANE_6, (1, 1, 1), (1, 0, 0)),
        (KLEIN_BOTTLE, (1, 2, 1), (1, 1, 0)),
        (TWO_AT_A_VERTEX, (1, 0, 2), (1, 0, 2)),
    ],
)
def test_betti_numbers(given: FaceList, over_gf2: tuple[int, ...], over_q: tuple[int, ...]) -> None:
    """Clauses: CPLX-HOMOLOGY-1, CPLX-HOMOLOGY-2. The textbook's values, one-sided surfaces too."""
    assert betti(closure(given.faces), Field.GF2) == over_gf2
    assert betti(closure(given.faces), Field.Q) == over_q


def test_ranks_by_hand() -> None:
    """Clause: CPLX-HOMOLOGY-1. The last row is half the first, and the pivots are not ±1."""
    rows = [{0: 2, 1: 6}, {0: 3, 2: 5}, {0: 1, 1: 3}]
    assert rank_over_q(rows) == 2
    assert rank_over_q([{0: 2, 1: 6}, {0: 1, 1: 2}]) == 2
    # modulo 2 they are 0, 1 0 1 and 1 1 0
    assert rank_over_gf2(rows) == 2
    assert rank_over_gf2([{0: 2, 1: 6}, {0: 1, 1: 2}]) == 1


def test_homology_in_other_dimensions() -> None:
    """Clause: CPLX-HOMOLOGY-1. A circle, two points, a solid tetrahedron, nothing at all."""
    for field in Field:
        assert betti(closure([(0, 1), (1, 2), (2, 0)]), field) == (1, 1)
        assert betti(closure([(0,), (5,)]), field) == (2,)
        assert betti(closure([(0, 1, 2, 3)]), field) == (1, 0, 0, 0)
        assert betti(closure([]), field) == ()


@pytest.mark.parametrize("given", [MOEBIUS_5, PROJECTIVE_PLANE_6, KLEIN_BOTTLE])
def test_one_sided_surfaces(given: FaceList) -> None:
    """Clauses: CPLX-SURFACE-1, CPLX-ORIENT-1, CPLX-ORIENT-2. Surfaces, but not orientable ones."""
    k = closure(given.faces)
    assert is_surface(k)
    assert not is_orientable(given)
    assert (coherent_chains(k, Field.Q), coherent_chains(k, Field.GF2)) == (0, 1)


def test_two_sided_surfaces() -> None:
    """Clauses: CPLX-ORIENT-1, CPLX-ORIENT-2."""
    k = closure(beside(TETRAHEDRON, BAND).faces)
    assert (coherent_chains(k, Field.Q), coherent_chains(k, Field.GF2)) == (2, 2)


def test_star_and_link_of_the_band() -> None:
    """Clauses: CPLX-COMPLEX-3, CPLX-COMPLEX-4, CPLX-COMPLEX-5: what 3.1 says of the band."""
    k = closure(BAND.faces)
    one = frozenset([1])
    assert euler(k) == 0
    assert sum(len(s) == 3 for s in star(k, one)) == 3
    assert link(k, one) == closure([(0, 3), (3, 4), (4, 2)])
    assert boundary(k) == closure([(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3)])


def test_circles_and_arcs() -> None:
    """Clause: CPLX-SURFACE-1."""
    circle = closure([(0, 1), (1, 2), (2, 0)])
    arc = closure([(0, 1), (1, 2)])
    others = (
        closure([]),
        closure([(0,)]),
        closure([(0, 1, 2)]),
        closure([(0, 1), (2, 3)]),
        closure([(0, 1), (0, 2), (0, 3)]),
        closure([(0, 1), (1, 2), (2, 0), (2, 3)]),
        closure([(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3)]),
    )
    assert (is_circle(circle), is_arc(circle)) == (True, False)
    assert (is_circle(arc), is_arc(arc)) == (False, True)
    assert not any(is_circle(k) or is_arc(k) for k in others)


def test_corners_of_one_triangle() -> None:
    """Clauses: CPLX-CORNER-1, CPLX-CORNER-2."""
    only = accepted(TRIANGLE)
    assert only.opposite == (BORDER, BORDER, BORDER)
    corners = [Corner(3), Corner(4), Corner(5)]
    assert [next_corner(c) for c in corners] == [4, 5, 3]
    assert [previous_corner(c) for c in corners] == [5, 3, 4]
    assert [face_of(c) for c in corners] == [1, 1, 1]


def test_curves_begin_at_their_lowest_corner() -> None:
    """Clauses: CPLX-CURVE-1, CPLX-CURVE-2, CPLX-CURVE-3."""
    (curve,) = curves(accepted(TRIANGLE))
    assert (curve.vertices, curve.corners) == ((1, 2, 0), (0, 1, 2))
    (rim,) = curves(accepted(SQUARE))  # borders: 1 → 2 of corner 0, 0 → 1 of 2, 2 → 3, 3 → 0
    assert (rim.vertices, rim.corners) == ((1, 2, 3, 0), (0, 3, 4, 2))
    other = curve_at(accepted(SQUARE), Corner(4))
    assert (other.vertices, other.corners) == ((3, 0, 1, 2), (4, 2, 0, 3))


def test_components_by_lowest_face() -> None:
    """Clause: CPLX-COMPONENT-1."""
    apart = beside(TRIANGLE, TETRAHEDRON)
    mixed = FaceList((*apart.faces[1:3], apart.faces[0], *apart.faces[3:]), apart.vertices)
    of = accepted(mixed)
    assert component_of_faces(of) == (0, 0, 1, 0, 0)
    assert [(c.lowest, c.faces, c.curves) for c in components(of)] == [(0, 4, 0), (2, 1, 1)]


def test_pieces_of_the_annulus() -> None:
    """Clause: CPLX-COMPLEX-6. Vertex 2, which no face names, is not in the closure."""
    k = closure(ANNULUS.faces)
    assert len(pieces(k)) == 1
    assert len(pieces(boundary(k))) == 2
