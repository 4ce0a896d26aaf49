"""Half-edges: the arrays, and the invariant that makes them a surface, in linear time."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtEntry

NO_FACE: Final = -1
"""The face of a border half-edge. Clause: CPLX-HALFEDGE-1."""


@dataclass(frozen=True, slots=True)
class HalfEdges:
    """Five arrays by half-edges, one by vertices, one by faces. Clause: CPLX-HALFEDGE-1.

    Whether they fit together is for `half_edges` to say.
    """

    next: tuple[int, ...]
    previous: tuple[int, ...]
    twin: tuple[int, ...]
    origin: tuple[int, ...]
    face: tuple[int, ...]
    of_vertex: tuple[int, ...]
    of_face: tuple[int, ...]

    @property
    def vertices(self) -> int:
        """The number of vertices."""
        return len(self.of_vertex)

    @property
    def faces(self) -> int:
        """The number of faces."""
        return len(self.of_face)

    def head(self, h: int) -> int:
        """The vertex that a half-edge runs to. Clause: CPLX-HALFEDGE-1."""
        return self.origin[self.twin[h]]

    def rotated(self, h: int) -> int:
        """The next half-edge, counter-clockwise, with the same origin. CPLX-HALFEDGE-1."""
        return self.twin[self.previous[h]]


def half_edges(given: HalfEdges) -> Accepted[HalfEdges] | Rejected:
    """The invariant: the arrays themselves, or the first fault. Clause: CPLX-REFINE-1.

    Linear. Clauses: CPLX-HALFEDGE-2 … CPLX-HALFEDGE-8, in the order of CPLX-HALFEDGE-18; as a
    definition: CPLX-HALFEDGE-9.
    """
    fault = (
        _bad_lengths(given)
        or _bad_ranges(given)
        or _bad_cycles(given)
        or _bad_origins(given)
        or _bad_faces(given)
        or _bad_vertices(given)
        or _bad_border(given)
    )
    return Accepted(given) if fault is None else fault


def _broken(clause: Clause, array: str, entry: int, detail: str) -> Rejected:
    return Rejected(Reason.BROKEN_INVARIANT, clause, AtEntry(array, entry), detail)


def _bad_lengths(given: HalfEdges) -> Rejected | None:
    """Clause: CPLX-HALFEDGE-2."""
    count = len(given.next)
    for name, array in (
        ("previous", given.previous),
        ("twin", given.twin),
        ("origin", given.origin),
        ("face", given.face),
    ):
        if len(array) != count:
            where = AtEntry(name, min(len(array), count))
            detail = f"{len(array)} entries, and {count} of next"
            return Rejected(Reason.COUNT_MISMATCH, Clause.CPLX_HALFEDGE_2, where, detail)
    return None


def _bad_ranges(given: HalfEdges) -> Rejected | None:
    """Clause: CPLX-HALFEDGE-2."""
    count = len(given.next)
    for name, array, low, high in (
        ("next", given.next, 0, count),
        ("previous", given.previous, 0, count),
        ("twin", given.twin, 0, count),
        ("origin", given.origin, 0, given.vertices),
        ("face", given.face, NO_FACE, given.faces),
        ("of_vertex", given.of_vertex, 0, count),
        ("of_face", given.of_face, 0, count),
    ):
        for i, entry in enumerate(array):
            if not low <= entry < high:
                where, detail = AtEntry(name, i), f"{entry}"
                return Rejected(Reason.INDEX_OUT_OF_RANGE, Clause.CPLX_HALFEDGE_2, where, detail)
    return None


def _bad_cycles(given: HalfEdges) -> Rejected | None:
    """Clauses: CPLX-HALFEDGE-3, CPLX-HALFEDGE-4."""
    for h, after in enumerate(given.next):
        back = given.previous[after]
        if back != h:
            return _broken(Clause.CPLX_HALFEDGE_3, "next", h, f"previous of {after} is {back}")
    for h, other in enumerate(given.twin):
        back = given.twin[other]
        if back != h or other == h:
            return _broken(Clause.CPLX_HALFEDGE_4, "twin", h, f"twin of {other} is {back}")
    return None


def _bad_origins(given: HalfEdges) -> Rejected | None:
    """Clause: CPLX-HALFEDGE-5."""
    for h, vertex in enumerate(given.origin):
        head, after = given.head(h), given.origin[given.next[h]]
        if after != head or vertex == head:
            detail = f"from {vertex} to {head}, and the next from {after}"
            return _broken(Clause.CPLX_HALFEDGE_5, "origin", h, detail)
    return None


def _bad_faces(given: HalfEdges) -> Rejected | None:
    """Clause: CPLX-HALFEDGE-6."""
    count = [0] * given.faces
    for h, face in enumerate(given.face):
        after = given.face[given.next[h]]
        if after != face:
            return _broken(Clause.CPLX_HALFEDGE_6, "face", h, f"the next has face {after}")
        if face != NO_FACE:
            count[face] += 1
    for f, first in enumerate(given.of_face):
        passed = sum(1 for _ in around_face(given, first))
        if given.face[first] != f or passed != count[f]:
            detail = f"passes {passed} of {count[f]}, with face {given.face[first]}"
            return _broken(Clause.CPLX_HALFEDGE_6, "of_face", f, detail)
    return None


def _bad_vertices(given: HalfEdges) -> Rejected | None:
    """Clause: CPLX-HALFEDGE-7."""
    count = [0] * given.vertices
    for vertex in given.origin:
        count[vertex] += 1
    for v, first in enumerate(given.of_vertex):
        passed = sum(1 for _ in around_vertex(given, first))
        if given.origin[first] != v or passed != count[v]:
            detail = f"passes {passed} of {count[v]}, with origin {given.origin[first]}"
            return _broken(Clause.CPLX_HALFEDGE_7, "of_vertex", v, detail)
    return None


def _bad_border(given: HalfEdges) -> Rejected | None:
    """Clause: CPLX-HALFEDGE-8."""
    for h, other in enumerate(given.twin):
        if given.face[h] == given.face[other] == NO_FACE:
            return _broken(Clause.CPLX_HALFEDGE_8, "face", h, "border on both sides")
    for v, first in enumerate(given.of_vertex):
        for h in around_vertex(given, first):
            if given.face[h] == NO_FACE and h != first:
                detail = f"border half-edge {h} has the same origin"
                return _broken(Clause.CPLX_HALFEDGE_8, "of_vertex", v, detail)
    return None


def around_face(of: HalfEdges, first: int) -> Iterator[int]:
    """A half-edge and those after it along `next`, once around."""
    h = first
    while True:
        yield h
        h = of.next[h]
        if h == first:
            return


def around_vertex(of: HalfEdges, first: int) -> Iterator[int]:
    """A half-edge and those with the same origin, counter-clockwise. Clause: CPLX-HALFEDGE-14."""
    h = first
    while True:
        yield h
        h = of.rotated(h)
        if h == first:
            return
