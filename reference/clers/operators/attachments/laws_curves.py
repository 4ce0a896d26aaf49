"""The laws of the operators of curves."""

from typing import Final, assert_never

from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Holds, Verdict
from clers.operators.attachments.apply import apply
from clers.operators.attachments.attachment import attach
from clers.operators.attachments.curves import (
    TABLE,
    CurveCase,
    curve_case,
    curve_change,
    is_curve,
)
from clers.operators.attachments.given import CURVE_STEPS, CurveStep
from clers.operators.attachments.operator import (
    EdgeAndVertex,
    EdgeAtInterior,
    EdgeBetweenEnds,
    FirstVertex,
    parts,
)

_BRANCHING: Final = frozenset(CurveCase) - {
    CurveCase.FIRST_VERTEX,
    CurveCase.MEV_AT_END,
    CurveCase.CLOSES,
    CurveCase.JOINS,
}


def _effect(step: CurveStep) -> Verdict:
    """The numbers change as the table says."""
    after = apply(step.operator, step.before)
    if isinstance(after, Rejected):
        return Holds()
    row = TABLE[curve_case(step.before, step.operator)]
    return same(row, curve_change(step.before, after.value))


def _kept(step: CurveStep) -> Verdict:
    """A curve stays one exactly if the operator's row is not one of an interior vertex."""
    after = apply(step.operator, step.before)
    if isinstance(after, Rejected) or not is_curve(step.before):
        return Holds()
    branches = curve_case(step.before, step.operator) in _BRANCHING
    return same(not branches, is_curve(after.value))


def _applies(step: CurveStep) -> Verdict:
    """An operator applies exactly if it is an attachment that applies, and its ends are so."""
    k, operator = step.before, step.operator
    (glued,) = parts(operator)
    edges = [s for s in k.simplices if len(s) == 2]

    def degree(vertex: int) -> int:
        return len([edge for edge in edges if vertex in edge])

    match operator:
        case FirstVertex() | EdgeAndVertex():
            good = True
        case EdgeBetweenEnds(one, other):
            good = degree(one) <= 1 and degree(other) <= 1
        case EdgeAtInterior(interior):
            good = degree(interior) >= 2
        case _:
            assert_never(operator)
    flat = all(len(s) <= 2 for s in k.simplices)
    expected = flat and good and isinstance(attach(k, glued), Accepted)
    return same(expected, isinstance(apply(operator, k), Accepted))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "curve-operator-applies",
        Clause.OPER_CURVE_1,
        "It applies to complexes of vertices and edges, exactly where its ends are as it asks.",
        CURVE_STEPS,
        _applies,
    ),
    Law(
        "curve-effect-in-table",
        Clause.OPER_CURVE_6,
        "An operator of curves changes #0, #1, χ, components, b_1 and ends as the table says.",
        CURVE_STEPS,
        _effect,
    ),
    Law(
        "curve-stays-a-curve",
        Clause.OPER_CURVE_7,
        "A curve stays one exactly if no edge is put to an interior vertex.",
        CURVE_STEPS,
        _kept,
    ),
)
