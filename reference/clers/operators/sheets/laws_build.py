"""The laws of scripts that build surfaces: whole, taken apart, counted, translated, written."""

from collections import Counter
from typing import Final

from clers.complexes.given import SMALL_SURFACES
from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Verdict
from clers.operators.sheets.apply import apply, run, steps
from clers.operators.sheets.build import build
from clers.operators.sheets.euler import euler
from clers.operators.sheets.given import SHEET_SCRIPTS
from clers.operators.sheets.numbers import numbers
from clers.operators.sheets.operator import (
    Complete,
    Euler,
    Glue,
    Join,
    Lower,
    MakeEKL,
    MakeEV,
    MakeSG,
    MakeSTV,
    MakeTE,
    Operator,
    Script,
    TwoHandle,
    Undo,
    Upper,
    ZeroHandle,
    ZeroHandlePolygon,
    taken_apart,
)
from clers.operators.sheets.sheet import EMPTY, Sheet, component
from clers.operators.sheets.surfaces import sheet_of_surface
from clers.operators.sheets.text import read, write

FIRSTS: Final = (1, 2, 5)
"""Numbers of first triangles that the laws try."""


def _built(surface: Surface) -> Verdict:
    whole = sheet_of_surface(surface)
    scripts = [build(surface, first) for first in FIRSTS]
    return every(
        *(same(Accepted(whole), run(script)) for script in scripts),
        *(same(Accepted(EMPTY), run(taken_apart(script), whole)) for script in scripts),
        *(same(surface.faces, len(script)) for script in scripts),
    )


def kinds(script: Script) -> Counter[type[Operator]]:
    """How many operators of each kind a script has."""
    return Counter(type(operator) for operator in script)


def _counted(surface: Surface) -> Verdict:
    """Morse's relation, with every number counted from the surface by chapter 3."""
    parts = components(surface)
    expected = (
        sum(part.euler for part in parts),
        len(parts),
        sum(part.genus for part in parts),
        sum(part.curves for part in parts),
    )
    verdicts = []
    for first in FIRSTS:
        n = kinds(build(surface, first))
        zero, join, lower, upper, two = (
            n[kind] for kind in (ZeroHandle, Join, Lower, Upper, TwoHandle)
        )
        chi = zero - (join + lower + upper) + two
        got = (chi, zero - join, upper, zero - join + lower - upper - two)
        verdicts.append(same(expected, got))
        if first == 1:
            verdicts.append(same((len(parts), 0), (zero, join)))
        others = n[Glue] + n[Complete] + zero + join + lower + upper + two
        verdicts.append(same(surface.faces, others))
    return every(*verdicts)


def first_triangles(surface: Surface, first: int) -> list[tuple[int, ...]]:
    """The first triangles of a decomposition, by its clause: apart from those chosen before."""
    chosen: list[tuple[int, ...]] = []
    for triangle in surface.triangles():
        if len(chosen) < first and not {v for t in chosen for v in t} & set(triangle):
            chosen.append(tuple(triangle))
    return chosen


def _breadth_first(surface: Surface) -> Verdict:
    """The first triangles come first; each other begins a component or borders one before it.

    Which it borders, the first that it does, never goes back: that is breadth first.
    """
    verdicts: list[Verdict] = []
    for first in FIRSTS:
        made = [_triangle(operator) for operator in build(surface, first)]
        chosen = first_triangles(surface, first)
        verdicts.append(same([set(t) for t in chosen], [set(t) for t in made[: len(chosen)]]))
        parents = [
            next((i for i, known in enumerate(made[:k]) if len(set(known) & set(t)) == 2), k)
            for k, t in enumerate(made)
        ]
        verdicts.append(same(sorted(parents[len(chosen) :]), parents[len(chosen) :]))
    return every(*verdicts)


def _triangle(operator: Operator) -> tuple[int, int, int]:
    match operator:
        case ZeroHandle(p, q, r):
            return p, q, r
        case Glue(a, b, c) | Complete(a, b, c) | TwoHandle(a, b, c):
            return a, b, c
        case Join(a, b, c) | Lower(a, b, c) | Upper(a, b, c):
            return a, b, c
        case _:
            return -1, -1, -1


