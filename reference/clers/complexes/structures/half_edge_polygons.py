"""Half-edges from polygons and back: the construction and the abstraction."""

from clers.complexes.polytopes.polygons import PolygonList, following, polygon_surface, sides
from clers.complexes.structures.half_edge import NO_FACE, HalfEdges, around_face
from clers.conventions.result import Accepted, Rejected


def polygons(of: HalfEdges) -> PolygonList:
    """The abstraction: the origins along each face. Clause: CPLX-HALFEDGE-10."""
    faces = (tuple(of.origin[h] for h in around_face(of, first)) for first in of.of_face)
    return PolygonList(tuple(faces), of.vertices)


def is_regular(of: HalfEdges) -> bool:
    """Are the polygons an oriented polygonal surface? Clauses: CPLX-HALFEDGE-10,
    CPLX-HALFEDGE-12."""
    return isinstance(polygon_surface(polygons(of)), Accepted)


def from_polygons(of: PolygonList) -> Accepted[HalfEdges] | Rejected:
    """The construction, sides first and then the border. Clause: CPLX-HALFEDGE-11."""
    answer = polygon_surface(of)
    return answer if isinstance(answer, Rejected) else Accepted(_built(of))


def _built(of: PolygonList) -> HalfEdges:
    every = tuple(sides(of))
    inner = len(every)
    number = {(side.tail, side.head): h for h, side in enumerate(every)}
    lonely = [h for h, side in enumerate(every) if (side.head, side.tail) not in number]
    number |= {(every[h].head, every[h].tail): inner + i for i, h in enumerate(lonely)}
    leaving = {every[h].head: inner + i for i, h in enumerate(lonely)}
    after = (*following(of), *(leaving[every[h].tail] for h in lonely))
    before = [0] * len(after)
    for h, following_h in enumerate(after):
        before[following_h] = h
    origin = (*(side.tail for side in every), *(every[h].head for h in lonely))
    first = {v: h for h, v in reversed(tuple(enumerate(origin)))} | leaving
    starts = {side.face: h for h, side in reversed(tuple(enumerate(every)))}
    return HalfEdges(
        next=after,
        previous=tuple(before),
        twin=(
            *(number[side.head, side.tail] for side in every),
            *lonely,
        ),
        origin=origin,
        face=(*(side.face for side in every), *(NO_FACE for _ in lonely)),
        of_vertex=tuple(first[v] for v in range(of.vertices)),
        of_face=tuple(starts[t] for t in range(len(of.faces))),
    )
