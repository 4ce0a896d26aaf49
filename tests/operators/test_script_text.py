"""Scripts as text: what is read, and what is rejected at which step."""

import pytest

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtStep
from clers.operators.script import AddHandle, AddTetrahedron, SplitFace
from clers.operators.script_text import read, write


def test_writing() -> None:
    """OPER-SCRIPT-6."""
    script = (SplitFace(-3), AddTetrahedron(), AddHandle(0, 12))
    assert write(script) == "split-face -3; add-tetrahedron; add-handle 0 12"


@pytest.mark.parametrize(
    "text", ["split-face 1;add-tetrahedron", "\n split-face   1 ;; \r\nadd-tetrahedron\n"]
)
def test_reading(text: str) -> None:
    """OPER-SCRIPT-6: empty pieces are passed over."""
    assert read(text) == Accepted((SplitFace(1), AddTetrahedron()))


def test_nothing() -> None:
    """OPER-SCRIPT-6."""
    assert read("") == Accepted(())


@pytest.mark.parametrize(
    ("piece", "reason"),
    [
        ("split", Reason.UNKNOWN_OPERATOR),
        ("Split-Face 1", Reason.UNKNOWN_OPERATOR),
        ("split-face", Reason.BAD_OPERAND),
        ("split-face 1 2", Reason.BAD_OPERAND),
        ("add-tetrahedron 1", Reason.BAD_OPERAND),
        ("bridge 1", Reason.BAD_OPERAND),
        ("split-face one", Reason.BAD_OPERAND),
        ("split-face 1.0", Reason.BAD_OPERAND),
        ("split-face 01", Reason.BAD_OPERAND),
        ("split-face +1", Reason.BAD_OPERAND),
        ("split-face -0", Reason.BAD_OPERAND),
        ("split-face 1_0", Reason.BAD_OPERAND),
        ("split-face \u0661", Reason.BAD_OPERAND),
        ("split-face " + "9" * 1001, Reason.BAD_OPERAND),
    ],
)
def test_rejection(piece: str, reason: Reason) -> None:
    """OPER-SCRIPT-6: the step is blamed."""
    answer = read(f"split-face 0; {piece}; nonsense")
    assert isinstance(answer, Rejected)
    assert (answer.reason, answer.clause) == (reason, Clause.OPER_SCRIPT_6)
    assert answer.where == AtStep(1)


def test_longest_number() -> None:
    """OPER-SCRIPT-6."""
    number = int("9" * 1000)
    assert read(write((SplitFace(number),))) == Accepted((SplitFace(number),))
