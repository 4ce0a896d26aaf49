"""Handle operators at a gate are operators on sheets, applied where the gate is. OPER-SHEET-7."""

from typing import assert_never

from clers.operators import handles as gate
from clers.operators.handles import Growing
from clers.operators.sheets.operator import (
    Complete,
    Constructive,
    Glue,
    Join,
    Lower,
    TwoHandle,
    Upper,
    ZeroHandle,
    ZeroHandlePolygon,
)
from clers.operators.sheets.sheet import Sheet, sheet_of


def sheet_of_growing(grown: Growing) -> Sheet:
    """A growing surface without its stack, its gate and its order of faces. OPER-SHEET-7."""
    return sheet_of(grown.faces, grown.loops, grown.polygons)


def at_gate(operator: gate.Operator, grown: Growing) -> Constructive:
    """The operator on sheets that one which applies at the gate is. Clause: OPER-SHEET-7."""
    new = grown.vertices
    match operator:
        case gate.ZeroHandle():
            return ZeroHandle(new, new + 1, new + 2)
        case gate.ZeroHandlePolygon(edges):
            return ZeroHandlePolygon(tuple(range(new, new + edges)))
        case gate.OneHandle():
            *_, (a, b, *_), (c, d, *_) = grown.loops
            return Join(a, b, c, d)
        case gate.UpperHandle(below, at):
            other, (a, b, *_) = grown.loops[-1 - below], grown.loops[-1]
            return Upper(a, b, other[at], other[(at + 1) % len(other)])
        case gate.Attach():
            a, b, *_ = grown.loops[-1]
            return Glue(a, b, new)
        case gate.CompleteAfter():
            a, b, c, *_ = grown.loops[-1]
            return Complete(a, b, c)
        case gate.CompleteBefore():
            a, b, *_, z = grown.loops[-1]
            return Complete(z, a, b)
        case gate.LowerHandle(at):
            loop = grown.loops[-1]
            return Lower(loop[0], loop[1], loop[at], loop[at + 1])
        case gate.TwoHandle():
            a, b, c = grown.loops[-1]
            return TwoHandle(a, b, c)
        case _:
            assert_never(operator)
