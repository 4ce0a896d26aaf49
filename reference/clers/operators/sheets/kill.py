"""Undo: each operator's inverse, by finding what the operator left and taking it away."""

from dataclasses import replace
from typing import assert_never

from clers.conventions.clause import Clause
from clers.conventions.result import Accepted, and_then
from clers.operators.sheets.make import CLAUSE_OF, Result, first_of, second_of
from clers.operators.sheets.needs import loop_from, missing, no_triangle, refused
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
    TwoHandle,
    Upper,
    UpperStrip,
    ZeroHandle,
    ZeroHandlePolygon,
)
from clers.operators.sheets.sheet import Cell, Sheet, component, sides_of, simplex, turned


def undone(operator: Constructive, sheet: Sheet) -> Result:
    """The sheet that the operator made this one of. Total. Clause: OPER-SHEET-6."""
    match operator:
        case MakeSTV(p, q, r):
            return _last_triangle(sheet, (p, q, r), Clause.OPER_EULER_1)
        case ZeroHandle(p, q, r):
            return _last_triangle(sheet, (p, q, r), Clause.OPER_SURFACE_1)
        case ZeroHandlePolygon(polygon):
            return _polygon(sheet, polygon)
        case MakeEV(a, b, v):
            return _spike(sheet, a, b, v)
        case MakeTE(a, b, c):
            return _completed(sheet, a, b, c, Clause.OPER_EULER_3)
        case Complete(a, b, c):
            return _completed(sheet, a, b, c, Clause.OPER_SURFACE_2)
        case MakeSG(a, b, c):
            return _closed(sheet, a, b, c, Clause.OPER_EULER_4)
        case TwoHandle(a, b, c):
            return _closed(sheet, a, b, c, Clause.OPER_SURFACE_7)
        case MakeEKL(a, b, c, d):
            return _edge(sheet, a, b, c, d)
        case Glue(a, b, v):
            return _glued(sheet, a, b, v)
        case Lower():
            return _lower(sheet, operator)
        case Join() | Upper():
            return _joining(sheet, operator)
        case JoinStrip() | LowerStrip() | UpperStrip():
            return and_then(
                undone(second_of(operator), sheet),
                lambda half: undone(first_of(operator), half),
            )
        case _:
            assert_never(operator)


def _without(
    sheet: Sheet, triangle: Cell, loops: tuple[Cell, ...], instead_of: tuple[Cell, ...]
) -> Accepted[Sheet]:
    """A triangle less (none if empty), and some loops instead of others, begun anywhere."""
    triangles = sheet.triangles - {turned(triangle)} if triangle else sheet.triangles
    kept = sheet.loops - frozenset(map(turned, instead_of))
    return Accepted(replace(sheet, triangles=triangles, loops=kept | frozenset(map(turned, loops))))


def _last_triangle(sheet: Sheet, triangle: Cell, clause: Clause) -> Result:
    around = triangle[::-1]
    bad = no_triangle(clause, sheet, *triangle[:3])
    if bad is not None:
        return bad
    if turned(around) not in sheet.loops:
        return refused(clause, simplex(*triangle), "not a component by itself")
    return _without(sheet, triangle, (), (around,))


def _polygon(sheet: Sheet, polygon: Cell) -> Result:
    ring = turned(polygon) if polygon else ()
    if ring not in sheet.polygons or ring not in sheet.loops:
        where = simplex(*polygon)
        return refused(Clause.OPER_SURFACE_1, where, "no infinite face by itself")
    return Accepted(replace(sheet, polygons=sheet.polygons - {ring}, loops=sheet.loops - {ring}))


def _spike(sheet: Sheet, a: int, b: int, v: int) -> Result:
    clause = Clause.OPER_EULER_2
    loop = loop_from(sheet, a, v)
    if loop is None:
        return missing(clause, a, v)
    rest = loop[2:]
    if rest[:2] != (a, b):
        return refused(clause, simplex(a, v), f"{v}→{a}→{b} does not follow {a}→{v}")
    return _without(sheet, (), (rest,), (loop,))


