"""Scripts of attachments as text: one operator a line, in the style of `script_text`."""

import re
from collections.abc import Callable, Mapping
from typing import Final, assert_never

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtStep
from clers.operators.attachments.attachment import Attachment
from clers.operators.attachments.operator import (
    Attach,
    BoundaryAttach,
    Constructive,
    EdgeAndVertex,
    EdgeAtInterior,
    EdgeBetweenEnds,
    EulerAttach,
    FirstVertex,
    Handle,
    Operator,
    Script,
    Undo,
)
from clers.operators.lines import read_each, words

GLUES: Final[Mapping[str, Callable[[Attachment], Constructive]]] = {
    "attach": Attach,
    "euler-attach": EulerAttach,
    "boundary-attach": BoundaryAttach,
}
EDGES: Final[Mapping[str, Callable[[int, int], Constructive]]] = {
    "edge-and-vertex": EdgeAndVertex,
    "edge-between-ends": EdgeBetweenEnds,
    "edge-at-interior": EdgeAtInterior,
}
NAMES: Final = frozenset({*GLUES, *EDGES, "handle", "first-vertex"})
"""The names of the operators that build; `undo` before one is its inverse. OPER-ATTACH-8."""

_NUMBER: Final = re.compile(r"0|-?[1-9][0-9]{0,999}", re.ASCII)


def write(script: Script) -> str:
    """The script, a line for each operator. Clause: OPER-ATTACH-8."""
    return "\n".join(map(line, script))


def line(operator: Operator) -> str:
    """One operator as text. Clause: OPER-ATTACH-8."""
    match operator:
        case Undo(done):
            return f"undo {line(done)}"
        case Attach(glued):
            return f"attach {_glued(glued)}"
        case EulerAttach(glued):
            return f"euler-attach {_glued(glued)}"
        case BoundaryAttach(glued):
            return f"boundary-attach {_glued(glued)}"
        case Handle(first, then):
            return "handle " + " | ".join(map(_glued, (first, *then)))
        case FirstVertex(vertex):
            return f"first-vertex {vertex}"
        case EdgeAndVertex(one, other):
            return f"edge-and-vertex {one} {other}"
        case EdgeBetweenEnds(one, other):
            return f"edge-between-ends {one} {other}"
        case EdgeAtInterior(one, other):
            return f"edge-at-interior {one} {other}"
        case _:
            assert_never(operator)


def _glued(glued: Attachment) -> str:
    return " / ".join(" ".join(map(str, s)) for s in (glued.simplex, *glued.along))


def read(text: str) -> Accepted[Script] | Rejected:
    """The script that a text says. Clause: OPER-ATTACH-8."""
    return read_each(text, read_one)


def read_one(piece: str, where: AtStep) -> Accepted[Operator] | Rejected:
    """The operator that a piece says, or the step at fault. Clause: OPER-ATTACH-8."""
    found = words(piece)
    undo = found[0] == "undo"
    name, *operands = found[undo:] or [""]
    operator = _operator(name, operands)
    if isinstance(operator, Reason):
        return Rejected(operator, Clause.OPER_ATTACH_8, where, piece[:40])
    return Accepted(Undo(operator) if undo else operator)


def _operator(name: str, operands: list[str]) -> Constructive | Reason:
    if name not in NAMES:
        return Reason.UNKNOWN_OPERATOR
    read_parts = [_attachment(part) for part in " ".join(operands).split("|")]
    parts = [part for part in read_parts if part is not None]
    if len(parts) < len(read_parts):
        return Reason.BAD_OPERAND
    match parts:
        case [only] if name in GLUES:
            return GLUES[name](only)
        case [first, *then] if name == "handle":
            return Handle(first, tuple(then))
        case [Attachment((one, other), ())] if name in EDGES:
            return EDGES[name](one, other)
        case [Attachment((vertex,), ())] if name == "first-vertex":
            return FirstVertex(vertex)
        case _:
            return Reason.BAD_OPERAND


def _attachment(text: str) -> Attachment | None:
    """Simplices between slashes; None where something is no number."""
    simplices = [words(part) for part in text.split("/")]
    if not all(_NUMBER.fullmatch(word) for simplex in simplices for word in simplex):
        return None
    simplex, *along = (tuple(map(int, vertices)) for vertices in simplices)
    return Attachment(simplex, tuple(along))
