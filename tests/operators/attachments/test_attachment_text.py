"""Scripts of attachments as text."""

import pytest

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtStep
from clers.operators.attachments.attachment import Attachment
from clers.operators.attachments.operator import (
    Attach,
    BoundaryAttach,
    EdgeAndVertex,
    EdgeAtInterior,
    EdgeBetweenEnds,
    EulerAttach,
    FirstVertex,
    Handle,
    Operator,
    Undo,
)
from clers.operators.attachments.text import read, write

FIN = Attachment((0, 1, 2), ((0, 1), (2,)))
LINES: tuple[tuple[str, Operator], ...] = (
    ("attach 0 1 2 / 0 1 / 2", Attach(FIN)),
    ("euler-attach 3", EulerAttach(Attachment((3,)))),
    ("boundary-attach 0 1 2 / 0 1 / 2", BoundaryAttach(FIN)),
    ("handle 3 4", Handle(Attachment((3, 4)))),
    ("handle 0 1 2 / 0 1 / 2 | 1 2 / 1", Handle(FIN, (Attachment((1, 2), ((1,),)),))),
    ("first-vertex 12", FirstVertex(12)),
    ("edge-and-vertex 3 1", EdgeAndVertex(3, 1)),
    ("edge-between-ends 0 3", EdgeBetweenEnds(0, 3)),
    ("edge-at-interior 1 0", EdgeAtInterior(1, 0)),
    ("undo attach 0 1 2 / 0 1 / 2", Undo(Attach(FIN))),
    ("undo first-vertex -1", Undo(FirstVertex(-1))),
)


@pytest.mark.parametrize(("text", "operator"), LINES)
def test_line(text: str, operator: Operator) -> None:
    """Clause: OPER-ATTACH-8."""
    assert write((operator,)) == text
    assert read(text) == Accepted((operator,))


def test_whole_script() -> None:
    """Clause: OPER-ATTACH-8."""
    script = tuple(operator for _, operator in LINES)
    assert write(script) == "\n".join(text for text, _ in LINES)
    assert read("; ".join(text for text, _ in LINES)) == Accepted(script)
    assert read(" ;\n\r; first-vertex   12 ; ") == Accepted((FirstVertex(12),))
    assert read("") == Accepted(())


@pytest.mark.parametrize(
    ("text", "reason", "step"),
    [
        ("first-vertex 1; glue 1 2", Reason.UNKNOWN_OPERATOR, 1),
        ("undo", Reason.UNKNOWN_OPERATOR, 0),
        ("undo undo first-vertex 1", Reason.UNKNOWN_OPERATOR, 0),
        ("Attach 1", Reason.UNKNOWN_OPERATOR, 0),
        ("first-vertex", Reason.BAD_OPERAND, 0),
        ("first-vertex 1 2", Reason.BAD_OPERAND, 0),
        ("first-vertex 1 / 1", Reason.BAD_OPERAND, 0),
        ("first-vertex 01", Reason.BAD_OPERAND, 0),
        ("first-vertex x", Reason.BAD_OPERAND, 0),
        ("first-vertex -0", Reason.BAD_OPERAND, 0),
        ("first-vertex " + "1" * 1001, Reason.BAD_OPERAND, 0),
        ("edge-and-vertex 1", Reason.BAD_OPERAND, 0),
        ("edge-and-vertex 1 2 3", Reason.BAD_OPERAND, 0),
        ("edge-and-vertex 1 2 / 1", Reason.BAD_OPERAND, 0),
        ("edge-and-vertex 1 2 | 1 2", Reason.BAD_OPERAND, 0),
        ("attach 0 1 | 1 2", Reason.BAD_OPERAND, 0),
        ("attach 0 1 / y", Reason.BAD_OPERAND, 0),
        ("attach 0 1 | z", Reason.BAD_OPERAND, 0),
    ],
)
def test_not_a_script(text: str, reason: Reason, step: int) -> None:
    """Clause: OPER-ATTACH-8."""
    detail = text.split(";")[-1].strip()[:40]
    assert read(text) == Rejected(reason, Clause.OPER_ATTACH_8, AtStep(step), detail)


def test_long_numbers() -> None:
    """A thousand digits are read. Clause: OPER-ATTACH-8."""
    assert read("first-vertex " + "1" * 1000) == Accepted((FirstVertex(int("1" * 1000)),))
