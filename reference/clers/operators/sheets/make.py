"""The operators that make: five of Euler, the handle operators, and strips of two triangles."""

from collections.abc import Iterable
from dataclasses import replace
from typing import Final, assert_never

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.operators.sheets.needs import (
    bad_names,
    loop_from,
    missing,
    refused,
    there_already,
)
from clers.operators.sheets.operator import (
    Complete,
    Constructive,
    Glue,
    Join,
    JoinStrip,
    Lower,
    LowerStrip,
    MakeEKL,
    MakeEV,
    MakeSG,
    MakeSTV,
    MakeTE,
    OneHandle,
    Strip,
    TwoHandle,
    Upper,
    UpperStrip,
    ZeroHandle,
    ZeroHandlePolygon,
)
from clers.operators.sheets.sheet import (
    SHORTEST_RING,
    Cell,
    Sheet,
    component,
    sides_of,
    simplex,
    turned,
)
from clers.operators.sheets.surgery import beyond, cut, joined, past_next

Result = Accepted[Sheet] | Rejected

CLAUSE_OF: Final = {
    Join: Clause.OPER_SURFACE_4,
    Lower: Clause.OPER_SURFACE_5,
    Upper: Clause.OPER_SURFACE_6,
}


def made(operator: Constructive, sheet: Sheet) -> Result:
    """An operator that makes, on a sheet. Total.

    Clauses: OPER-EULER-1 … OPER-EULER-5, OPER-SURFACE-1 … OPER-SURFACE-7, OPER-SURFACE-9.
    """
    match operator:
        case MakeSTV(p, q, r):
            return _triangle(sheet, (p, q, r), Clause.OPER_EULER_1)
        case ZeroHandle(p, q, r):
            return _triangle(sheet, (p, q, r), Clause.OPER_SURFACE_1)
        case ZeroHandlePolygon(polygon):
            return _polygon(sheet, polygon)
        case MakeEV(a, b, v):
            return _spike(sheet, a, b, v)
        case MakeTE(a, b, c):
            return _complete(sheet, a, b, c, Clause.OPER_EULER_3)
        case Complete(a, b, c):
            return _complete(sheet, a, b, c, Clause.OPER_SURFACE_2)
        case MakeSG(a, b, c):
            return _close(sheet, a, b, c, Clause.OPER_EULER_4)
        case TwoHandle(a, b, c):
            return _close(sheet, a, b, c, Clause.OPER_SURFACE_7)
        case MakeEKL(a, b, c, d):
            return _edge(sheet, a, b, c, d)
        case Glue(a, b, v):
            return _glue(sheet, a, b, v)
        case Join() | Lower() | Upper():
            return _one_handle(sheet, operator)
        case JoinStrip() | LowerStrip() | UpperStrip():
            return and_then(
                _one_handle(sheet, first_of(operator)),
                lambda half: made(second_of(operator), half),
            )
        case _:
            assert_never(operator)


def first_of(strip: Strip) -> OneHandle:
    """The attachment of a strip's first triangle. Clause: OPER-SURFACE-9."""
    match strip:
        case JoinStrip(a, b, c, d):
            return Join(a, b, c, d)
        case LowerStrip(a, b, c, d):
            return Lower(a, b, c, d)
        case UpperStrip(a, b, c, d):
            return Upper(a, b, c, d)
        case _:
            assert_never(strip)


def second_of(strip: Strip) -> MakeTE:
    """The triangle that fattens the pinch. Clause: OPER-SURFACE-9."""
    return MakeTE(strip.a, strip.c, strip.d)


def changed(
    sheet: Sheet, triangle: Cell, loops: Iterable[Cell], instead_of: Iterable[Cell]
) -> Accepted[Sheet]:
    """One more triangle (none if empty), and some loops instead of others, begun anywhere."""
    triangles = sheet.triangles | {turned(triangle)} if triangle else sheet.triangles
    kept = sheet.loops - frozenset(map(turned, instead_of))
    return Accepted(replace(sheet, triangles=triangles, loops=kept | frozenset(map(turned, loops))))


def _triangle(sheet: Sheet, triangle: Cell, clause: Clause) -> Result:
    bad = bad_names(clause, sheet, triangle, triangle)
    return bad or changed(sheet, triangle, (triangle[::-1],), ())


