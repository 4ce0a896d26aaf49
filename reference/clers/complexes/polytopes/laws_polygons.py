"""Laws of polygon lists and of their triangulations."""

from typing import Final

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.polytopes.cells import (
    Polytope,
    boundary,
    closure,
    dimension,
    euler,
    of_dimension,
    vertices_of,
)
from clers.complexes.polytopes.cells import components as cell_components
from clers.complexes.polytopes.construct import polytope
from clers.complexes.polytopes.given import ORIENTED, POLYGON_LISTS, POLYGONAL
from clers.complexes.polytopes.kind import kinds
from clers.complexes.polytopes.manifold import is_manifold
from clers.complexes.polytopes.oriented import polygon_list
from clers.complexes.polytopes.polygons import PolygonList, cell_list, polygon_surface, sides
from clers.complexes.polytopes.triangulate import fanned, starred
from clers.complexes.simplicial import closure as simplices
from clers.complexes.simplicial import euler as simplicial_euler
from clers.complexes.topology import components, curves
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Verdict
from clers.conventions.where import AtFace


def _cells(of: PolygonList) -> Verdict:
    cells = cell_list(of)
    edges = [vertices_of(cells, edge) for edge in of_dimension(cells, 1)]
    first = list(dict.fromkeys(frozenset([s.tail, s.head]) for s in sides(of)))
    return every(
        same(first, edges),
        same(of.vertices, cells.vertices),
        *(
            same(frozenset(face), vertices_of(cells, (2, t)), AtFace(t))
            for t, face in enumerate(of.faces)
        ),
    )


def _accepted(of: PolygonList) -> Verdict:
    answer = polygon_surface(of)
    listed = all(
        len(set(face)) == len(face) > 2 and set(face) <= set(range(of.vertices))
        for face in of.faces
    )
    if not listed or not of.faces:
        return same(False, isinstance(answer, Accepted))
    cells = cell_list(of)
    made = polytope(cells)
    runs = [(side.tail, side.head) for side in sides(of)]
    expected = isinstance(made, Accepted) and is_manifold(cells) and len(set(runs)) == len(runs)
    return every(
        same(expected, isinstance(answer, Accepted)),
        same(made, answer) if isinstance(answer, Accepted) else every(),
    )


def _triangles(of: PolygonList) -> Verdict:
    faces = tuple((face[0], face[1], face[2]) for face in of.faces if len(face) == 3)
    if len(faces) < len(of.faces):
        return every()
    polygons, triangles = polygon_surface(of), surface(FaceList(faces, of.vertices))
    match polygons, triangles:
        case Rejected(reason, _, where), Rejected():
            return every(same(triangles.reason, reason), same(triangles.where, where))
        case _:
            return same(isinstance(triangles, Accepted), isinstance(polygons, Accepted))


def _listed(of: Polytope) -> Verdict:
    answer = polygon_list(of)
    if isinstance(answer, Rejected):
        return same(False, all(kind.orientable for kind in kinds(of)))
    given = answer.value
    runs = [(side.tail, side.head) for side in sides(given)]
    return every(
        same(True, all(kind.orientable for kind in kinds(of))),
        same(len(runs), len(set(runs))),
        same(True, isinstance(polygon_surface(given), Accepted)),
        *(
            every(
                same(vertices_of(of, (2, t)), frozenset(face), AtFace(t)),
                same(min(face), face[0], AtFace(t)),
            )
            for t, face in enumerate(given.faces)
        ),
        same(_edges(of, range(len(given.faces))), {frozenset(run) for run in runs}),
    )


def _edges(of: Polytope, polygons: range) -> set[frozenset[int]]:
    cells = closure(of, ((2, t) for t in polygons))
    return {vertices_of(of, cell) for cell in cells if cell[0] == 1}


