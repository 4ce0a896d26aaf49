"""The operators of curves: which row of the effect table each has, and the rows."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType
from typing import Final, assert_never

from clers.complexes.homology import Field, betti
from clers.complexes.simplicial import Complex, euler, of_dimension, pieces
from clers.operators.attachments.apply import valence
from clers.operators.attachments.operator import (
    CurveOperator,
    EdgeAndVertex,
    EdgeAtInterior,
    EdgeBetweenEnds,
    FirstVertex,
)


class CurveCase(StrEnum):
    """The rows of OPER-CURVE-6."""

    FIRST_VERTEX = "first vertex"
    MEV_AT_END = "edge and vertex, at a bounding vertex"
    MEV_INSIDE = "edge and vertex, at an interior vertex"
    CLOSES = "edge between two ends of a component"
    JOINS = "edge between ends of two components"
    INSIDE_TO_END = "edge from an interior to a bounding vertex of its component"
    INSIDE_TO_OTHER_END = "edge from an interior to a bounding vertex of another component"
    INSIDE = "edge between two interior vertices of a component"
    INSIDE_TO_OTHER = "edge between interior vertices of two components"


@dataclass(frozen=True, slots=True)
class CurveChange:
    """Changes of #0, #1, χ, components, independent closed curves (b_1), and free ends."""

    vertices: int
    edges: int
    euler: int
    components: int
    cycles: int
    ends: int


TABLE: Final[Mapping[CurveCase, CurveChange]] = MappingProxyType(
    {
        CurveCase.FIRST_VERTEX: CurveChange(1, 0, 1, 1, 0, 2),
        CurveCase.MEV_AT_END: CurveChange(1, 1, 0, 0, 0, 0),
        CurveCase.MEV_INSIDE: CurveChange(1, 1, 0, 0, 0, 1),
        CurveCase.CLOSES: CurveChange(0, 1, -1, 0, 1, -2),
        CurveCase.JOINS: CurveChange(0, 1, -1, -1, 0, -2),
        CurveCase.INSIDE_TO_END: CurveChange(0, 1, -1, 0, 1, -1),
        CurveCase.INSIDE_TO_OTHER_END: CurveChange(0, 1, -1, -1, 0, -1),
        CurveCase.INSIDE: CurveChange(0, 1, -1, 0, 1, 0),
        CurveCase.INSIDE_TO_OTHER: CurveChange(0, 1, -1, -1, 0, 0),
    }
)
"""The rows of OPER-CURVE-6; `curve_change` counts and never looks at them."""


def curve_case(before: Complex, operator: CurveOperator) -> CurveCase:
    """The row of an operator that applies. Clause: OPER-CURVE-6."""
    match operator:
        case FirstVertex():
            return CurveCase.FIRST_VERTEX
        case EdgeAndVertex(at):
            return CurveCase.MEV_AT_END if valence(before, at) < 2 else CurveCase.MEV_INSIDE
        case EdgeBetweenEnds(one, other):
            return CurveCase.CLOSES if _together(before, one, other) else CurveCase.JOINS
        case EdgeAtInterior(interior, other):
            match _together(before, interior, other), valence(before, other) < 2:
                case True, True:
                    return CurveCase.INSIDE_TO_END
                case False, True:
                    return CurveCase.INSIDE_TO_OTHER_END
                case True, False:
                    return CurveCase.INSIDE
                case _:
                    return CurveCase.INSIDE_TO_OTHER
        case _:
            assert_never(operator)


def _together(k: Complex, one: int, other: int) -> bool:
    both = {frozenset([one]), frozenset([other])}
    return any(both <= piece.simplices for piece in pieces(k))


def ends(k: Complex) -> int:
    """Free ends: two at a vertex without edges, one at a vertex of one edge. OPER-CURVE-6."""
    return sum(max(0, 2 - valence(k, min(v))) for v in of_dimension(k, 0))


def curve_change(before: Complex, after: Complex) -> CurveChange:
    """The differences between two complexes of vertices and edges, counted. OPER-CURVE-6."""
    old, new = ((*betti(k, Field.GF2), 0, 0)[:2] for k in (before, after))
    return CurveChange(
        len(of_dimension(after, 0)) - len(of_dimension(before, 0)),
        len(of_dimension(after, 1)) - len(of_dimension(before, 1)),
        euler(after) - euler(before),
        new[0] - old[0],
        new[1] - old[1],
        ends(after) - ends(before),
    )


def is_curve(k: Complex) -> bool:
    """Vertices and edges, and no vertex in three edges: points, arcs and circles. OPER-CURVE-7."""
    return all(len(s) <= 2 and (len(s) > 1 or valence(k, min(s)) <= 2) for s in k.simplices)