def _euler(surface: Surface) -> Verdict:
    """By Euler operators alone, one K SG for each lower 1-handle."""
    verdicts: list[Verdict] = []
    for first in FIRSTS[:2]:
        script = build(surface, first)
        translated = euler(script)
        if isinstance(translated, Rejected):
            return Fails("a script", translated.line(), translated.where)
        only = (MakeSTV, MakeEV, MakeTE, MakeSG, MakeEKL)
        what = [o.of if isinstance(o, Undo) else o for o in translated.value]
        opened = sum(isinstance(o, Undo) and isinstance(o.of, MakeSG) for o in translated.value)
        cut = kinds(script)[Lower]
        verdicts += [
            same([], [o for o in what if not isinstance(o, only)]),
            same(Accepted(sheet_of_surface(surface)), _last(translated.value)),
            same(cut, opened),
        ]
    return every(*verdicts)


def _last(script: Script) -> Accepted[Sheet] | Rejected:
    """The sheet after a script, without counting on the way."""
    sheet = EMPTY
    for operator in script:
        after = apply(operator, sheet)
        if isinstance(after, Rejected):
            return after
        sheet = after.value
    return Accepted(sheet)


def _translated(script: Script) -> Verdict:
    """A script by Euler operators makes the same, whatever it undoes on the way."""
    translated = euler(script)
    if isinstance(translated, Rejected):
        return Fails("a script", translated.line(), translated.where)
    known = (MakeSTV, MakeEV, MakeTE, MakeSG, MakeEKL, ZeroHandlePolygon)
    what = [o.of if isinstance(o, Undo) else o for o in translated.value]
    return every(
        same(_last(script), _last(translated.value)),
        same([], [o for o in what if not isinstance(o, known)]),
    )


def _only_making(script: Script) -> Verdict:
    """Those of a translated script that make, each where it applies: no loop is ever cut."""
    translated = euler(script)
    sheet, verdicts = EMPTY, list[Verdict]()
    for operator in translated.value if isinstance(translated, Accepted) else ():
        after = apply(operator, sheet)
        if isinstance(after, Accepted) and isinstance(operator, Euler):
            sheet = after.value
            part = component(sheet)
            loops = Counter(part[loop[0]] for loop in sheet.loops)
            verdicts.append(same((0, 1), (numbers(sheet).genus, max(loops.values(), default=1))))
    return every(*verdicts)


def _text(script: Script) -> Verdict:
    return every(
        same(Accepted(script), read(write(script))),
        same(Accepted(script), read(write(script).replace("; ", " ;\n;\r\n  "))),
    )


def _steps(script: Script) -> Verdict:
    """Each step is the operator applied to the sheet before it, with the numbers of the result."""
    found = steps(script)
    if isinstance(found, Rejected):
        return Fails("steps", found.line(), found.where)
    before, verdicts = EMPTY, [same(list(script), [stage.operator for stage in found.value])]
    for stage in found.value:
        verdicts.append(same(Accepted(stage.sheet), apply(stage.operator, before)))
        verdicts.append(same(numbers(stage.sheet), stage.numbers))
        before = stage.sheet
    return every(*verdicts, same(Accepted(before), run(script)))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "build-breadth-first",
        Clause.OPER_BUILD_1,
        "The first triangles come first, then each borders one before it, breadth first.",
        SMALL_SURFACES,
        _breadth_first,
    ),
    Law(
        "build-and-take-apart",
        Clause.OPER_BUILD_2,
        "The script makes the sheet of the surface, and its inverse makes the empty sheet of that.",
        SMALL_SURFACES,
        _built,
    ),
    Law(
        "build-morse",
        Clause.OPER_BUILD_3,
        "The numbers of handles give χ, components, genus and curves.",
        SMALL_SURFACES,
        _counted,
    ),
    Law(
        "build-by-euler-operators",
        Clause.OPER_BUILD_4,
        "Euler operators alone make the surface, with one K SG for each lower 1-handle.",
        SMALL_SURFACES,
        _euler,
    ),
    Law(
        "scripts-by-euler-operators",
        Clause.OPER_BUILD_4,
        "A script and its translation make the same sheet.",
        SHEET_SCRIPTS,
        _translated,
    ),
    Law(
        "making-cuts-no-loop",
        Clause.OPER_EULER_6,
        "With M operators alone no component gets a second loop, nor genus.",
        SHEET_SCRIPTS,
        _only_making,
    ),
    Law(
        "sheet-script-text",
        Clause.OPER_BUILD_5,
        "Reading what was written gives the script back.",
        SHEET_SCRIPTS,
        _text,
    ),
    Law(
        "sheet-script-steps",
        Clause.OPER_BUILD_6,
        "Each step is its operator applied to the sheet before, with the numbers of the result.",
        SHEET_SCRIPTS,
        _steps,
    ),
)