def _shape(of: FaceList) -> object:
    """What a triangulation must keep, except for faces and vertices: or why there is no surface."""
    made = surface(of)
    if isinstance(made, Rejected):
        return made
    parts = sorted((c.euler, c.genus, c.curves, c.boundary_edges) for c in components(made.value))
    return parts, {
        frozenset(zip(c.vertices, (*c.vertices[1:], c.vertices[0]), strict=True))
        for c in curves(made.value)
    }


def _expected(of: PolygonList) -> object:
    answer = polygon_surface(of)
    if isinstance(answer, Rejected):
        return answer
    given = answer.value
    run = {(side.tail, side.head) for side in sides(of)}
    rim = {tail: head for tail, head in run if (head, tail) not in run}
    loops: set[frozenset[tuple[int, int]]] = set()
    for start in rim:
        path = [start]
        while rim[path[-1]] != start:
            path.append(rim[path[-1]])
        loops.add(frozenset(zip(path, (*path[1:], start), strict=True)))
    parts = sorted(
        (kind.euler, kind.genus, kind.curves, edges)
        for kind, edges in zip(kinds(given), _rims(given), strict=True)
    )
    return parts, loops


def _rims(of: Polytope) -> list[int]:
    rim = boundary(of)
    return [sum(1 for cell in part & rim if cell[0] == 1) for part in cell_components(of)]


def _starred(of: PolygonList) -> Verdict:
    made = starred(of)
    return every(
        same(sum(map(len, of.faces)), len(made.faces)),
        same(of.vertices + len(of.faces), made.vertices),
        *(
            same(
                {(s.tail, s.head) for s in sides(of) if s.face == t},
                {(a, b) for a, b, centre in made.faces if centre == of.vertices + t},
                AtFace(t),
            )
            for t in range(len(of.faces))
        ),
    )


def _fanned(of: PolygonList) -> Verdict:
    made = fanned(of)
    cells = cell_list(of)
    return every(
        same(sum(len(face) - 2 for face in of.faces), len(made.faces)),
        same(of.vertices, made.vertices),
        same(euler(cells), simplicial_euler(simplices(made.faces))),
        same(2, dimension(cells)),
        *(
            same(True, any(min(face) == a and {a, b, c} <= set(face) for face in of.faces))
            for a, b, c in made.faces
        ),
    )


def _kept(of: PolygonList) -> Verdict:
    expected = _expected(of)
    return every(same(expected, _shape(starred(of))), same(expected, _shape(fanned(of))))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "polygons-become-cells",
        Clause.CPLX_POLYGON_1,
        "Polygons keep their numbers and vertices; edges stand by their first appearance.",
        ORIENTED,
        _cells,
    ),
    Law(
        "triangles-are-rejected-as-surfaces-are",
        Clause.CPLX_POLYGON_2,
        "A polygon list of triangles is accepted as a surface is, or rejected for the same reason "
        "at the same place.",
        POLYGON_LISTS,
        _triangles,
    ),
    Law(
        "polygonal-surfaces-are-oriented-polytopes",
        Clause.CPLX_POLYGON_3,
        "A polygon list is accepted exactly if it is a polytope, a manifold and coherently run.",
        POLYGON_LISTS,
        _accepted,
    ),
    Law(
        "orientable-surfaces-have-polygon-lists",
        Clause.CPLX_POLYGON_4,
        "A polygonal surface has a polygon list, each from its lowest vertex, if it is orientable.",
        POLYGONAL,
        _listed,
    ),
    Law(
        "stars-triangulate",
        Clause.CPLX_POLYGON_5,
        "A centre in each polygon gives as many triangles as sides, each on one side.",
        ORIENTED,
        _starred,
    ),
    Law(
        "fans-triangulate",
        Clause.CPLX_POLYGON_6,
        "A fan from each lowest vertex gives two triangles less than sides for each polygon.",
        ORIENTED,
        _fanned,
    ),
    Law(
        "triangulations-keep-the-surface",
        Clause.CPLX_POLYGON_7,
        "Stars and fans give surfaces with the same χ, genus, curves and their vertices.",
        ORIENTED,
        _kept,
    ),
)
