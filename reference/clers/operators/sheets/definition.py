"""The operators by definition: loops as a permutation of the sides that they run.

No loop is ever cut or joined here. An operator says which side comes after which, and whether that
makes one loop of two or two of one is seen afterwards. Clause: OPER-SURFACE-8.
"""

from collections.abc import Iterable, Mapping
from itertools import pairwise
from typing import assert_never

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
    TwoHandle,
    Upper,
    UpperStrip,
    ZeroHandle,
    ZeroHandlePolygon,
)
from clers.operators.sheets.sheet import Cell, Sheet, Side, cells_run, sheet_of, sides

After = dict[Side, Side]
"""The side after each side of the loops: a permutation."""


def after_in(loops: Iterable[Cell]) -> After:
    """The permutation of some loops."""
    after: After = {}
    for loop in loops:
        run = list(zip(loop, (*loop[1:], loop[0]), strict=True))
        after.update(pairwise((*run, run[0])))
    return after


def orbit(after: Mapping[Side, Side], side: Side) -> tuple[Side, ...]:
    """The sides of a side's loop, from it on."""
    found = [side]
    while (then := after[found[-1]]) != side:
        found.append(then)
    return tuple(found)


def _before(after: After, side: Side) -> Side:
    return next(y for y, z in after.items() if z == side)


def _rebuilt(
    sheet: Sheet, after: After, triangles: Iterable[Cell] = (), polygons: Iterable[Cell] = ()
) -> Sheet:
    loops = {frozenset(orbit(after, side)): orbit(after, side) for side in after}
    return sheet_of(
        (*sheet.triangles, *triangles),
        (tuple(tail for tail, _ in loop) for loop in loops.values()),
        (*sheet.polygons, *polygons),
    )


def _are_new(sheet: Sheet, names: Cell) -> bool:
    used = {v for cell in cells_run(sheet) for v in cell}
    return len(set(names)) == len(names) and min(names, default=0) >= 0 and used.isdisjoint(names)


def _part(sheet: Sheet, v: int) -> set[int]:
    """The vertices of the component of v."""
    part = {v}
    while more := {w for cell in cells_run(sheet) if part & set(cell) for w in cell} - part:
        part |= more
    return part


def by_definition(operator: Constructive, sheet: Sheet) -> Sheet | None:  # noqa: C901  (one case an operator)
    """The sheet after an operator that makes; None where its needs are not met. OPER-SHEET-5."""
    after = after_in(sheet.loops)
    match operator:
        case MakeSTV(p, q, r) | ZeroHandle(p, q, r):
            if not _are_new(sheet, (p, q, r)):
                return None
            return _rebuilt(sheet, after | after_in([(r, q, p)]), [(p, q, r)])
        case ZeroHandlePolygon(polygon):
            if len(polygon) < 3 or not _are_new(sheet, polygon):
                return None
            return _rebuilt(sheet, after | after_in([polygon]), (), [polygon])
        case MakeEV(a, b, v):
            if not _are_new(sheet, (v,)) or (a, b) not in after:
                return None
            y = _before(after, (a, b))
            return _rebuilt(sheet, after | {y: (a, v), (a, v): (v, a), (v, a): (a, b)})
        case MakeTE(a, b, c) | Complete(a, b, c):
            return _completed(sheet, after, (a, b), (b, c))
        case MakeSG(a, b, c) | TwoHandle(a, b, c):
            loop = ((a, b), (b, c), (c, a))
            known = {frozenset(triangle) for triangle in sheet.triangles}
            if (a, b) not in after or orbit(after, (a, b)) != loop or {a, b, c} in known:
                return None
            return _rebuilt(sheet, {x: y for x, y in after.items() if x not in loop}, [(a, b, c)])
        case MakeEKL(a, b, c, d):
            return _edge(sheet, after, (a, b), (c, d))
        case Glue(a, b, v):
            if not _are_new(sheet, (v,)) or (a, b) not in after:
                return None
            return attached(sheet, (a, b), v, None)
        case Join() | Lower() | Upper():
            return _one_handle(sheet, operator)
        case JoinStrip(a, b, c, d):
            half = by_definition(Join(a, b, c, d), sheet)
        case LowerStrip(a, b, c, d):
            half = by_definition(Lower(a, b, c, d), sheet)
        case UpperStrip(a, b, c, d):
            half = by_definition(Upper(a, b, c, d), sheet)
        case _:
            assert_never(operator)
    return None if half is None else _completed(half, after_in(half.loops), (a, c), (c, d))


def _completed(sheet: Sheet, after: After, first: Side, second: Side) -> Sheet | None:
    (a, b), c = first, second[1]
    if after.get(first) != second or a == c or (a, c) in set(sides(sheet)):
        return None
    then = after | {_before(after, first): (a, c), (a, c): after[second]}
    del then[first], then[second]
    return _rebuilt(sheet, then, [(a, b, c)])


def _edge(sheet: Sheet, after: After, first: Side, second: Side) -> Sheet | None:
    a, c = first[0], second[0]
    if first not in after or second not in after or second in orbit(after, first):
        return None
    if a == c or (a, c) in set(sides(sheet)):
        return None
    return _rebuilt(
        sheet,
        after
        | {
            _before(after, first): (a, c),
            (a, c): second,
            _before(after, second): (c, a),
            (c, a): first,
        },
    )


def _one_handle(sheet: Sheet, operator: OneHandle) -> Sheet | None:
    first, second = (operator.a, operator.b), (operator.c, operator.d)
    after, c = after_in(sheet.loops), operator.c
    if c in first or first not in after or second not in after:
        return None
    edges = set(sides(sheet))
    if (c, operator.a) in edges or (operator.b, c) in edges:
        return None
    same_part, same_loop = c in _part(sheet, operator.a), second in orbit(after, first)
    kind = Lower if same_loop else Upper if same_part else Join
    return attached(sheet, first, c, second) if type(operator) is kind else None


def attached(sheet: Sheet, gate: Side, third: int, corner: Side | None) -> Sheet:
    """A generic attachment at a side that a loop runs. Clause: OPER-SURFACE-8.

    `corner`: the side that leaves the third vertex at the place where the triangle comes; None
    where that vertex is new. Two new edges are made.
    """
    (a, b), c = gate, third
    after = after_in(sheet.loops)
    then = after[gate]
    after[_before(after, gate)] = (a, c)
    if corner is None:
        after[a, c] = (c, b)
    else:
        after[_before(after, corner)] = (c, b)
        after[a, c] = corner
    after[c, b] = then
    del after[gate]
    return _rebuilt(sheet, after, [(a, b, c)])
