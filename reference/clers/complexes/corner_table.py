"""From a face list to a surface, in linear time, or to the first fault by the order of CPLX-REJECT.

Half-edges are matched by two passes of counting sort, so that no hash and no comparison sort stands
between the input and a linear bound, whatever an adversary makes of the indices.
"""

from collections.abc import Sequence

from clers.complexes.face_list import DEFAULT_LIMITS, FaceList, Limits
from clers.complexes.surface import BORDER, Corner, Surface, Vertex
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtEdge, AtFace, AtVertex, Whole


def surface(given: FaceList, limits: Limits = DEFAULT_LIMITS) -> Accepted[Surface] | Rejected:
    """The surface that a face list describes, faces and vertices keeping their numbers.

    Linear in faces + vertices. Clauses: CPLX-INPUT-2, CPLX-REJECT-1 … CPLX-REJECT-9.
    """
    fault = _bad_counts(given, limits) or _bad_indices(given)
    if fault is not None:
        return fault
    vertex = [v for face in given.faces for v in face]
    matched = _match(vertex, given.vertices)
    if isinstance(matched, Rejected):
        return matched
    fault = _bad_stars(vertex, matched, given.vertices)
    if fault is not None:
        return fault
    return Accepted(
        Surface(tuple(Vertex(v) for v in vertex), tuple(Corner(c) for c in matched), given.vertices)
    )


def _bad_counts(given: FaceList, limits: Limits) -> Rejected | None:
    """Clauses: CPLX-REJECT-1, CPLX-REJECT-2."""
    if not given.faces:
        return Rejected(Reason.EMPTY_MESH, Clause.CPLX_REJECT_1, Whole())
    if len(given.faces) > limits.faces:
        detail = f"{len(given.faces)} faces, the limit is {limits.faces}"
        return Rejected(Reason.TOO_MANY_FACES, Clause.CPLX_REJECT_2, Whole(), detail)
    if given.vertices > limits.vertices:
        detail = f"{given.vertices} vertices, the limit is {limits.vertices}"
        return Rejected(Reason.TOO_MANY_VERTICES, Clause.CPLX_REJECT_2, Whole(), detail)
    return None


def _bad_indices(given: FaceList) -> Rejected | None:
    """Clauses: CPLX-REJECT-3, CPLX-REJECT-4."""
    count = given.vertices
    for t, (a, b, c) in enumerate(given.faces):
        if not (0 <= a < count and 0 <= b < count and 0 <= c < count):
            detail = f"({a}, {b}, {c}) with {count} vertices"
            return Rejected(Reason.INDEX_OUT_OF_RANGE, Clause.CPLX_REJECT_3, AtFace(t), detail)
    for t, (a, b, c) in enumerate(given.faces):
        if a in (b, c) or b == c:
            detail = f"({a}, {b}, {c})"
            return Rejected(Reason.REPEATED_INDEX, Clause.CPLX_REJECT_4, AtFace(t), detail)
    return None


def counting_sort(keys: Sequence[int], bound: int, order: Sequence[int]) -> list[int]:
    """`order`, stably sorted by `keys[i]` in 0 … bound-1; linear in len(order) + bound."""
    start = [0] * (bound + 1)
    for i in order:
        start[keys[i] + 1] += 1
    for k in range(bound):
        start[k + 1] += start[k]
    result = [0] * len(order)
    for i in order:
        k = keys[i]
        result[start[k]] = i
        start[k] += 1
    return result


