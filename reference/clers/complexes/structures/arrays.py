"""Arrays of another program, as JSON: read, and judged by the invariant."""

import msgspec

from clers.complexes.structures.corner_invariant import corner_table
from clers.complexes.structures.half_edge import HalfEdges, half_edges
from clers.complexes.surface import Corner, Surface, Vertex, corners_listed
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected


class _Arrays(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The members of the object, named as in CPLX-HALFEDGE-1."""

    next: tuple[int, ...]
    previous: tuple[int, ...]
    twin: tuple[int, ...]
    origin: tuple[int, ...]
    face: tuple[int, ...]
    of_vertex: tuple[int, ...]
    of_face: tuple[int, ...]


def read_half_edges(content: bytes) -> Accepted[HalfEdges] | Rejected:
    """Half-edges from JSON, or why they are none. Clause: CPLX-HALFEDGE-17."""
    try:
        found = msgspec.json.decode(content, type=_Arrays)
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as error:
        return Rejected(Reason.UNREADABLE_FILE, Clause.CPLX_HALFEDGE_17, detail=str(error))
    return half_edges(
        HalfEdges(
            found.next,
            found.previous,
            found.twin,
            found.origin,
            found.face,
            found.of_vertex,
            found.of_face,
        )
    )


class _Corners(msgspec.Struct, forbid_unknown_fields=True, frozen=True):
    """The members of the object, named as in CPLX-REFINE-3."""

    vertex: tuple[int, ...]
    opposite: tuple[int, ...]
    vertices: int


def read_corner_table(content: bytes) -> Accepted[Surface] | Rejected:
    """A corner table from JSON, or why it is none. Clause: CPLX-REFINE-3."""
    try:
        found = msgspec.json.decode(content, type=_Corners)
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as error:
        return Rejected(Reason.UNREADABLE_FILE, Clause.CPLX_REFINE_3, detail=str(error))
    vertex, opposite = map(Vertex, found.vertex), map(Corner, found.opposite)
    return corner_table(corners_listed(tuple(vertex), tuple(opposite), found.vertices))


def write_corner_table(of: Surface) -> bytes:
    """The same arrays as JSON. Clause: CPLX-REFINE-3."""
    return msgspec.json.encode(_Corners(of.vertex, of.opposite, of.vertices))


def write_half_edges(of: HalfEdges) -> bytes:
    """The same arrays as JSON. Clause: CPLX-HALFEDGE-17."""
    return msgspec.json.encode(of)
