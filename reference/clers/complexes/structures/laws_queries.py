"""Laws of what half-edges are asked, and of their flip: the refinement squares."""

from typing import Final

from clers.complexes.corner_table import face_list
from clers.complexes.given import SMALL_SURFACES, SURFACES
from clers.complexes.polytopes.cells import Polytope, star, vertices_of
from clers.complexes.polytopes.polygons import PolygonList, polygon_surface
from clers.complexes.simplicial import closure, link, of_dimension
from clers.complexes.structures.given import FLIPS, HALF_EDGES
from clers.complexes.structures.half_edge import (
    NO_FACE,
    HalfEdges,
    around_vertex,
    half_edges,
)
from clers.complexes.structures.half_edge_polygons import from_polygons, is_regular, polygons
from clers.complexes.structures.half_edge_queries import (
    boundary_curves,
    faces_at,
    flip,
    neighbours,
)
from clers.complexes.surface import Surface
from clers.complexes.topology import curves
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Rejected
from clers.conventions.verdict import Verdict
from clers.conventions.where import AtVertex


def _stars(of: HalfEdges) -> Verdict:
    answer = polygon_surface(polygons(of))
    if isinstance(answer, Rejected):
        return same("a regular structure", answer)
    return every(*(_star(of, answer.value, v) for v in range(of.vertices)))


def _star(of: HalfEdges, cells: Polytope, v: int) -> Verdict:
    here = star(cells, (0, v))
    edges = {vertices_of(cells, cell) for cell in here if cell[0] == 1}
    around = tuple(around_vertex(of, of.of_vertex[v]))
    near, faces = neighbours(of, v), faces_at(of, v)
    at = AtVertex(v)
    return every(
        same({v}, {of.origin[h] for h in around}, at),
        same(len(edges), len(around), at),
        same(edges, {frozenset([v, w]) for w in near}, at),
        same(tuple(of.head(h) for h in around), near, at),
        same({k for m, k in here if m == 2}, set(faces), at),
        same(len(set(faces)), len(faces), at),
        same(len(near) - (of.face[around[0]] == NO_FACE), len(faces), at),
    )


def _triangles(of: Surface) -> PolygonList:
    mesh = face_list(of)
    return PolygonList(mesh.faces, mesh.vertices)


def _links(of: Surface) -> Verdict:
    answer = from_polygons(_triangles(of))
    if isinstance(answer, Rejected):
        return same("half-edges", answer)
    made = answer.value
    k = closure(of.triangles())
    verdicts: list[Verdict] = []
    for v in range(of.vertices):
        near = neighbours(made, v)
        pairs = tuple(zip(near, (*near[1:], near[0]), strict=True))
        border = made.face[made.of_vertex[v]] == NO_FACE
        expected = of_dimension(link(k, frozenset([v])), 1)
        found = {frozenset(pair) for pair in (pairs[1:] if border else pairs)}
        verdicts.append(same(set(expected), found, AtVertex(v)))
    return every(*verdicts)


def _curves(of: Surface) -> Verdict:
    answer = from_polygons(_triangles(of))
    if isinstance(answer, Rejected):
        return same("half-edges", answer)
    expected = {_from_lowest(curve.vertices) for curve in curves(of)}
    return same(expected, set(map(_from_lowest, boundary_curves(answer.value))))


def _border(of: HalfEdges) -> Verdict:
    found = boundary_curves(of)
    border = {of.head(h): h for h, face in enumerate(of.face) if face == NO_FACE}
    lowest = [min(border[v] for v in curve) for curve in found]
    steps = {(v, w) for curve in found for v, w in zip(curve, (*curve[1:], curve[0]), strict=True)}
    return every(
        same({(of.head(h), of.origin[h]) for h in border.values()}, steps),
        same(len(border), sum(map(len, found))),
        same(sorted(lowest), lowest),
        same(lowest, [border[curve[0]] for curve in found]),
    )


def _from_lowest(cycle: tuple[int, ...]) -> tuple[int, ...]:
    at = cycle.index(min(cycle))
    return cycle[at:] + cycle[:at]


def _flipped(given: tuple[HalfEdges, int]) -> Verdict:
    of, h = given
    before = polygons(of)
    expected = _flip_by_definition(before, of.origin[h], of.head(h))
    answer = flip(of, h)
    if isinstance(answer, Rejected) or expected is None:
        return same(expected is None, isinstance(answer, Rejected))
    made = answer.value
    kept = (
        (of.origin[x], of.head(x)) == (made.origin[x], made.head(x))
        for x in range(len(of.next))
        if x not in (h, of.twin[h])
    )
    return every(
        same(answer, half_edges(made)),
        same(True, is_regular(made)),
        same(expected, frozenset(map(_from_lowest, polygons(made).faces))),
        same(True, all(kept)),
        same(
            (of.origin[of.previous[of.twin[h]]], of.origin[of.previous[h]]),
            (made.origin[h], made.head(h)),
        ),
        _four_times(of, h),
    )


def _flip_by_definition(of: PolygonList, a: int, b: int) -> frozenset[tuple[int, ...]] | None:
    """The polygons with a and b's edge turned, or none where that is not allowed."""
    both = [face for face in of.faces if {a, b} <= set(face)]
    if [len(face) for face in both] != [3, 3]:
        return None
    (c,), (d,) = (
        [v for v in face if v not in (a, b)]
        for face in sorted(both, key=lambda face: face[(face.index(a) + 1) % 3] != b)
    )
    if any({c, d} <= set(face) for face in of.faces):
        return None
    others = [face for face in of.faces if face not in both]
    return frozenset(map(_from_lowest, [*others, (d, c, a), (c, d, b)]))


def _four_times(of: HalfEdges, h: int) -> Verdict:
    made = of
    for _ in range(4):
        answer = flip(made, h)
        if isinstance(answer, Rejected):
            return same("a flip back", answer)
        made = answer.value
    arrays = [(x.next, x.previous, x.twin, x.origin, x.face) for x in (of, made)]
    return same(arrays[0], arrays[1])


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "half-edges-around-a-vertex-are-its-star",
        Clause.CPLX_HALFEDGE_14,
        "Edges, neighbours and faces around a vertex are those of the polytope, each once.",
        HALF_EDGES,
        _stars,
    ),
    Law(
        "neighbours-in-turn-are-the-link",
        Clause.CPLX_HALFEDGE_14,
        "Where faces are triangles consecutive neighbours are the edges of the link.",
        SMALL_SURFACES,
        _links,
    ),
    Law(
        "border-half-edges-are-boundary-curves",
        Clause.CPLX_HALFEDGE_15,
        "The cycles of border half-edges, run backwards, are the curves of the corner table.",
        SURFACES,
        _curves,
    ),
    Law(
        "boundary-curves-pass-each-border-half-edge",
        Clause.CPLX_HALFEDGE_15,
        "The steps of the curves are the border half-edges, each once and backwards, and each "
        "curve begins at its lowest.",
        HALF_EDGES,
        _border,
    ),
    Law(
        "flip-refines-the-flip-of-polygons",
        Clause.CPLX_HALFEDGE_16,
        "A flip is allowed as defined, gives the polygons as defined, moves no other half-edge, "
        "and four of them are none.",
        FLIPS,
        _flipped,
    ),
)