def _polygon(sheet: Sheet, polygon: Cell) -> Result:
    clause = Clause.OPER_SURFACE_1
    bad = bad_names(clause, sheet, polygon, polygon)
    if bad is not None:
        return bad
    if len(polygon) < SHORTEST_RING:
        return refused(clause, simplex(*polygon), f"a polygon of {len(polygon)} edges")
    ring = turned(polygon)
    return Accepted(replace(sheet, polygons=sheet.polygons | {ring}, loops=sheet.loops | {ring}))


def _spike(sheet: Sheet, a: int, b: int, v: int) -> Result:
    clause = Clause.OPER_EULER_2
    bad = bad_names(clause, sheet, (a, b, v), (v,))
    if bad is not None:
        return bad
    loop = loop_from(sheet, a, b)
    if loop is None:
        return missing(clause, a, b)
    return changed(sheet, (), ((a, v, *loop),), (loop,))


def _complete(sheet: Sheet, a: int, b: int, c: int, clause: Clause) -> Result:
    bad = bad_names(clause, sheet, (a, b, c), ())
    if bad is not None:
        return bad
    loop = loop_from(sheet, a, b)
    if loop is None:
        return missing(clause, a, b)
    if loop[2 % len(loop)] != c:
        return refused(clause, simplex(b, c), f"{b}→{c} does not follow {a}→{b}")
    # On a loop of three edges ca is one of them: that is a 2-handle's.
    bad = there_already(clause, sheet, ((a, c),))
    return bad or changed(sheet, (a, b, c), (past_next(loop),), (loop,))


def _close(sheet: Sheet, a: int, b: int, c: int, clause: Clause) -> Result:
    bad = bad_names(clause, sheet, (a, b, c), ())
    if bad is not None:
        return bad
    if turned((a, b, c)) not in sheet.loops:
        return refused(clause, simplex(a, b, c), f"[{a}, {b}, {c}] is no loop")
    if turned((c, b, a)) in sheet.triangles:
        return Rejected(Reason.DUPLICATE_FACE, clause, simplex(a, b, c), "the other side is there")
    return changed(sheet, (a, b, c), (), ((a, b, c),))


def _edge(sheet: Sheet, a: int, b: int, c: int, d: int) -> Result:
    clause = Clause.OPER_EULER_5
    bad = bad_names(clause, sheet, (a, c), ())
    if bad is not None:
        return bad
    loop, other = loop_from(sheet, a, b), loop_from(sheet, c, d)
    if loop is None:
        return missing(clause, a, b)
    if other is None:
        return missing(clause, c, d)
    if turned(loop) == turned(other):
        return refused(clause, simplex(c, d), f"{c}→{d} is on the loop of {a}→{b}")
    bad = there_already(clause, sheet, ((a, c),))
    return bad or changed(sheet, (), ((a, *other, c, *loop),), (loop, other))


def _glue(sheet: Sheet, a: int, b: int, v: int) -> Result:
    clause = Clause.OPER_SURFACE_3
    bad = bad_names(clause, sheet, (a, b, v), (v,))
    if bad is not None:
        return bad
    loop = loop_from(sheet, a, b)
    if loop is None:
        return missing(clause, a, b)
    return changed(sheet, (a, b, v), (beyond(loop, v),), (loop,))


def _one_handle(sheet: Sheet, operator: OneHandle) -> Result:
    a, b, c, d = operator.a, operator.b, operator.c, operator.d
    clause = CLAUSE_OF[type(operator)]
    bad = bad_names(clause, sheet, (a, b, c), ())
    if bad is not None:
        return bad
    loop, other = loop_from(sheet, a, b), loop_from(sheet, c, d)
    if loop is None:
        return missing(clause, a, b)
    if other is None:
        return missing(clause, c, d)
    one_loop = turned(loop) == turned(other)
    if one_loop != isinstance(operator, Lower):
        return refused(
            clause, simplex(c, d), f"{c}→{d} is on {'the' if one_loop else 'another'} loop"
        )
    part = component(sheet)
    if (part[a] == part[c]) == isinstance(operator, Join):
        return refused(clause, simplex(c, d), f"not so are the components of {a}→{b} and {c}→{d}")
    bad = there_already(clause, sheet, ((b, c), (c, a)))
    if bad is not None:
        return bad
    if one_loop:
        at = list(sides_of(loop)).index((c, d))
        return changed(sheet, (a, b, c), cut(loop, at), (loop,))
    return changed(sheet, (a, b, c), (joined(loop, other),), (loop, other))
