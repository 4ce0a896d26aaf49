"""Scripts of any family of operators: which family a text is of, and the stages it passes.

There are three: operators on *sheets* (Euler and handle operators), operators on *complexes* (moves
and attachments, mixed as one likes), and total operators that *grow* surfaces.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Final, assert_never

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.homology import Field, betti
from clers.complexes.parts import f_vector
from clers.complexes.simplicial import Complex, closure, euler, pieces
from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.where import AtStep, in_words
from clers.operators import script as total
from clers.operators import script_text as total_text
from clers.operators.attachments import apply as attaching
from clers.operators.attachments import operator as attachments
from clers.operators.attachments import text as attachments_text
from clers.operators.lines import pieces_of, read_each, words
from clers.operators.moves import apply as moving
from clers.operators.moves import text as moves_text
from clers.operators.moves.move import Move
from clers.operators.sheets import apply as sheets
from clers.operators.sheets import text as sheets_text
from clers.operators.sheets.numbers import Numbers, numbers
from clers.operators.sheets.operator import Script as SheetScript
from clers.operators.sheets.sheet import EMPTY, Sheet
from clers.operators.sheets.surfaces import sheet_of_surface
from clers.operators.step import Idle, Outcome

ON_SHEETS: Final = frozenset({*sheets_text.NAME.values(), *sheets_text.UNDONE})
ON_COMPLEXES: Final = frozenset({*moves_text.NAMES, *attachments_text.NAMES, "undo"})
GROWING: Final = frozenset(
    {*total_text.WITH_NONE, *total_text.WITH_ONE, *total_text.WITH_TWO},
)
"""The names of the operators of each family, no two alike. Clause: OPER-FAMILY-1."""

ComplexOperator = Move | attachments.Operator


@dataclass(frozen=True, slots=True)
class OnSheets:
    """Euler and handle operators. Clause: OPER-FAMILY-1."""

    script: SheetScript


@dataclass(frozen=True, slots=True)
class OnComplexes:
    """Moves and attachments. Clause: OPER-FAMILY-1."""

    script: tuple[ComplexOperator, ...]


@dataclass(frozen=True, slots=True)
class Growing:
    """Total operators on surfaces. Clause: OPER-FAMILY-1."""

    script: total.Script


AnyScript = OnSheets | OnComplexes | Growing
Shape = Sheet | Complex | FaceList
"""What operators work on: a sheet, a complex, the faces of a surface."""


@dataclass(frozen=True, slots=True)
class Stage:
    """What is there after an operator, and its numbers, counted anew. Clause: OPER-FAMILY-3.

    `idle`: why a total operator did nothing, or empty.
    """

    operator: str
    numbers: tuple[tuple[str, int], ...]
    shape: Shape
    idle: str = ""


def read(text: str) -> Accepted[AnyScript] | Rejected:
    """The script that a text says, of the family of its first name. Clause: OPER-FAMILY-1."""
    first = next((words(piece)[0] for piece in pieces_of(text)), "")
    if first in ON_COMPLEXES:
        return _on_complexes(text)
    if first in GROWING:
        return and_then(total_text.read(text), lambda script: Accepted(Growing(script)))
    return and_then(sheets_text.read(text), lambda script: Accepted(OnSheets(script)))


def _on_complexes(text: str) -> Accepted[AnyScript] | Rejected:
    return and_then(read_each(text, _on_complex), lambda script: Accepted(OnComplexes(script)))


def _on_complex(piece: str, where: AtStep) -> Accepted[ComplexOperator] | Rejected:
    if words(piece)[0] in moves_text.NAMES:
        return moves_text.read_one(piece, where)
    return attachments_text.read_one(piece, where)


def stages(
    script: AnyScript, start: Surface | Complex | None = None
) -> tuple[tuple[Stage, ...], Rejected | None]:
    """The stages as far as the script applies, and what ended it. Clauses: OPER-FAMILY-2, -3.

    `start`: what the operators begin on, instead of nothing.
    """
    match script:
        case OnSheets(operators):
            return _of_sheets(operators, start)
        case OnComplexes(operators):
            return _of_complexes(operators, start)
        case Growing(operators):
            if start is not None:
                detail = "these operators begin on the tetrahedron"
                return (), Rejected(
                    Reason.OPERATOR_NOT_APPLICABLE, Clause.OPER_FAMILY_2, detail=detail
                )
            return tuple(_of_growth(operators)), None
        case _:
            assert_never(script)


def _of_sheets(
    script: SheetScript, start: Surface | Complex | None
) -> tuple[tuple[Stage, ...], Rejected | None]:
    match start:
        case None:
            begun = EMPTY
        case Surface():
            begun = sheet_of_surface(start)
        case Complex():
            detail = "operators on sheets begin on an oriented surface"
            return (), Rejected(Reason.OPERATOR_NOT_APPLICABLE, Clause.OPER_FAMILY_2, detail=detail)
        case _:
            assert_never(start)
    done, fault = sheets.stages(script, begun)
    found = [Stage("", _counted(numbers(begun)), begun)] if start is not None else []
    found += [
        Stage(sheets_text.write((stage.operator,)), _counted(stage.numbers), stage.sheet)
        for stage in done
    ]
    return tuple(found), fault


def _counted(of: Numbers) -> tuple[tuple[str, int], ...]:
    return (
        ("vertices", of.vertices),
        ("edges", of.edges),
        ("faces", of.faces),
        ("χ", of.euler),
        ("components", of.components),
        ("genus", of.genus),
        ("loops", of.loops),
    )


def _of_complexes(
    script: tuple[ComplexOperator, ...], start: Surface | Complex | None
) -> tuple[tuple[Stage, ...], Rejected | None]:
    k = closure(start.triangles()) if isinstance(start, Surface) else start or attaching.NOTHING
    found = [Stage("", measured(k), k)] if start is not None else []
    for number, operator in enumerate(script):
        text, after = _done(operator, k)
        if isinstance(after, Rejected):
            detail = f"{in_words(after.where)}: {after.detail}"
            return tuple(found), replace(after, where=AtStep(number), detail=detail)
        k = after.value
        found.append(Stage(text, measured(k), k))
    return tuple(found), None


def _done(operator: ComplexOperator, k: Complex) -> tuple[str, Accepted[Complex] | Rejected]:
    if isinstance(operator, Move):
        return moves_text.write((operator,)), moving.apply(operator, k)
    return attachments_text.write((operator,)), attaching.apply(operator, k)


def measured(k: Complex) -> tuple[tuple[str, int], ...]:
    """#0, #1 …, χ, components, and the Betti numbers over GF(2). Clause: OPER-FAMILY-3."""
    return (
        *((f"#{m}", count) for m, count in enumerate(f_vector(k))),
        ("χ", euler(k)),
        ("components", len(pieces(k))),
        *((f"b{m}", rank) for m, rank in enumerate(betti(k, Field.GF2))),
    )


def _of_growth(script: total.Script) -> Iterator[Stage]:
    yield Stage("", _topology(total.START), total.START)
    for operator, step in zip(script, total.steps(script), strict=True):
        yield Stage(
            total_text.write((operator,)), _topology(step.mesh), step.mesh, _why(step.outcome)
        )


def _why(outcome: Outcome) -> str:
    return outcome.obstacle.value if isinstance(outcome, Idle) else ""


def _topology(mesh: FaceList) -> tuple[tuple[str, int], ...]:
    built = surface(mesh)
    if isinstance(built, Rejected):
        raise AssertionError(f"total operators made no surface: {built.line()}")
    parts = components(built.value)
    return (
        ("vertices", mesh.vertices),
        ("faces", len(mesh.faces)),
        ("χ", sum(part.euler for part in parts)),
        ("components", len(parts)),
        ("genus", sum(part.genus for part in parts)),
        ("curves", sum(part.curves for part in parts)),
    )
