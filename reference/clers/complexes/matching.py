"""Which corners lie opposite to the same edge, found by sorting, or the first fault that shows.

Edges and faces are brought together by counting sorts, so that no hash and no comparison sort
stands between the input and a linear bound, whatever an adversary makes of the indices.
"""

from collections.abc import Iterator, Sequence

from clers.complexes.face_list import FaceList, Limits
from clers.complexes.surface import BORDER
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtEdge, AtFace, Whole


def mates(given: FaceList, limits: Limits) -> Accepted[tuple[int, ...]] | Rejected:
    """For each corner the other corner opposite to the same edge, or BORDER; orientation is free.

    Linear in faces + vertices. Clauses: CPLX-REJECT-1 … CPLX-REJECT-6, CPLX-ORIENT-1.
    """
    fault = bad_counts(given, limits) or bad_range(given) or _bad_repeat(given)
    return fault if fault is not None else _mates(given)


def bad_counts(given: FaceList, limits: Limits) -> Rejected | None:
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


def bad_range(given: FaceList) -> Rejected | None:
    """Clause: CPLX-REJECT-3."""
    count = given.vertices
    for t, (a, b, c) in enumerate(given.faces):
        if not (0 <= a < count and 0 <= b < count and 0 <= c < count):
            detail = f"({a}, {b}, {c}) with {count} vertices"
            return Rejected(Reason.INDEX_OUT_OF_RANGE, Clause.CPLX_REJECT_3, AtFace(t), detail)
    return None


def _bad_repeat(given: FaceList) -> Rejected | None:
    """Clause: CPLX-REJECT-4."""
    for t, (a, b, c) in enumerate(given.faces):
        if a in (b, c) or b == c:
            detail = f"({a}, {b}, {c})"
            return Rejected(Reason.REPEATED_INDEX, Clause.CPLX_REJECT_4, AtFace(t), detail)
    return None


def _mates(given: FaceList) -> Accepted[tuple[int, ...]] | Rejected:
    """Bring the corners of each edge together, two by two.

    Clauses: CPLX-CORNER-3, CPLX-REJECT-5, CPLX-REJECT-6.
    """
    tips = [v for face in given.faces for v in face]
    tails, heads = edges_of(tips)
    low, high = list(map(min, tails, heads)), list(map(max, tails, heads))
    mate: list[int] = [BORDER] * len(tips)
    third = len(tips)
    doubled = False
    for group in groups([low, high], given.vertices):
        if len(group) == 2:
            c, d = group
            mate[c], mate[d] = d, c
            doubled = doubled or tips[c] == tips[d]
        elif len(group) > 2:
            third = min(third, group[2])
    if doubled or third < len(tips):
        twin = _bad_twin(given)
        if twin is not None:
            return twin
    if third < len(tips):
        a, b = tails[third], heads[third]
        users = [c // 3 for c in range(len(tips)) if {tails[c], heads[c]} == {a, b}]
        where = AtEdge(a, b, third // 3)
        detail = f"{len(users)} faces, the first {users[0]} and {users[1]}"
        return Rejected(Reason.EDGE_WITH_THREE_FACES, Clause.CPLX_REJECT_6, where, detail)
    return Accepted(tuple(mate))


def _bad_twin(given: FaceList) -> Rejected | None:
    """Clause: CPLX-REJECT-5."""
    low, middle, high = ([sorted(face)[i] for face in given.faces] for i in range(3))
    twins = [g for g in groups([low, middle, high], given.vertices) if len(g) > 1]
    if not twins:
        return None
    first, again = min((group[:2] for group in twins), key=lambda pair: pair[1])
    detail = f"same vertices as face {first}"
    return Rejected(Reason.DUPLICATE_FACE, Clause.CPLX_REJECT_5, AtFace(again), detail)


def edges_of(tips: Sequence[int]) -> tuple[list[int], list[int]]:
    """Tail and head of the edge opposite to each corner, as its face runs it. CPLX-CORNER-1."""
    tails, heads = [0] * len(tips), [0] * len(tips)
    tails[0::3], tails[1::3], tails[2::3] = tips[1::3], tips[2::3], tips[0::3]
    heads[0::3], heads[1::3], heads[2::3] = tips[2::3], tips[0::3], tips[1::3]
    return tails, heads


def groups(keys: Sequence[Sequence[int]], bound: int) -> Iterator[list[int]]:
    """The positions 0, 1, … with equal keys, all groups, each ascending; keys are below `bound`.

    Linear in the length of the keys + bound, for each key.
    """
    order: Sequence[int] = range(len(keys[0]))
    for key in keys:
        order = counting_sort(key, bound, order)
    whole = list(zip(*keys, strict=True))
    group = [order[0]]
    for i in order[1:]:
        if whole[i] == whole[group[0]]:
            group.append(i)
        else:
            yield group
            group = [i]
    yield group


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
