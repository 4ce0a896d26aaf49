"""The table of what each handle operator changes, as data; the operators never look at it."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from clers.operators.handles import (
    Attach,
    CompleteAfter,
    CompleteBefore,
    Growing,
    LowerHandle,
    OneHandle,
    Operator,
    TwoHandle,
    UpperHandle,
    ZeroHandle,
    ZeroHandlePolygon,
)


@dataclass(frozen=True, slots=True)
class Change:
    """Differences of the numbers of a growing surface. Clause: OPER-EFFECT-1."""

    faces: int
    vertices: int
    euler: int
    genus: int
    loops: int
    components: int


TABLE: Final[Mapping[type[Operator], Change]] = MappingProxyType(
    {
        ZeroHandle: Change(1, 3, 1, 0, 1, 1),
        ZeroHandlePolygon: Change(0, 0, 1, 0, 1, 1),  # and as many vertices as edges
        Attach: Change(1, 1, 0, 0, 0, 0),
        CompleteAfter: Change(1, 0, 0, 0, 0, 0),
        CompleteBefore: Change(1, 0, 0, 0, 0, 0),
        LowerHandle: Change(1, 0, -1, 0, 1, 0),
        UpperHandle: Change(1, 0, -1, 1, -1, 0),
        OneHandle: Change(1, 0, -1, 0, -1, -1),
        TwoHandle: Change(1, 0, 1, 0, -1, 0),
    }
)
"""The rows of OPER-EFFECT-1; that of a polygon is `row`'s to complete."""


def row(operator: Operator) -> Change:
    """What an operator changes where it applies. Clause: OPER-EFFECT-1."""
    found = TABLE[type(operator)]
    if not isinstance(operator, ZeroHandlePolygon):
        return found
    return Change(
        found.faces, operator.edges, found.euler, found.genus, found.loops, found.components
    )


def change(before: Growing, after: Growing) -> Change:
    """The differences between two growing surfaces."""
    return Change(
        len(after.faces) - len(before.faces),
        after.vertices - before.vertices,
        after.euler - before.euler,
        after.genus - before.genus,
        len(after.loops) - len(before.loops),
        after.components - before.components,
    )
