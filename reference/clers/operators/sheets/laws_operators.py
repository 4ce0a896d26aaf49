"""The laws of operators on sheets: what they make, need, change, and that undo undoes them."""

from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE
from clers.operators.sheets.apply import apply
from clers.operators.sheets.definition import by_definition
from clers.operators.sheets.effects import rows
from clers.operators.sheets.euler import composed
from clers.operators.sheets.given import SHEET_STEPS, SheetStep, makers, steps_in_reach
from clers.operators.sheets.numbers import numbers
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
    inverse,
)
from clers.operators.sheets.sheet import Sheet, component, fault

CLAUSES: Final[dict[Clause, tuple[type[Constructive], ...]]] = {
    Clause.OPER_EULER_1: (MakeSTV,),
    Clause.OPER_EULER_2: (MakeEV,),
    Clause.OPER_EULER_3: (MakeTE,),
    Clause.OPER_EULER_4: (MakeSG,),
    Clause.OPER_EULER_5: (MakeEKL,),
    Clause.OPER_SURFACE_1: (ZeroHandle, ZeroHandlePolygon),
    Clause.OPER_SURFACE_2: (Complete,),
    Clause.OPER_SURFACE_3: (Glue,),
    Clause.OPER_SURFACE_4: (Join,),
    Clause.OPER_SURFACE_5: (Lower,),
    Clause.OPER_SURFACE_6: (Upper,),
    Clause.OPER_SURFACE_7: (TwoHandle,),
    Clause.OPER_SURFACE_9: (JoinStrip, LowerStrip, UpperStrip),
}
"""Which operators each clause is about."""


def _law_of(clause: Clause, kinds: tuple[type[Constructive], ...]) -> Law[SheetStep]:
    """The operators of one clause, loops against the permutation of their sides."""

    def as_defined(step: SheetStep) -> Verdict:
        return every(
            *(
                _agree(by_definition(operator, step.before), apply(operator, step.before), clause)
                for operator in makers(step)
                if isinstance(operator, kinds)
            )
        )

    return Law(
        f"as-defined-{clause.lower()}",
        clause,
        "Where its needs are met the operator makes what the permutation of sides says; not else.",
        SHEET_STEPS,
        as_defined,
    )


def _agree(expected: Sheet | None, got: Accepted[Sheet] | Rejected, clause: Clause) -> Verdict:
    match got:
        case Accepted(sheet):
            return same(expected, sheet)
        case Rejected() as rejected:
            if clause in (Clause.OPER_SURFACE_8, Clause.OPER_SURFACE_9):
                return same(expected, None)  # rejected by the clauses that they rest on
            return every(same(expected, None), same(clause, rejected.clause))


def _sheet_again(step: SheetStep) -> Verdict:
    """What an operator makes is a sheet."""
    return every(
        *(
            same(None, fault(after.value))
            for operator in steps_in_reach(step)
            for after in (apply(operator, step.before),)
            if isinstance(after, Accepted)
        )
    )


def _effect(step: SheetStep) -> Verdict:
    """The numbers, counted anew before and after, differ as the table says."""
    return every(
        *(
            _in_table(operator, step.before, after.value)
            for operator in steps_in_reach(step)
            for after in (apply(operator, step.before),)
            if isinstance(after, Accepted)
        )
    )


def _in_table(operator: Operator, before: Sheet, after: Sheet) -> Verdict:
    expected = rows(operator)
    if len(expected) == 2:  # MEKL: the row is that of the components apart
        what, apart = (operator.of, after) if isinstance(operator, Undo) else (operator, before)
        part = component(apart)
        one = isinstance(what, MakeEKL) and part[what.a] == part[what.c]
        expected = expected[:1] if one else expected[1:]
    return same(expected, (numbers(after) - numbers(before),))


def _undo(step: SheetStep) -> Verdict:
    """Undo after make is nothing, and make after undo is nothing."""
    return every(
        *(
            same(Accepted(step.before), apply(inverse(operator), after.value))
            for operator in steps_in_reach(step)
            for after in (apply(operator, step.before),)
            if isinstance(after, Accepted)
        ),
        *(same(operator, inverse(inverse(operator))) for operator in steps_in_reach(step)),
    )


REASONS: Final = (
    Reason.REPEATED_VERTEX,
    Reason.OPERATOR_NOT_APPLICABLE,
    Reason.DOUBLE_EDGE,
    Reason.DUPLICATE_FACE,
)


def _refusal(step: SheetStep) -> Verdict:
    """Every rejection has one of four reasons, that of undo the second, and blames something."""
    for operator in steps_in_reach(step):
        after = apply(operator, step.before)
        if isinstance(after, Rejected):
            reasons = REASONS[1:2] if isinstance(operator, Undo) else REASONS
            if after.reason not in reasons or after.where == WHOLE:
                return Fails(repr(reasons), after.line(), after.where)
    return Holds()


def _composed(step: SheetStep) -> Verdict:
    """Where an operator applies, the Euler operators that it is composed of make the same."""
    return every(
        *(
            same(after, _folded(composed(operator, step.before), step.before))
            for operator in makers(step)
            for after in (apply(operator, step.before),)
            if isinstance(after, Accepted)
        )
    )


def _folded(script: tuple[Operator, ...], sheet: Sheet) -> Accepted[Sheet] | Rejected:
    result: Accepted[Sheet] | Rejected = Accepted(sheet)
    for operator in script:
        if isinstance(result, Accepted):
            result = apply(operator, result.value)
    return result


LAWS: Final[tuple[AnyLaw, ...]] = (
    *(_law_of(clause, kinds) for clause, kinds in CLAUSES.items()),
    Law(
        "attachment-by-permutation",
        Clause.OPER_SURFACE_8,
        "Gluing and the three 1-handles are one rule on the permutation of sides.",
        SHEET_STEPS,
        _law_of(Clause.OPER_SURFACE_8, (Glue, Join, Lower, Upper)).holds,
    ),
    Law(
        "operator-makes-sheet",
        Clause.OPER_SHEET_5,
        "What an operator makes of a sheet is a sheet.",
        SHEET_STEPS,
        _sheet_again,
    ),
    Law(
        "operator-refusal",
        Clause.OPER_SHEET_5,
        "A rejection has one of the reasons of the clause, and blames a vertex or a simplex.",
        SHEET_STEPS,
        _refusal,
    ),
    Law(
        "sheet-effect-in-table",
        Clause.OPER_EFFECT_2,
        "Numbers counted anew before and after differ as the table says.",
        SHEET_STEPS,
        _effect,
    ),
    Law(
        "undo-undoes",
        Clause.OPER_SHEET_6,
        "An operator and its inverse, in either order, give the sheet back.",
        SHEET_STEPS,
        _undo,
    ),
    Law(
        "composed-of-euler-operators",
        Clause.OPER_BUILD_4,
        "An operator makes what the Euler operators make that it is composed of.",
        SHEET_STEPS,
        _composed,
    ),
)
