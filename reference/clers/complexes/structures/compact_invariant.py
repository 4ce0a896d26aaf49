"""The invariant of compact half-edges that others made, level by level."""

from collections.abc import Sequence

from clers.complexes.corner_table import surface
from clers.complexes.face_list import DEFAULT_LIMITS, Limits
from clers.complexes.structures.compact import (
    NONE,
    Level0,
    Level1,
    Level2,
    Level3,
    after,
    compact,
    face_list,
)
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtEntry


def level_0(given: Level0, limits: Limits = DEFAULT_LIMITS) -> Accepted[Level0] | Rejected:
    """The soup itself, or the first fault. Clause: CPLX-COMPACT-3."""
    right = _right(given, limits)
    return right if isinstance(right, Rejected) else Accepted(given)


def _right(given: Level0, limits: Limits) -> Accepted[Level3] | Rejected:
    """All levels, as the construction makes them of a soup that is a surface."""
    if len(given.vertex) % 3:
        whole = len(given.vertex) // 3 * 3
        return _mismatch("vertex", len(given.vertex), whole)
    answer = surface(face_list(given), limits)
    return answer if isinstance(answer, Rejected) else Accepted(compact(answer.value))


def level_1(given: Level1, limits: Limits = DEFAULT_LIMITS) -> Accepted[Level1] | Rejected:
    """The table itself, or the first fault. Clause: CPLX-COMPACT-3."""
    right = _right(given.soup, limits)
    if isinstance(right, Rejected):
        return right
    fault = _bad_level_1(given, right.value)
    return Accepted(given) if fault is None else fault


def level_2(given: Level2, limits: Limits = DEFAULT_LIMITS) -> Accepted[Level2] | Rejected:
    """The cells themselves, or the first fault. Clause: CPLX-COMPACT-3."""
    right = _right(given.table.soup, limits)
    if isinstance(right, Rejected):
        return right
    fault = _bad_level_1(given.table, right.value) or _bad_level_2(given, right.value)
    return Accepted(given) if fault is None else fault


def level_3(given: Level3, limits: Limits = DEFAULT_LIMITS) -> Accepted[Level3] | Rejected:
    """The whole itself, or the first fault. Clause: CPLX-COMPACT-3."""
    right = _right(given.cells.table.soup, limits)
    if isinstance(right, Rejected):
        return right
    fault = (
        _bad_level_1(given.cells.table, right.value)
        or _bad_level_2(given.cells, right.value)
        or _bad_level_3(given, right.value)
    )
    return Accepted(given) if fault is None else fault


def _bad_level_1(given: Level1, right: Level3) -> Rejected | None:
    expected = right.cells.table.opposite
    if len(given.opposite) != len(expected):
        return _mismatch("opposite", len(given.opposite), len(expected))
    wrong = [h for h, other in enumerate(expected) if given.opposite[h] != other]
    return _broken("opposite", wrong[0], given.opposite) if wrong else None


def _bad_level_2(given: Level2, right: Level3) -> Rejected | None:
    for name, array, expected in (
        ("of_vertex", given.of_vertex, right.cells.of_vertex),
        ("edges", given.edges, right.cells.edges),
    ):
        if len(array) != len(expected):
            return _mismatch(name, len(array), len(expected))
    vertex, opposite = right.cells.table.soup.vertex, right.cells.table.opposite
    for v, h in enumerate(given.of_vertex):
        border = opposite[right.cells.of_vertex[v]] == NONE
        if not 0 <= h < len(vertex) or vertex[h] != v or border != (opposite[h] == NONE):
            return _broken("of_vertex", v, given.of_vertex)
    seen: set[int] = set()
    for e, h in enumerate(given.edges):
        if not 0 <= h < len(vertex) or h in seen:
            return _broken("edges", e, given.edges)
        seen |= {h, opposite[h]}
    return None


def _bad_level_3(given: Level3, right: Level3) -> Rejected | None:
    if len(given.curves) != len(right.curves):
        return _mismatch("curves", len(given.curves), len(right.curves))
    vertex, opposite = right.cells.table.soup.vertex, right.cells.table.opposite
    left = {h for h, other in enumerate(opposite) if other == NONE}
    for i, first in enumerate(given.curves):
        if first not in left:
            return _broken("curves", i, given.curves)
        h = first
        while h in left:
            left.remove(h)
            h = right.cells.of_vertex[vertex[after(h)]]
    return None


def _mismatch(name: str, length: int, expected: int) -> Rejected:
    where, detail = AtEntry(name, min(length, expected)), f"{length} entries, and not {expected}"
    return Rejected(Reason.COUNT_MISMATCH, Clause.CPLX_COMPACT_3, where, detail)


def _broken(name: str, entry: int, array: Sequence[int]) -> Rejected:
    where, detail = AtEntry(name, entry), f"{array[entry]}"
    return Rejected(Reason.BROKEN_INVARIANT, Clause.CPLX_COMPACT_3, where, detail)
