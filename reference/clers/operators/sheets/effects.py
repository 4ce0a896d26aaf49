"""The table of what each operator changes, as data; the operators never look at it."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from clers.operators.sheets.numbers import Numbers
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
    Operator,
    TwoHandle,
    Undo,
    Upper,
    UpperStrip,
    ZeroHandle,
    ZeroHandlePolygon,
)

INITIAL: Final = Numbers(3, 3, 1, 1, 1, 0, 1)
COMPLETING: Final = Numbers(0, 1, 1, 0, 0, 0, 0)
CLOSING: Final = Numbers(0, 0, 1, 1, 0, 0, -1)

TABLE: Final[Mapping[type[Constructive], tuple[Numbers, ...]]] = MappingProxyType(
    {
        MakeSTV: (INITIAL,),
        ZeroHandle: (INITIAL,),
        ZeroHandlePolygon: (Numbers(0, 0, 1, 1, 1, 0, 1),),  # and its vertices and edges
        MakeEV: (Numbers(1, 1, 0, 0, 0, 0, 0),),
        MakeTE: (COMPLETING,),
        Complete: (COMPLETING,),
        MakeSG: (CLOSING,),
        TwoHandle: (CLOSING,),
        MakeEKL: (Numbers(0, 1, 0, -1, 0, 1, -1), Numbers(0, 1, 0, -1, -1, 0, -1)),
        Glue: (Numbers(1, 2, 1, 0, 0, 0, 0),),
        Join: (Numbers(0, 2, 1, -1, -1, 0, -1),),
        Lower: (Numbers(0, 2, 1, -1, 0, 0, 1),),
        Upper: (Numbers(0, 2, 1, -1, 0, 1, -1),),
        JoinStrip: (Numbers(0, 3, 2, -1, -1, 0, -1),),
        LowerStrip: (Numbers(0, 3, 2, -1, 0, 0, 1),),
        UpperStrip: (Numbers(0, 3, 2, -1, 0, 1, -1),),
    }
)
"""The rows of OPER-EFFECT-2; that of a polygon is `rows`'s to complete."""


def rows(operator: Operator) -> tuple[Numbers, ...]:
    """What an operator may change where it applies. Clause: OPER-EFFECT-2.

    One row, but for MEKL and its inverse: one for loops of one component, one for loops of two.
    """
    match operator:
        case Undo(of):
            return tuple(-row for row in rows_of(of))
        case _:
            return rows_of(operator)


def rows_of(operator: Constructive) -> tuple[Numbers, ...]:
    """The rows of an operator that makes. Clause: OPER-EFFECT-2."""
    found = TABLE[type(operator)]
    if not isinstance(operator, ZeroHandlePolygon):
        return found
    edges = len(operator.polygon)
    return tuple(
        Numbers(edges, edges, n.faces, n.euler, n.components, n.genus, n.loops) for n in found
    )
