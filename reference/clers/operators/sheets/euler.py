"""Scripts by Euler operators alone: what handle operators are composed of. OPER-BUILD-4."""

from typing import assert_never

from clers.conventions.result import Accepted, Rejected
from clers.operators.sheets.apply import apply
from clers.operators.sheets.make import first_of, second_of
from clers.operators.sheets.needs import loop_from
from clers.operators.sheets.operator import (
    Complete,
    Constructive,
    Euler,
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
    Script,
    TwoHandle,
    Undo,
    Upper,
    UpperStrip,
    ZeroHandle,
    ZeroHandlePolygon,
    taken_apart,
)
from clers.operators.sheets.sheet import EMPTY, Cell, Sheet, vertices


def euler(script: Script, start: Sheet = EMPTY) -> Accepted[Script] | Rejected:
    """A script that applies, by Euler operators; else its rejection. Clause: OPER-BUILD-4.

    0-handles with a polygon stay: no Euler operator makes an infinite face.
    """
    sheet, translated = start, list[Constructive | Undo]()
    for operator in script:
        after = apply(operator, sheet)
        if isinstance(after, Rejected):
            return after
        if isinstance(operator, Undo):
            translated += taken_apart(composed(operator.of, after.value))
        else:
            translated += composed(operator, sheet)
        sheet = after.value
    return Accepted(tuple(translated))


def composed(operator: Constructive, sheet: Sheet) -> Script:
    """The Euler operators that an operator, which applies to the sheet, is composed of.

    Clauses: OPER-SURFACE-1 … OPER-SURFACE-7, OPER-SURFACE-9, OPER-BUILD-4.
    """
    match operator:
        case MakeSTV() | MakeEV() | MakeTE() | MakeSG() | MakeEKL() | ZeroHandlePolygon():
            return (operator,)
        case ZeroHandle(p, q, r):
            return (MakeSTV(p, q, r),)
        case Complete(a, b, c):
            return (MakeTE(a, b, c),)
        case TwoHandle(a, b, c):
            return (MakeSG(a, b, c),)
        case Glue(a, b, v):
            return MakeEV(b, _next(sheet, a, b), v), MakeTE(a, b, v)
        case Join(a, b, c, d) | Upper(a, b, c, d):
            return MakeEKL(b, _next(sheet, a, b), c, d), MakeTE(a, b, c)
        case Lower(a, b, c, d):
            loop = loop_from(sheet, a, b) or ()
            return *chord(loop[1 : _corner(loop, c, d) + 1], max(vertices(sheet))), MakeTE(a, b, c)
        case JoinStrip() | LowerStrip() | UpperStrip():
            return *composed(first_of(operator), sheet), second_of(operator)
        case _:
            assert_never(operator)


def _next(sheet: Sheet, a: int, b: int) -> int:
    loop = loop_from(sheet, a, b) or (a, b)
    return loop[2 % len(loop)]


def _corner(loop: Cell, c: int, d: int) -> int:
    return list(zip(loop, (*loop[1:], loop[0]), strict=True)).index((c, d))


def chord(s: Cell, last: int) -> Script:
    """An edge between the ends of a piece of a loop, with nothing behind it but a loop.

    A disk of triangles with new vertices last+1 … is put on the piece, opened beside the edge, and
    taken away again. Clause: OPER-BUILD-4.
    """
    m = len(s) - 1
    z = range(last, last + m + 1)
    scaffold: list[Euler] = [MakeEV(s[0], s[1], z[1]), MakeTE(z[1], s[0], s[1])]
    for i in range(2, m + 1):
        scaffold += [
            MakeEV(z[i - 1], s[i - 1], z[i]),
            MakeTE(z[i], z[i - 1], s[i - 1]),
            MakeTE(z[i], s[i - 1], s[i]),
        ]
    scaffold += [MakeTE(z[1], z[i - 1], z[i]) for i in range(3, m + 1)]
    scaffold.append(MakeTE(z[1], z[m], s[m]))
    last_triangle = s[0], z[1], s[m]
    return (
        *scaffold,
        MakeTE(*last_triangle),
        Undo(MakeSG(*last_triangle)),
        *taken_apart(tuple(scaffold)),
    )
