"""What half-edges are asked, and one operation on them."""

from itertools import islice

from clers.complexes.structures.half_edge import (
    NO_FACE,
    HalfEdges,
    around_face,
    around_vertex,
)
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtEntry


def neighbours(of: HalfEdges, vertex: int) -> tuple[int, ...]:
    """The heads of the half-edges around a vertex, counter-clockwise: CPLX-HALFEDGE-14."""
    return tuple(of.head(h) for h in around_vertex(of, of.of_vertex[vertex]))


def faces_at(of: HalfEdges, vertex: int) -> tuple[int, ...]:
    """The faces around a vertex, counter-clockwise: CPLX-HALFEDGE-14."""
    found = (of.face[h] for h in around_vertex(of, of.of_vertex[vertex]))
    return tuple(face for face in found if face != NO_FACE)


def boundary_curves(of: HalfEdges) -> tuple[tuple[int, ...], ...]:
    """The border's cycles, run with the surface on the left: CPLX-HALFEDGE-15, CPLX-HALFEDGE-13."""
    done: set[int] = set()
    found: list[tuple[int, ...]] = []
    for h, face in enumerate(of.face):
        if face == NO_FACE and h not in done:
            first, *others = around_face(of, h)
            done.update((first, *others))
            found.append(tuple(of.head(b) for b in (first, *reversed(others))))
    return tuple(found)


def flip(of: HalfEdges, h: int) -> Accepted[HalfEdges] | Rejected:
    """Turn the edge between two triangles; only its own ends change. Clause: CPLX-HALFEDGE-16."""
    if not 0 <= h < len(of.next):
        return Rejected(Reason.INDEX_OUT_OF_RANGE, Clause.CPLX_HALFEDGE_16, AtEntry("twin", h))
    t = of.twin[h]
    obstacle = _obstacle(of, h, t)
    if obstacle:
        where = AtEntry("twin", h)
        return Rejected(Reason.OPERATOR_NOT_APPLICABLE, Clause.CPLX_HALFEDGE_16, where, obstacle)
    (_, bc, ca), (_, ad, db) = around_face(of, h), around_face(of, t)
    after, before = list(of.next), list(of.previous)
    origin, face = list(of.origin), list(of.face)
    of_vertex, of_face = list(of.of_vertex), list(of.of_face)
    for cycle, f in (((h, ca, ad), of.face[h]), ((t, db, bc), of.face[t])):
        for x, y in zip(cycle, (*cycle[1:], cycle[0]), strict=True):
            after[x], before[y], face[x] = y, x, f
        of_face[f] = cycle[0]
    origin[h], origin[t] = of.origin[db], of.origin[ca]
    for left, other in ((ad, h), (bc, t)):
        v = of.origin[left]
        of_vertex[v] = left if of_vertex[v] == other else of_vertex[v]
    return Accepted(
        HalfEdges(
            tuple(after), tuple(before), of.twin, tuple(origin), tuple(face),
            tuple(of_vertex), tuple(of_face),
        )
    )  # fmt: skip


def _obstacle(of: HalfEdges, h: int, t: int) -> str:
    if NO_FACE in (of.face[h], of.face[t]):
        return "a border edge"
    if any(len(tuple(islice(around_face(of, side), 4))) != 3 for side in (h, t)):
        return "not between triangles"
    c, d = (of.origin[of.previous[side]] for side in (h, t))
    common = set(faces_at(of, c)).intersection(faces_at(of, d))
    return "its new ends have a face in common" if common else ""
