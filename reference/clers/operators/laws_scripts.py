"""The laws of scripts: each step gives a surface, and its effect is what chapter 3 measures."""

from collections.abc import Iterator
from math import lcm
from typing import Final, assert_never

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Given, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import AtStep
from clers.operators.effect import Effect
from clers.operators.script import (
    START,
    AddEar,
    AddHandle,
    AddTetrahedron,
    Bridge,
    CloseCurve,
    CutEdge,
    FillCorner,
    FlipEdge,
    JoinComponents,
    OpenCurve,
    Operator,
    Relabel,
    RemoveFace,
    RemoveStar,
    Script,
    SplitEdge,
    SplitFace,
    apply,
    grow,
    run,
    steps,
)
from clers.operators.script_table import in_table
from clers.operators.script_text import read, write
from clers.operators.step import Did, Idle, Step

SCRIPTS: Final[Given[Script]] = Given(
    "scripts", "lists of operators with any integers for their choices", tuple
)


def _pairs(script: Script) -> Iterator[tuple[AtStep, Operator, FaceList, Step]]:
    """Each operator with its number, the mesh it is applied to, and the step."""
    before = START
    for k, (operator, step) in enumerate(zip(script, steps(script), strict=True)):
        yield AtStep(k), operator, before, step
        before = step.mesh


def _prefix(script: Script) -> Verdict:
    """A script's mesh is its last operator's, applied to the mesh of the script before it."""
    if not script:
        return same(START, grow(script))
    return same(apply(script[-1], grow(script[:-1])).mesh, grow(script))


def _accepted(script: Script) -> Verdict:
    for where, operator, _, step in _pairs(script):
        built = surface(step.mesh)
        if isinstance(built, Rejected):
            return Fails(f"a surface after {operator}", built.line(), where)
    return same(surface(grow(script)), run(script))


def _idle(script: Script) -> Verdict:
    return every(
        *(
            same(before, step.mesh, where)
            for where, _, before, step in _pairs(script)
            if isinstance(step.outcome, Idle)
        )
    )


def _modulo(script: Script) -> Verdict:
    """No operator has more candidates than the mesh has corners, so their lcm changes no choice."""
    return every(
        *(
            same(step, apply(_moved(operator, lcm(*range(1, 3 * len(before.faces) + 1))), before))
            for _, operator, before, step in _pairs(script)
        )
    )


def _moved(operator: Operator, by: int) -> Operator:
    match operator:
        case AddTetrahedron() | Relabel():
            return operator
        case AddHandle(first, second) | JoinComponents(first, second) | Bridge(first, second):
            return type(operator)(first - by, second + by)
        case (
            SplitFace(choice)
            | SplitEdge(choice)
            | FlipEdge(choice)
            | AddEar(choice)
            | FillCorner(choice)
            | CloseCurve(choice)
            | OpenCurve(choice)
            | RemoveFace(choice)
            | RemoveStar(choice)
            | CutEdge(choice)
        ):
            return type(operator)(choice + by)
        case _:
            assert_never(operator)


def totals(mesh: FaceList) -> Effect | Rejected:
    """Components, genus and curves, counted by chapter 3. Clause: OPER-SCRIPT-3."""
    match surface(mesh):
        case Accepted(built):
            return _totals(built)
        case Rejected() as fault:
            return fault


def _totals(of: Surface) -> Effect:
    parts = components(of)
    return Effect(len(parts), sum(part.genus for part in parts), sum(part.curves for part in parts))


def _effect(script: Script) -> Verdict:
    """The mesh's numbers after each step are those before it, changed by the effect."""
    now = totals(START)
    for where, operator, _, step in _pairs(script):
        if isinstance(now, Rejected):
            return Fails("a surface", now.line(), where)
        expected = now + step.outcome.effect if isinstance(step.outcome, Did) else now
        now = totals(step.mesh)
        if now != expected:
            return Fails(f"{expected} after {operator}", repr(now), where)
    return Holds()


def _table(script: Script) -> Verdict:
    for where, operator, before, step in _pairs(script):
        if isinstance(step.outcome, Did):
            vertices = step.mesh.vertices - before.vertices
            faces = len(step.mesh.faces) - len(before.faces)
            row = (vertices, faces, step.outcome.effect)
            if not in_table(operator, vertices, faces, step.outcome.effect):
                return Fails(f"a row of the table for {operator}", repr(row), where)
    return Holds()


def _text(script: Script) -> Verdict:
    return same(Accepted(script), read(write(script)))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "script-runs-in-order",
        Clause.OPER_SCRIPT_1,
        "A script starts from the tetrahedron and applies its operators in order.",
        SCRIPTS,
        _prefix,
    ),
    Law(
        "script-idle-changes-nothing",
        Clause.OPER_SCRIPT_2,
        "An operator that meets an obstacle leaves the mesh as it is.",
        SCRIPTS,
        _idle,
    ),
    Law(
        "script-choices-are-modular",
        Clause.OPER_SCRIPT_2,
        "Integers that are equal modulo the number of candidates choose the same.",
        SCRIPTS,
        _modulo,
    ),
    Law(
        "script-effect-is-measured",
        Clause.OPER_SCRIPT_3,
        "The effect an operator says is the change that chapter 3 measures.",
        SCRIPTS,
        _effect,
    ),
    Law(
        "script-is-accepted",
        Clause.OPER_SCRIPT_4,
        "After each step of a script the mesh is a surface.",
        SCRIPTS,
        _accepted,
    ),
    Law(
        "script-effect-in-table",
        Clause.OPER_SCRIPT_5,
        "Each step changes vertices, faces and topology as the table says.",
        SCRIPTS,
        _table,
    ),
    Law(
        "script-text-round-trip",
        Clause.OPER_SCRIPT_6,
        "Reading a written script gives it back.",
        SCRIPTS,
        _text,
    ),
)
