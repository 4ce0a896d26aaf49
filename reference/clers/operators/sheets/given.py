"""The domains that laws of sheets range over; `clers.generate` draws from them."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from clers.conventions.law import Given
from clers.operators.sheets.operator import (
    Constructive,
    Operator,
    Script,
    Undo,
    ZeroHandlePolygon,
)
from clers.operators.sheets.proposals import in_reach
from clers.operators.sheets.sheet import Sheet
from clers.operators.sheets.text import WITH_FOUR, WITH_THREE, operands

FOR_SURFACES: Final = (
    "zero-handle",
    "complete",
    "glue",
    "join-strip",
    "lower-strip",
    "upper-strip",
    "two-handle",
)
"""The names of the surface operators that make. Clause: OPER-SURFACE-10."""

ALMOST: Final = ("make-te", "lower", "kill-te")
"""Some that are none."""


@dataclass(frozen=True, slots=True)
class SheetStep:
    """A sheet and an operator that may apply to it or not. Clause: OPER-SHEET-5."""

    before: Sheet
    operator: Operator


SHEETS: Final = Given("sheets", "sheets, as scripts and chance leave them", Sheet)
SHEET_STEPS: Final = Given(
    "sheet-steps", "a sheet and an operator, applicable or nearly so", SheetStep
)
SURFACE_STEPS: Final = Given(
    "surface-steps", "a sheet that is a surface, and a surface operator", SheetStep
)
SHEET_SCRIPTS: Final[Given[Script]] = Given(
    "sheet-scripts", "scripts of operators that apply to the empty sheet one by one", tuple
)


def kindred(operator: Operator) -> Iterator[Constructive]:
    """The operators that make, with the same operands or nearly: the given one is among them.

    Of three vertices also turned, of four also with the two sides exchanged.
    """
    names = operands(operator)
    yield from (ZeroHandlePolygon(names), ZeroHandlePolygon(names[:2]))
    if len(names) in (3, 4):
        a, b, c = names[:3]
        for x, y, z in ((a, b, c), (b, c, a), (c, b, a)):
            yield from (make(x, y, z) for make in WITH_THREE.values())
    if len(names) == 4:
        a, b, c, d = names
        for first, second in (((a, b), (c, d)), ((c, d), (a, b)), ((a, b), (d, c))):
            yield from (make(*first, *second) for make in WITH_FOUR.values())


def makers(step: SheetStep) -> Iterator[Constructive]:
    """The operators that make among those of `steps_in_reach`, with their kindred."""
    yield from kindred(step.operator)
    yield from (o for o in in_reach(step.before) if not isinstance(o, Undo))


def steps_in_reach(step: SheetStep) -> Iterator[Operator]:
    """The operator of a step, its kindred with their inverses, and what the sheet suggests."""
    yield step.operator
    for operator in kindred(step.operator):
        yield operator
        yield Undo(operator)
    yield from in_reach(step.before)


def on_surfaces(step: SheetStep) -> Iterator[Operator]:
    """The operator of a step, and what the sheet suggests of surface operators and some others."""
    yield step.operator
    undoing = (f"undo-{name}" for name in FOR_SURFACES)
    yield from in_reach(step.before, (*FOR_SURFACES, *undoing, *ALMOST))
