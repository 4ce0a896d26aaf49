"""Sheets and operators on them: scripts of choices, so that a smaller list is a smaller sheet."""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

from clers.conventions.result import Accepted
from clers.generate.surfaces import surfaces
from clers.operators.sheets.apply import apply
from clers.operators.sheets.build import build
from clers.operators.sheets.given import FOR_SURFACES, SheetStep
from clers.operators.sheets.operator import Operator, Script, taken_apart
from clers.operators.sheets.proposals import Choice, proposed
from clers.operators.sheets.sheet import EMPTY, Sheet, vertices
from clers.operators.sheets.surfaces import apply_to_surface, sheet_of_surface
from clers.operators.sheets.text import NAME, UNDONE, name_of, named, operands

MAKING: Final = tuple(NAME.values())
UNDOING: Final = tuple(UNDONE)
UNDOING_SURFACES: Final = tuple(f"undo-{name}" for name in FOR_SURFACES)


def choices(making: tuple[str, ...], undoing: tuple[str, ...]) -> st.SearchStrategy[Choice]:
    """Choices of operators, a third of them inverse."""
    names = st.one_of(*(st.sampled_from(some) for some in (making, making, undoing)))
    return st.tuples(names, st.integers(0, 40), st.integers(0, 40))


def _script(picks: list[Choice], start: Script) -> tuple[Script, Sheet]:
    """A script that applies, and what it makes: choices that do not apply are passed over."""
    sheet, script = EMPTY, list[Operator]()
    for what in (*start, *picks):
        operator = proposed(what, sheet) if isinstance(what, tuple) else what
        after = apply(operator, sheet)
        if isinstance(after, Accepted):
            sheet = after.value
            script.append(operator)
    return tuple(script), sheet


_SURFACES: Final = st.one_of(
    surfaces(12, (0, 1), (0, 2), (1, 2)),
    surfaces(14, (1, 1), (0, 1), (1, 1)),
    surfaces(14, (0, 0), (2, 3), (1, 1)),
)


@st.composite
def _beginnings(draw: st.DrawFn) -> Script:
    """Nothing, or a surface's handle decomposition, broken off or taken apart a little."""
    if not draw(st.integers(0, 4)):
        return ()
    script = build(draw(_SURFACES), draw(st.integers(1, 3)))
    kept = draw(st.integers(1, len(script)))
    if draw(st.booleans()):
        return script[:kept]
    return (*script, *taken_apart(script)[: len(script) - kept])


def _drawn(max_choices: int) -> st.SearchStrategy[tuple[Script, Sheet]]:
    # The picks first, so that they stay what they are when the beginning shrinks to nothing.
    picks = st.lists(choices(MAKING, UNDOING), max_size=max_choices)
    return st.builds(_script, picks, _beginnings())


def sheet_scripts(max_choices: int = 12) -> st.SearchStrategy[Script]:
    """Scripts of operators that apply to the empty sheet one by one."""
    return _drawn(max_choices).map(lambda drawn: drawn[0])


def sheets(max_choices: int = 12) -> st.SearchStrategy[Sheet]:
    """Sheets, most of them no surfaces."""
    return _drawn(max_choices).map(lambda drawn: drawn[1])


@st.composite
def sheet_steps(draw: st.DrawFn) -> SheetStep:
    """A sheet, and an operator that it suggests, or one with an operand exchanged."""
    choice = draw(choices(MAKING, UNDOING))
    sheet = draw(sheets(draw(st.sampled_from((12, 0)))))
    operator = proposed(choice, sheet)
    return SheetStep(sheet, draw(_perhaps_exchanged(operator, sheet)))


@st.composite
def _perhaps_exchanged(draw: st.DrawFn, operator: Operator, sheet: Sheet) -> Operator:
    """The operator, or the same with one operand any vertex, or none."""
    names = list(operands(operator))
    at = draw(st.integers(-len(names), len(names) - 1))
    if at >= 0:
        names[at] = draw(st.integers(-1, max(vertices(sheet), default=-1) + 1))
    changed = named(name_of(operator), names)
    assert changed is not None, operator
    return changed


@st.composite
def surface_steps(draw: st.DrawFn) -> SheetStep:
    """A surface or nothing, some surface operators, and one more of them."""
    sheet = draw(st.one_of(st.just(EMPTY), _SURFACES.map(sheet_of_surface)))
    picks = choices(FOR_SURFACES, UNDOING_SURFACES)
    for choice in draw(st.lists(picks, max_size=12)):
        after = apply_to_surface(proposed(choice, sheet), sheet)
        sheet = after.value if isinstance(after, Accepted) else sheet
    operator = proposed(draw(picks), sheet)
    return SheetStep(sheet, draw(_perhaps_exchanged(operator, sheet)))


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "sheets": sheets(),
    "sheet-steps": sheet_steps(),
    "surface-steps": surface_steps(),
    "sheet-scripts": sheet_scripts(),
}
"""The domains of this module, by name."""
