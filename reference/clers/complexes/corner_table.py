"""From a face list to a surface, in linear time, or to the first fault by the order of CPLX-REJECT.

And back, for a surface is a face list in which every corner knows its opposite.
"""

from itertools import chain

from librt.vecs import vec
from mypy_extensions import i64

from clers.complexes.face_list import DEFAULT_LIMITS, FaceList, Limits
from clers.complexes.fans import fans
from clers.complexes.index_list import IndexList, listed_faces
from clers.complexes.matching import bad_counts, edges_of, mates
from clers.complexes.surface import BORDER, Corner, Surface, Vertex, corners_flat, corners_listed
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.where import AtEdge, AtVertex
from clers.kernels import table


def surface(given: FaceList, limits: Limits = DEFAULT_LIMITS) -> Accepted[Surface] | Rejected:
    """The surface that a face list describes, faces and vertices keeping their numbers.

    Linear in faces + vertices. Clauses: CPLX-INPUT-2, CPLX-REJECT-1 … CPLX-REJECT-9.
    """
    fault = bad_counts(given, limits)
    if fault is not None:
        return fault
    tips = list(chain.from_iterable(given.faces))
    if min(tips) >= 0 and max(tips) < given.vertices <= len(tips):  # so that all fit an array
        found = _by_kernels(vec[i64](tips), given.vertices)
        if found is not None:
            return Accepted(found)
    return by_clauses(given, limits)


def surface_of_indices(
    given: IndexList, limits: Limits = DEFAULT_LIMITS
) -> Accepted[Surface] | Rejected:
    """The surface that an index list describes, as its face list does. Linear.

    Clauses: CPLX-INPUT-5, CPLX-INPUT-6.
    """
    if 0 < given.faces <= limits.faces and given.vertices <= limits.vertices:
        found = _by_kernels(given.flat(), given.vertices)
        if found is not None:
            return Accepted(found)
    return surface(listed_faces(given), limits)


def of_corners(vertex: vec[i64], vertices: int) -> Accepted[Surface] | Rejected:
    """The same of the vertices at the corners, which are known to be in range. CPLX-CORNER-1."""
    found = _by_kernels(vertex, vertices)
    if found is not None:
        return Accepted(found)
    tips = tuple(vertex)
    faces = tuple(zip(tips[0::3], tips[1::3], tips[2::3], strict=True))
    return by_clauses(FaceList(faces, vertices), Limits(len(faces), vertices))


def _by_kernels(vertex: vec[i64], vertices: int) -> Surface | None:
    """The surface, if there is nothing wrong. Linear."""
    if not 0 < vertices <= len(vertex) <= table.MOST or not table.fit(vertex, vertices):
        return None
    opposite = table.opposites(vertex, vertices)
    if len(opposite) > 0 and table.one_fan_each(vertex, opposite, vertices):
        return corners_flat(vertex, opposite, vertices)
    return None


def by_clauses(given: FaceList, limits: Limits = DEFAULT_LIMITS) -> Accepted[Surface] | Rejected:
    """The same, one clause after another, with the first fault and where it is. Linear.

    Clauses: CPLX-INPUT-2, CPLX-REJECT-1 … CPLX-REJECT-9.
    """
    return and_then(mates(given, limits), lambda mate: _checked(_table(given, mate)))


def face_list(given: Surface) -> FaceList:
    """The face list of a surface, faces and vertices keeping their numbers. CPLX-INPUT-2."""
    return FaceList(tuple(given.triangles()), given.vertices)


def _table(given: FaceList, mate: tuple[int, ...]) -> Surface:
    """A corner table, of which orientation and stars are yet to be checked. CPLX-CORNER-2."""
    return corners_listed(
        tuple(Vertex(v) for face in given.faces for v in face),
        tuple(Corner(c) for c in mate),
        given.vertices,
    )


def _checked(glued: Surface) -> Accepted[Surface] | Rejected:
    fault = _bad_orientation(glued) or _bad_stars(glued)
    return Accepted(glued) if fault is None else fault


def _bad_orientation(glued: Surface) -> Rejected | None:
    """Clause: CPLX-REJECT-7."""
    tails, heads = edges_of(glued.vertex)
    for c, d in enumerate(glued.opposite):
        if BORDER < d < c and tails[c] == tails[d]:
            where = AtEdge(tails[c], heads[c], c // 3)
            detail = f"also run so by face {d // 3}"
            return Rejected(Reason.EDGE_TWICE_IN_ONE_DIRECTION, Clause.CPLX_REJECT_7, where, detail)
    return None


def _bad_stars(glued: Surface) -> Rejected | None:
    """Each vertex has exactly one fan. Clauses: CPLX-REJECT-8, CPLX-REJECT-9."""
    count = [0] * glued.vertices
    for c, lowest in enumerate(fans(glued.vertex, glued.opposite)):
        count[glued.vertex[c]] += c == lowest
    for v, fans_at in enumerate(count):
        if fans_at > 1:
            detail = f"its star is {fans_at} fans"
            return Rejected(Reason.PINCHED_VERTEX, Clause.CPLX_REJECT_8, AtVertex(v), detail)
    for v, fans_at in enumerate(count):
        if fans_at == 0:
            return Rejected(Reason.ISOLATED_VERTEX, Clause.CPLX_REJECT_9, AtVertex(v))
    return None
