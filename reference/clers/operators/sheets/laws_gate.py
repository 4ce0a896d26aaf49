"""The law that operators at a gate are operators on sheets."""

from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Verdict
from clers.conventions.where import WHOLE
from clers.operators import handles as gate
from clers.operators.given_handles import HANDLE_STEPS, HandleStep, in_reach
from clers.operators.sheets.apply import apply
from clers.operators.sheets.gate import at_gate, sheet_of_growing
from clers.operators.sheets.sheet import fault


def _at_gate(step: HandleStep) -> Verdict:
    """Forgetting stack and gate, then the operator on sheets: the same as the other way round."""
    before = sheet_of_growing(step.before)
    if fault(before) is not None:
        return _edge_twice(step.before)
    return every(
        *(
            _same(operator, step.before, after.value)
            for operator in in_reach(step)
            for after in (gate.apply(operator, step.before),)
            if isinstance(after, Accepted)
        )
    )


def _edge_twice(grown: gate.Growing) -> Verdict:
    """Some edge, or all vertices of a triangle, are there twice."""
    cells = (*grown.faces, *(p[::-1] for p in grown.polygons), *grown.loops)
    sides = [side for cell in cells for side in zip(cell, (*cell[1:], cell[0]), strict=True)]
    faces = [frozenset(face) for face in grown.faces]
    twice = len(set(sides)) < len(sides) or len(set(faces)) < len(faces)
    degenerate = any(a == b for a, b in sides) or any(len(face) < 3 for face in faces)
    return same(True, twice or degenerate)


def _same(operator: gate.Operator, before: gate.Growing, after: gate.Growing) -> Verdict:
    expected = sheet_of_growing(after)
    match apply(at_gate(operator, before), sheet_of_growing(before)):
        case Accepted(sheet):
            return every(same(expected, sheet), same(None, fault(expected)))
        case Rejected(Reason.DOUBLE_EDGE | Reason.DUPLICATE_FACE | Reason.REPEATED_VERTEX):
            return _edge_twice(after)
        case Rejected() as rejected:
            return Fails("an operator at a gate on the sheet", rejected.line(), WHOLE)


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "gate-is-sheet",
        Clause.OPER_SHEET_7,
        "An operator at a gate is the operator on sheets of its name, where no edge comes twice.",
        HANDLE_STEPS,
        _at_gate,
    ),
)