def _completed(sheet: Sheet, a: int, b: int, c: int, clause: Clause) -> Result:
    bad = no_triangle(clause, sheet, a, b, c)
    if bad is not None:
        return bad
    loop = loop_from(sheet, a, c)
    if loop is None:
        return missing(clause, a, c)
    return _without(sheet, (a, b, c), ((a, b, *loop[1:]),), (loop,))


def _closed(sheet: Sheet, a: int, b: int, c: int, clause: Clause) -> Result:
    bad = no_triangle(clause, sheet, a, b, c)
    return bad or _without(sheet, (a, b, c), ((a, b, c),), ())


def _edge(sheet: Sheet, a: int, b: int, c: int, d: int) -> Result:
    clause = Clause.OPER_EULER_5
    loop = loop_from(sheet, a, c)
    if loop is None:
        return missing(clause, a, c)
    back = _place(loop, c, a)
    if back < 0:
        return refused(clause, simplex(a, c), f"{c}→{a} is not on the loop of {a}→{c}")
    other, rest = loop[1:back], loop[back + 1 :]
    if other[:2] != (c, d) or rest[:2] != (a, b):
        return refused(clause, simplex(a, c), f"{c}→{d} or {a}→{b} does not follow")
    return _without(sheet, (), (other, rest), (loop,))


def _place(loop: Cell, a: int, b: int) -> int:
    """Where a loop runs a → b; −1 where it does not."""
    return next((i for i, side in enumerate(sides_of(loop)) if side == (a, b)), -1)


def _glued(sheet: Sheet, a: int, b: int, v: int) -> Result:
    clause = Clause.OPER_SURFACE_3
    bad = no_triangle(clause, sheet, a, b, v)
    if bad is not None:
        return bad
    loop = loop_from(sheet, a, v)
    if loop is None:
        return missing(clause, a, v)
    if loop[2:3] != (b,):
        return refused(clause, simplex(b, v), f"{v}→{b} does not follow {a}→{v}")
    return _without(sheet, (a, b, v), ((a, *loop[2:]),), (loop,))


def _lower(sheet: Sheet, operator: Lower) -> Result:
    a, b, c, d = operator.a, operator.b, operator.c, operator.d
    clause = CLAUSE_OF[Lower]
    bad = no_triangle(clause, sheet, a, b, c)
    if bad is not None:
        return bad
    upper, lower = loop_from(sheet, c, b), loop_from(sheet, a, c)
    if upper is None:
        return missing(clause, c, b)
    if lower is None:
        return missing(clause, a, c)
    if turned(upper) == turned(lower):
        return refused(clause, simplex(a, b, c), f"{a}→{c} and {c}→{b} are on one loop")
    if lower[2:3] != (d,):
        return refused(clause, simplex(c, d), f"{c}→{d} does not follow {a}→{c}")
    return _without(sheet, (a, b, c), ((a, *upper[1:], *lower[1:]),), (upper, lower))


def _joining(sheet: Sheet, operator: Join | Upper) -> Result:
    a, b, c, d = operator.a, operator.b, operator.c, operator.d
    clause = CLAUSE_OF[type(operator)]
    bad = no_triangle(clause, sheet, a, b, c)
    if bad is not None:
        return bad
    loop = loop_from(sheet, a, c)
    if loop is None:
        return missing(clause, a, c)
    back = _place(loop, c, b)
    if back < 0:
        return refused(clause, simplex(b, c), f"{c}→{b} is not on the loop of {a}→{c}")
    other = loop[1:back]
    if other[:2] != (c, d):
        return refused(clause, simplex(c, d), f"{c}→{d} does not follow {a}→{c}")
    before = _without(sheet, (a, b, c), (other, (a, *loop[back + 1 :])), (loop,))
    part = component(before.value)
    if (part[a] == part[c]) == isinstance(operator, Join):
        return refused(clause, simplex(a, b, c), f"not so are the components of {a} and {c}")
    return before