def _match(vertex: list[int], vertices: int) -> list[int] | Rejected:
    """The opposite corner of each corner, or the first fault of CPLX-REJECT-5, -6, -7."""
    corners = range(len(vertex))
    tail = [0] * len(vertex)  # the edge opposite to corner c runs tail[c] → head[c]
    head = [0] * len(vertex)
    tail[0::3], tail[1::3], tail[2::3] = vertex[1::3], vertex[2::3], vertex[0::3]
    head[0::3], head[1::3], head[2::3] = vertex[2::3], vertex[0::3], vertex[1::3]
    low = list(map(min, tail, head))
    high = list(map(max, tail, head))
    order = counting_sort(low, vertices, counting_sort(high, vertices, corners))

    opposite: list[int] = [BORDER] * len(vertex)
    faulty = False
    i, n = 0, len(order)
    while i < n:
        c = order[i]
        j = i + 1
        while j < n and high[order[j]] == high[c] and low[order[j]] == low[c]:
            j += 1
        if j == i + 2:
            d = order[i + 1]
            opposite[c], opposite[d] = d, c
            # Two faces that run one edge the same way, or on the same three vertices.
            faulty = faulty or tail[c] == tail[d] or vertex[c] == vertex[d]
        elif j > i + 2:
            faulty = True
        i = j
    return _name_fault(vertex, tail, head) if faulty else opposite


def _name_fault(vertex: list[int], tail: list[int], head: list[int]) -> Rejected:
    """Say which fault the edges have; called only when they have one.

    Clauses: CPLX-REJECT-5 … CPLX-REJECT-7, each with the lowest face that completes the fault.
    """
    seen: dict[tuple[int, ...], int] = {}
    for t in range(len(vertex) // 3):
        key = tuple(sorted(vertex[3 * t : 3 * t + 3]))
        if key in seen:
            detail = f"same vertices as face {seen[key]}"
            return Rejected(Reason.DUPLICATE_FACE, Clause.CPLX_REJECT_5, AtFace(t), detail)
        seen[key] = t

    users: dict[tuple[int, int], list[int]] = {}
    for c in range(len(vertex)):
        users.setdefault((min(tail[c], head[c]), max(tail[c], head[c])), []).append(c)
    crowded = [cs for cs in users.values() if len(cs) > 2]
    if crowded:
        cs = min(crowded, key=lambda group: group[2])
        where = AtEdge(tail[cs[2]], head[cs[2]], cs[2] // 3)
        detail = f"faces {', '.join(str(c // 3) for c in cs)}"
        return Rejected(Reason.EDGE_WITH_THREE_FACES, Clause.CPLX_REJECT_6, where, detail)
    twice = [cs for cs in users.values() if len(cs) == 2 and tail[cs[0]] == tail[cs[1]]]
    cs = min(twice, key=lambda group: group[1])
    where = AtEdge(tail[cs[1]], head[cs[1]], cs[1] // 3)
    detail = f"also run so by face {cs[0] // 3}"
    return Rejected(Reason.EDGE_TWICE_IN_ONE_DIRECTION, Clause.CPLX_REJECT_7, where, detail)


def _bad_stars(vertex: list[int], opposite: list[int], vertices: int) -> Rejected | None:
    """Each vertex has exactly one fan of corners. Clauses: CPLX-REJECT-8, CPLX-REJECT-9."""
    fans = [0] * vertices
    seen = bytearray(len(vertex))
    for start in range(len(vertex)):
        if seen[start]:
            continue
        fans[vertex[start]] += 1
        seen[start] = 1
        c = start
        while True:  # across the edge after the corner, until the border or the start
            d = opposite[c - 2 if c % 3 == 2 else c + 1]
            if d < 0:
                break
            c = d - 2 if d % 3 == 2 else d + 1
            if seen[c]:
                break
            seen[c] = 1
        if c == start and d >= 0:
            continue
        c = start
        while True:  # the other way round, from the start to the other border
            d = opposite[c + 2 if c % 3 == 0 else c - 1]
            if d < 0:
                break
            c = d + 2 if d % 3 == 0 else d - 1
            if seen[c]:
                break
            seen[c] = 1
    for v, count in enumerate(fans):
        if count > 1:
            detail = f"its star is {count} fans"
            return Rejected(Reason.PINCHED_VERTEX, Clause.CPLX_REJECT_8, AtVertex(v), detail)
    for v, count in enumerate(fans):
        if count == 0:
            return Rejected(Reason.ISOLATED_VERTEX, Clause.CPLX_REJECT_9, AtVertex(v))
    return None
