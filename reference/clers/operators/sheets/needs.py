"""What operators on sheets look for before they act, and how they say that it is not there.

Clause: OPER-SHEET-5.
"""

from collections.abc import Sequence

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Rejected
from clers.conventions.where import AtVertex, Where
from clers.operators.sheets.sheet import Cell, Sheet, sides, sides_of, simplex, turned, vertices


def refused(clause: Clause, where: Where, detail: str) -> Rejected:
    """An operator cannot be applied. Clause: OPER-SHEET-5."""
    return Rejected(Reason.OPERATOR_NOT_APPLICABLE, clause, where, detail)


def loop_from(sheet: Sheet, a: int, b: int) -> Cell | None:
    """The loop that runs a → b, begun with it; None where no loop does. Linear."""
    for loop in sheet.loops:
        for i, side in enumerate(sides_of(loop)):
            if side == (a, b):
                return loop[i:] + loop[:i]
    return None


def missing(clause: Clause, a: int, b: int) -> Rejected:
    """No loop runs a → b."""
    return refused(clause, simplex(a, b), f"{a}→{b} is on no loop")


def bad_names(
    clause: Clause, sheet: Sheet, different: Sequence[int], new: Sequence[int]
) -> Rejected | None:
    """A vertex named twice, or one that is not new. Clause: OPER-SHEET-5."""
    for i, v in enumerate(different):
        if v in different[:i]:
            return Rejected(Reason.REPEATED_VERTEX, clause, AtVertex(v), "named twice")
    there = vertices(sheet) if new else frozenset()
    for v in new:
        if v < 0 or v in there:
            return refused(clause, AtVertex(v), "no new vertex")
    return None


def there_already(
    clause: Clause, sheet: Sheet, edges: Sequence[tuple[int, int]]
) -> Rejected | None:
    """The first of some edges that is in the sheet. Clause: OPER-SHEET-5."""
    run = frozenset(sides(sheet))
    for a, b in edges:
        if (a, b) in run:
            return Rejected(Reason.DOUBLE_EDGE, clause, simplex(a, b), "joined already")
    return None


def no_triangle(clause: Clause, sheet: Sheet, a: int, b: int, c: int) -> Rejected | None:
    """Is (a, b, c) no triangle of the sheet?"""
    if turned((a, b, c)) in sheet.triangles:
        return None
    return refused(clause, simplex(a, b, c), f"({a}, {b}, {c}) is no triangle")
