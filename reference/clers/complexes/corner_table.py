"""From a face list to a surface, in linear time, or to the first fault by the order of CPLX-REJECT.

And back, for a surface is a face list in which every corner knows its opposite.
"""

from clers.complexes.face_list import DEFAULT_LIMITS, FaceList, Limits
from clers.complexes.fans import fans
from clers.complexes.matching import edges_of, mates
from clers.complexes.surface import BORDER, Corner, Surface, Vertex
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.where import AtEdge, AtVertex


def surface(given: FaceList, limits: Limits = DEFAULT_LIMITS) -> Accepted[Surface] | Rejected:
    """The surface that a face list describes, faces and vertices keeping their numbers.

    Linear in faces + vertices. Clauses: CPLX-INPUT-2, CPLX-REJECT-1 … CPLX-REJECT-9.
    """
    return and_then(mates(given, limits), lambda mate: _checked(_table(given, mate)))


def face_list(given: Surface) -> FaceList:
    """The face list of a surface, faces and vertices keeping their numbers. CPLX-INPUT-2."""
    return FaceList(tuple(given.triangles()), given.vertices)


def _table(given: FaceList, mate: tuple[int, ...]) -> Surface:
    """A corner table, of which orientation and stars are yet to be checked. CPLX-CORNER-2."""
    return Surface(
        tuple(Vertex(v) for face in given.faces for v in face),
        tuple(Corner(c) for c in mate),
        given.vertices,
    )


def _checked(table: Surface) -> Accepted[Surface] | Rejected:
    fault = _bad_orientation(table) or _bad_stars(table)
    return Accepted(table) if fault is None else fault


def _bad_orientation(table: Surface) -> Rejected | None:
    """Clause: CPLX-REJECT-7."""
    tails, heads = edges_of(table.vertex)
    for c, d in enumerate(table.opposite):
        if BORDER < d < c and tails[c] == tails[d]:
            where = AtEdge(tails[c], heads[c], c // 3)
            detail = f"also run so by face {d // 3}"
            return Rejected(Reason.EDGE_TWICE_IN_ONE_DIRECTION, Clause.CPLX_REJECT_7, where, detail)
    return None


def _bad_stars(table: Surface) -> Rejected | None:
    """Each vertex has exactly one fan. Clauses: CPLX-REJECT-8, CPLX-REJECT-9."""
    count = [0] * table.vertices
    for c, lowest in enumerate(fans(table.vertex, table.opposite)):
        count[table.vertex[c]] += c == lowest
    for v, fans_at in enumerate(count):
        if fans_at > 1:
            detail = f"its star is {fans_at} fans"
            return Rejected(Reason.PINCHED_VERTEX, Clause.CPLX_REJECT_8, AtVertex(v), detail)
    for v, fans_at in enumerate(count):
        if fans_at == 0:
            return Rejected(Reason.ISOLATED_VERTEX, Clause.CPLX_REJECT_9, AtVertex(v))
    return None
