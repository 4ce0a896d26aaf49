"""OPER-BUILD-5, OPER-BUILD-6: scripts on sheets as text, and running them."""

import pytest
from golden_sheets import DISK, script, sheet

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtStep
from clers.operators.sheets.apply import run, stages, steps
from clers.operators.sheets.operator import (
    Complete,
    Glue,
    Join,
    JoinStrip,
    Lower,
    LowerStrip,
    MakeEKL,
    MakeEV,
    MakeSG,
    MakeSTV,
    MakeTE,
    Operator,
    TwoHandle,
    Undo,
    Upper,
    UpperStrip,
    ZeroHandle,
    ZeroHandlePolygon,
    inverse,
)
from clers.operators.sheets.sheet import EMPTY
from clers.operators.sheets.text import name_of, operands, read, write

NAMES: tuple[tuple[str, str, Operator], ...] = (
    ("make-stv 1 2 3", "kill-stv 1 2 3", MakeSTV(1, 2, 3)),
    ("make-ev 1 2 3", "kill-ev 1 2 3", MakeEV(1, 2, 3)),
    ("make-te 1 2 3", "kill-te 1 2 3", MakeTE(1, 2, 3)),
    ("make-sg 1 2 3", "kill-sg 1 2 3", MakeSG(1, 2, 3)),
    ("make-ekl 1 2 3 4", "kill-ekl 1 2 3 4", MakeEKL(1, 2, 3, 4)),
    ("zero-handle 1 2 3", "undo-zero-handle 1 2 3", ZeroHandle(1, 2, 3)),
    (
        "zero-handle-polygon 1 2 3 4 5",
        "undo-zero-handle-polygon 1 2 3 4 5",
        ZeroHandlePolygon((1, 2, 3, 4, 5)),
    ),
    ("complete 1 2 3", "undo-complete 1 2 3", Complete(1, 2, 3)),
    ("glue 1 2 3", "undo-glue 1 2 3", Glue(1, 2, 3)),
    ("join 1 2 3 4", "undo-join 1 2 3 4", Join(1, 2, 3, 4)),
    ("lower 1 2 3 4", "undo-lower 1 2 3 4", Lower(1, 2, 3, 4)),
    ("upper 1 2 3 4", "undo-upper 1 2 3 4", Upper(1, 2, 3, 4)),
    ("two-handle 1 2 3", "undo-two-handle 1 2 3", TwoHandle(1, 2, 3)),
    ("join-strip 1 2 3 4", "undo-join-strip 1 2 3 4", JoinStrip(1, 2, 3, 4)),
    ("lower-strip 1 2 3 4", "undo-lower-strip 1 2 3 4", LowerStrip(1, 2, 3, 4)),
    ("upper-strip 1 2 3 4", "undo-upper-strip 1 2 3 4", UpperStrip(1, 2, 3, 4)),
)


@pytest.mark.parametrize(("text", "undo", "operator"), NAMES)
def test_names(text: str, undo: str, operator: Operator) -> None:
    """OPER-BUILD-5: each operator's text and that of its inverse, both ways."""
    assert write((operator,)) == text
    assert write((inverse(operator),)) == undo
    assert read(text) == Accepted((operator,))
    assert read(undo) == Accepted((inverse(operator),))
    assert name_of(operator) == text.split()[0]
    assert operands(operator) == tuple(map(int, text.split()[1:]))


def test_separators() -> None:
    """OPER-BUILD-5."""
    expected = (ZeroHandle(0, 1, 2), Undo(ZeroHandle(0, 1, 2)))
    assert read(";zero-handle 0  1 2\n\r\n ;undo-zero-handle 0 1\t2;") == Accepted(expected)
    assert read("") == Accepted(())
    assert write(()) == ""
    assert write(expected) == "zero-handle 0 1 2; undo-zero-handle 0 1 2"


@pytest.mark.parametrize(
    ("text", "reason", "step"),
    [
        ("zero-handle 0 1 2; glued 1 0 3", Reason.UNKNOWN_OPERATOR, 1),
        ("undo-make-te 0 1 2", Reason.UNKNOWN_OPERATOR, 0),
        ("kill-glue 0 1 2", Reason.UNKNOWN_OPERATOR, 0),
        ("Glue 0 1 2", Reason.UNKNOWN_OPERATOR, 0),
        ("glue 0 1", Reason.BAD_OPERAND, 0),
        (";;glue 0 1 2; ;glue 0 1 2 3", Reason.BAD_OPERAND, 1),
        ("lower 0 1 2", Reason.BAD_OPERAND, 0),
        ("undo-lower 0 1 2 3 4", Reason.BAD_OPERAND, 0),
        ("glue 0 1 -2", Reason.BAD_OPERAND, 0),
        ("glue 0 1 02", Reason.BAD_OPERAND, 0),
        ("glue 0 1 ²", Reason.BAD_OPERAND, 0),
        ("zero-handle-polygon 0 1 x", Reason.BAD_OPERAND, 0),
        ("glue 0 1 1" + "0" * 1000, Reason.BAD_OPERAND, 0),
    ],
)
def test_no_script(text: str, reason: Reason, step: int) -> None:
    """OPER-BUILD-5."""
    result = read(text)
    assert isinstance(result, Rejected)
    assert (result.reason, result.clause, result.where) == (
        reason,
        Clause.OPER_BUILD_5,
        AtStep(step),
    )
    assert result.detail


def test_a_thousand_digits() -> None:
    """OPER-BUILD-5."""
    number = "1" + "0" * 999
    assert read(f"glue 0 1 {number}") == Accepted((Glue(0, 1, 10**999),))
    assert read("zero-handle-polygon") == Accepted((ZeroHandlePolygon(()),))


def test_steps_end_at_the_first_refusal() -> None:
    """OPER-BUILD-6."""
    text = f"{DISK}; glue 9 8 7; zero-handle 20 21 22"
    done, fault = stages(script(text))
    assert [stage.numbers.vertices for stage in done] == [3, 4, 5, 6]
    assert done[-1].sheet == sheet(DISK)
    assert isinstance(fault, Rejected)
    assert fault.reason is Reason.OPERATOR_NOT_APPLICABLE
    assert (fault.clause, fault.where) == (Clause.OPER_SURFACE_3, AtStep(4))
    assert fault.detail == "at simplex {8, 9}: 9→8 is on no loop"
    assert steps(script(text)) == fault
    assert run(script(text)) == fault


def test_running_from_a_sheet() -> None:
    """OPER-BUILD-6."""
    assert run(()) == Accepted(EMPTY)
    assert run((), sheet(DISK)) == Accepted(sheet(DISK))
    begun = run(script("glue 0 2 6"), sheet(DISK))
    assert begun == Accepted(sheet(f"{DISK}; glue 0 2 6"))
