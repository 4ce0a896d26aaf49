"""Laws of polytopes and structures, on lists that nobody checked: each must say so."""

from dataclasses import replace

import pytest
from golden_polytopes import (
    CUBE,
    CUBE_FACES,
    PROJECTIVE_PLANE,
    TETRAHEDRON,
    TRIANGLE,
    cells,
    simplicial,
)

from clers.complexes.laws import LAWS
from clers.complexes.polytopes.cells import CellList, Polytope
from clers.complexes.polytopes.polygons import PolygonList
from clers.complexes.polytopes.products import circle, cube
from clers.complexes.simplicial import closure
from clers.complexes.structures.half_edge import HalfEdges
from clers.complexes.structures.half_edge_polygons import from_polygons
from clers.complexes.surface import BORDER, Vertex, corners_listed
from clers.conventions.result import Accepted
from clers.conventions.verdict import Fails, Holds


def unchecked(of: CellList) -> Polytope:
    """A cell list that is called a polytope without being one."""
    return Polytope(of.vertices, of.cells)


def half_edges(of: PolygonList) -> HalfEdges:
    """The half-edges of good polygons."""
    answer = from_polygons(of)
    assert isinstance(answer, Accepted)
    return answer.value


BOW_TIE = unchecked(
    cells(5, ((0, 1), (1, 2), (0, 2), (0, 3), (3, 4), (0, 4)), ((0, 1, 2), (3, 4, 5)))
)
DOUBLE_EDGE = unchecked(cells(2, ((0, 1), (0, 1))))
LOOP = unchecked(cells(1, ((0,),)))
BRANCH = unchecked(cells(4, ((0, 1), (0, 2), (0, 3))))
TOO_LARGE = closure([range(5)])
TOUCHING = simplicial(
    *((0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3)), *((0, 4, 5), (0, 4, 6), (0, 5, 6), (4, 5, 6))
)
"""Two spheres with a vertex in common."""
MOEBIUS_WITH_A_FIN = simplicial(*((0, 1, 2), (1, 2, 3), (2, 3, 4), (0, 3, 4), (0, 1, 4)), (1, 2, 5))
"""Cut at the edge with three triangles it is two-sided; by the first two of them it is not."""
DOUBLET = PolygonList(((0, 1, 2, 3), (0, 3, 2, 4)), 5)
SQUARES = half_edges(CUBE_FACES)
NOT_A_SURFACE = corners_listed(tuple(Vertex(v) for v in (0, 1, 2)), (BORDER,) * 3, 4)

WRONG: tuple[tuple[str, object], ...] = (
    ("simplicial-complexes-are-polytopes", TOO_LARGE),
    ("products-of-polytopes-are-polytopes", (DOUBLE_EDGE, cube(1))),
    ("vertex-figures-are-spheres-and-balls", BOW_TIE),
    ("vertex-figures-are-spheres-and-balls", BRANCH),
    ("cells-are-boundary-or-interior", unchecked(cells(4, ((0, 1), (1, 2), (0, 2)), ((0, 1, 2),)))),
    ("coloured-flags-are-coherent-chains", MOEBIUS_WITH_A_FIN),
    ("kinds-are-whole-numbers", TOUCHING),
    ("kinds-agree-with-homology", TOUCHING),
    ("dual-cells-span-stars", TRIANGLE),
    ("dual-is-a-closed-manifold", TRIANGLE),
    ("dual-of-the-dual-is-the-original", TRIANGLE),
    ("dual-turns-the-counts-around", TRIANGLE),
    ("only-closed-manifolds-have-duals", TOUCHING),
    ("graphs-are-edges-and-walls", unchecked(cells(3, ((0, 1), (1,))))),
    ("graphs-hang-together-as-the-manifold", BOW_TIE),
    ("orientable-surfaces-have-polygon-lists", BOW_TIE),
    ("fans-triangulate", PolygonList(((0, 1),), 2)),
    ("triangulations-keep-the-surface", DOUBLET),
    ("half-edges-are-built-of-polygons", DOUBLET),
    ("polygons-have-the-edges-of-half-edges", replace(SQUARES, of_face=(0,) * 6)),
    ("half-edges-are-known-by-their-ends", replace(SQUARES, previous=SQUARES.next)),
    ("cycles-count-vertices-edges-and-faces", replace(SQUARES, twin=tuple(range(24)))),
    ("half-edges-around-a-vertex-are-its-star", replace(SQUARES, of_vertex=(0,) * 8)),
    ("half-edges-around-a-vertex-are-its-star", replace(SQUARES, face=(0,) * 24)),
)


@pytest.mark.parametrize(("name", "wrong"), WRONG)
def test_law_fails(name: str, wrong: object) -> None:
    """Clause: CONV-LAW-4."""
    (law,) = [law for law in LAWS if law.name == name]
    assert isinstance(law.check(wrong), Fails)


RIGHT: tuple[tuple[str, object], ...] = (
    *((name, CUBE) for name, wrong in WRONG if isinstance(wrong, Polytope)),
    *((name, CUBE_FACES) for name, wrong in WRONG if isinstance(wrong, PolygonList)),
    *((name, SQUARES) for name, wrong in WRONG if isinstance(wrong, HalfEdges)),
    ("kinds-are-whole-numbers", PROJECTIVE_PLANE),
    ("products-of-polytopes-are-polytopes", (circle(3), cube(1))),
    ("orientable-surfaces-have-polygon-lists", TETRAHEDRON),
)


@pytest.mark.parametrize(("name", "right"), RIGHT)
def test_law_holds(name: str, right: object) -> None:
    """Clause: CONV-LAW-4."""
    (law,) = [law for law in LAWS if law.name == name]
    assert law.check(right) == Holds()
