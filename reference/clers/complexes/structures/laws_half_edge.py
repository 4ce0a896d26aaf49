"""Laws of half-edges: the invariant, the construction and the abstraction."""

from typing import Final

from clers.complexes.polytopes.cells import all_cells, vertices_of
from clers.complexes.polytopes.given import ORIENTED, POLYGON_LISTS
from clers.complexes.polytopes.kind import kinds
from clers.complexes.polytopes.polygons import PolygonList, polygon_surface
from clers.complexes.structures.arrays import read_half_edges, write_half_edges
from clers.complexes.structures.given import FOREIGN, HALF_EDGES
from clers.complexes.structures.half_edge import (
    NO_FACE,
    HalfEdges,
    half_edges,
)
from clers.complexes.structures.half_edge_definition import cycles, is_half_edge_structure
from clers.complexes.structures.half_edge_polygons import from_polygons, is_regular, polygons
from clers.complexes.structures.half_edge_queries import (
    boundary_curves,
)
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Verdict


def _built(of: PolygonList) -> Verdict:
    answer = from_polygons(of)
    if isinstance(answer, Rejected):
        return same("half-edges", answer)
    made = answer.value
    inner = sum(map(len, of.faces))
    return every(
        same(answer, half_edges(made)),
        same(of, polygons(made)),
        same(True, all(face != NO_FACE for face in made.face[:inner])),
        same({NO_FACE}, {*made.face[inner:], NO_FACE}),
        same(sorted(made.twin[inner:]), list(made.twin[inner:])),
        same(True, all(made.face.index(f) == h for f, h in enumerate(made.of_face))),
    )


def _construct_or_reject(of: PolygonList) -> Verdict:
    expected = polygon_surface(of)
    answer = from_polygons(of)
    if isinstance(expected, Rejected):
        return same(expected, answer)
    return same(True, isinstance(answer, Accepted))


def _judged(of: HalfEdges) -> Verdict:
    answer = half_edges(of)
    if isinstance(answer, Accepted):
        return every(same(True, is_half_edge_structure(of)), same(of, answer.value))
    return same(False, is_half_edge_structure(of))


Relation = frozenset[tuple[tuple[int, int], ...]]


def _relation(of: HalfEdges) -> Relation:
    """All arrays by half-edges, each half-edge named by its ends."""
    name = [(of.origin[h], of.head(h)) for h in range(len(of.next))]
    rows = zip(name, of.next, of.previous, of.twin, of.face, strict=True)
    return frozenset((me, name[n], name[p], name[t], (f, f)) for me, n, p, t, f in rows)


def _same_half_edges(of: HalfEdges) -> Verdict:
    answer = from_polygons(polygons(of))
    if isinstance(answer, Rejected):
        return same("a regular structure", answer)
    return every(
        same(True, is_regular(of)),
        same(len(of.next), len(_relation(of))),
        same(_relation(answer.value), _relation(of)),
    )


def _counts(of: HalfEdges) -> Verdict:
    answer = polygon_surface(polygons(of))
    if isinstance(answer, Rejected):
        return same("a regular structure", answer)
    rotation = cycles({h: of.rotated(h) for h in range(len(of.next))})
    edges = cycles(dict(enumerate(of.twin)))
    along = cycles(dict(enumerate(of.next)))
    loops = len(boundary_curves(of))
    found = kinds(answer.value)
    return every(
        same(of.vertices, len(rotation)),
        same(len(of.next), 2 * len(edges)),
        same(of.faces + loops, len(along)),
        same(sum(kind.euler for kind in found), len(rotation) - len(edges) + of.faces),
        same(sum(kind.curves for kind in found), loops),
    )


def _written(of: HalfEdges) -> Verdict:
    return same(half_edges(of), read_half_edges(write_half_edges(of)))


def _cells(of: HalfEdges) -> Verdict:
    answer = polygon_surface(polygons(of))
    if isinstance(answer, Rejected):
        return same("a regular structure", answer)
    edges = {frozenset([of.origin[h], of.head(h)]) for h in range(len(of.next))}
    cells = [vertices_of(answer.value, cell) for cell in all_cells(answer.value)]
    faces = [{of.origin[h] for h, face in enumerate(of.face) if face == f} for f in range(of.faces)]
    return every(
        same(edges, {cell for cell in cells if len(cell) == 2}),
        same(faces, [set(face) for face in polygons(of).faces]),
    )


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "half-edges-are-built-of-polygons",
        Clause.CPLX_REFINE_1,
        "The half-edges of polygons satisfy the invariant, stand in the order of the sides, and "
        "give the polygons back.",
        ORIENTED,
        _built,
    ),
    Law(
        "half-edges-are-built-or-rejected",
        Clause.CPLX_HALFEDGE_11,
        "A polygon list has half-edges exactly if it is accepted, else the same rejection.",
        POLYGON_LISTS,
        _construct_or_reject,
    ),
    Law(
        "foreign-half-edges-are-judged-as-defined",
        Clause.CPLX_HALFEDGE_9,
        "Arrays are accepted exactly if their permutations have faces, edges and vertices as "
        "cycles.",
        FOREIGN,
        _judged,
    ),
    Law(
        "polygons-have-the-edges-of-half-edges",
        Clause.CPLX_HALFEDGE_10,
        "The edges and faces of the polygons are those of the half-edges.",
        HALF_EDGES,
        _cells,
    ),
    Law(
        "half-edges-are-known-by-their-ends",
        Clause.CPLX_HALFEDGE_12,
        "A regular structure is the one built of its polygons, but for the numbers of half-edges.",
        HALF_EDGES,
        _same_half_edges,
    ),
    Law(
        "cycles-count-vertices-edges-and-faces",
        Clause.CPLX_HALFEDGE_13,
        "Cycles of rotation, twins and next count V, E and F + b; χ and b are the polygons'.",
        HALF_EDGES,
        _counts,
    ),
    Law(
        "half-edges-are-read-as-written",
        Clause.CPLX_HALFEDGE_17,
        "Arrays written as JSON are read and judged as the arrays themselves.",
        FOREIGN,
        _written,
    ),
)
