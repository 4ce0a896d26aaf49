"""The laws of surface operators: from surface to surface, exactly where they may."""

from typing import Final

from clers.complexes.corner_table import surface as surface_of
from clers.complexes.definition import is_coherent_surface
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Verdict
from clers.conventions.where import WHOLE
from clers.operators.sheets.apply import apply
from clers.operators.sheets.given import SURFACE_STEPS, SheetStep, on_surfaces
from clers.operators.sheets.operator import (
    Complete,
    Glue,
    JoinStrip,
    LowerStrip,
    Operator,
    TwoHandle,
    Undo,
    UpperStrip,
    ZeroHandle,
    inverse,
)
from clers.operators.sheets.sheet import EMPTY, Sheet, sides_of
from clers.operators.sheets.surfaces import apply_to_surface, face_list, sheet_of_surface


def _surface_again(step: SheetStep) -> Verdict:
    """The result is a surface by chapter 3, and the loops are its curves."""
    return every(
        *(
            _whole(after.value)
            for operator in on_surfaces(step)
            for after in (apply_to_surface(operator, step.before),)
            if isinstance(after, Accepted)
        )
    )


def _whole(sheet: Sheet) -> Verdict:
    if sheet == EMPTY:
        return same(EMPTY, sheet)
    listed = face_list(sheet)
    built = surface_of(listed)
    if isinstance(built, Rejected):
        return Fails("a surface", built.line(), built.where)
    return every(
        same(True, is_coherent_surface(listed)),
        same(len(sheet_of_surface(built.value).loops), len(sheet.loops)),
    )


MAKING: Final = (ZeroHandle, Complete, Glue, JoinStrip, LowerStrip, UpperStrip, TwoHandle)


def may(operator: Operator, before: Sheet) -> bool:
    """Do the conditions of OPER-SURFACE-10 hold, beside those of the operator on the sheet?"""
    if not isinstance(operator, Undo):
        return isinstance(operator, MAKING)
    bounding = {v for loop in before.loops for v in loop}
    inner = {side for triangle in before.triangles for side in sides_of(triangle)}
    match operator.of:
        case ZeroHandle():
            return True
        case Complete(_, b, _):
            return b not in bounding
        case TwoHandle(a, b, c):
            return bounding.isdisjoint((a, b, c))
        case Glue(a, b, _):
            return (b, a) in inner
        case JoinStrip(a, b, c, d) | LowerStrip(a, b, c, d) | UpperStrip(a, b, c, d):
            return (b, a) in inner and (d, c) in inner
        case _:
            return False


def _exactly(step: SheetStep) -> Verdict:
    """A surface operator applies exactly if it applies to the sheet and its conditions hold."""
    verdicts = []
    for operator in on_surfaces(step):
        on_sheet = apply(operator, step.before)
        expected = isinstance(on_sheet, Accepted) and may(operator, step.before)
        got = apply_to_surface(operator, step.before)
        verdicts.append(same(on_sheet if expected else None, got if expected else None))
        if isinstance(got, Accepted) != expected:
            verdicts.append(Fails(f"{operator} to apply: {expected}", repr(got), WHOLE))
    return every(*verdicts)


def _back(step: SheetStep) -> Verdict:
    """The inverse of a surface operator is one, where the operator applies."""
    return every(
        *(
            same(Accepted(step.before), apply_to_surface(inverse(operator), after.value))
            for operator in on_surfaces(step)
            for after in (apply_to_surface(operator, step.before),)
            if isinstance(after, Accepted)
        )
    )


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "surface-operator-makes-surface",
        Clause.OPER_SURFACE_10,
        "What a surface operator makes of a surface is a surface.",
        SURFACE_STEPS,
        _surface_again,
    ),
    Law(
        "surface-operator-applies-exactly",
        Clause.OPER_SURFACE_10,
        "It applies exactly if it applies to the sheet and leaves no pinch and no bare edge.",
        SURFACE_STEPS,
        _exactly,
    ),
    Law(
        "surface-operator-undone",
        Clause.OPER_SURFACE_10,
        "The inverse of a surface operator gives the surface back.",
        SURFACE_STEPS,
        _back,
    ),
)
