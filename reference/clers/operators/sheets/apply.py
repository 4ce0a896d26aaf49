"""Applying operators to sheets, one or a script of them, with the numbers on the way."""

from dataclasses import dataclass

from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtStep, in_words
from clers.operators.sheets.kill import undone
from clers.operators.sheets.make import made
from clers.operators.sheets.numbers import Numbers, numbers
from clers.operators.sheets.operator import Operator, Script, Undo
from clers.operators.sheets.sheet import EMPTY, Sheet


def apply(operator: Operator, sheet: Sheet) -> Accepted[Sheet] | Rejected:
    """One operator on a sheet. Total. Clauses: OPER-SHEET-5, OPER-SHEET-6."""
    match operator:
        case Undo(of):
            return undone(of, sheet)
        case _:
            return made(operator, sheet)


@dataclass(frozen=True, slots=True)
class Stage:
    """An operator of a script, the sheet after it, and that sheet's numbers. OPER-BUILD-6."""

    operator: Operator
    sheet: Sheet
    numbers: Numbers


def stages(script: Script, start: Sheet = EMPTY) -> tuple[tuple[Stage, ...], Rejected | None]:
    """The sheets on the way as far as the script applies, and what ended it. OPER-BUILD-6."""
    sheet, done = start, list[Stage]()
    for k, operator in enumerate(script):
        after = apply(operator, sheet)
        if isinstance(after, Rejected):
            detail = f"{in_words(after.where)}: {after.detail}"
            return tuple(done), Rejected(after.reason, after.clause, AtStep(k), detail)
        sheet = after.value
        done.append(Stage(operator, sheet, numbers(sheet)))
    return tuple(done), None


def steps(script: Script, start: Sheet = EMPTY) -> Accepted[tuple[Stage, ...]] | Rejected:
    """The sheet after each operator, with its numbers. Clause: OPER-BUILD-6."""
    done, fault = stages(script, start)
    return Accepted(done) if fault is None else fault


def run(script: Script, start: Sheet = EMPTY) -> Accepted[Sheet] | Rejected:
    """The sheet after all operators. Clause: OPER-BUILD-6."""
    done, fault = stages(script, start)
    if fault is not None:
        return fault
    return Accepted(done[-1].sheet if done else start)
