"""The invariant of corner tables that others made."""

from clers.complexes.corner_table import surface
from clers.complexes.face_list import DEFAULT_LIMITS, FaceList, Limits
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtEntry


def corner_table(given: Surface, limits: Limits = DEFAULT_LIMITS) -> Accepted[Surface] | Rejected:
    """The table itself, if it is that of its face list; or the first fault. CPLX-REFINE-2."""
    corners = len(given.vertex)
    if len(given.opposite) != corners or corners % 3:
        detail = f"{corners} vertices, {len(given.opposite)} opposites"
        return Rejected(Reason.COUNT_MISMATCH, Clause.CPLX_REFINE_2, WHOLE, detail)
    answer = surface(FaceList(tuple(given.triangles()), given.vertices), limits)
    if isinstance(answer, Rejected):
        return answer
    for c, right in enumerate(answer.value.opposite):
        if given.opposite[c] != right:
            where, detail = AtEntry("opposite", c), f"{given.opposite[c]}, and not {right}"
            return Rejected(Reason.BROKEN_INVARIANT, Clause.CPLX_REFINE_2, where, detail)
    return answer
