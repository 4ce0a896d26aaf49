"""Moves as text: how each is written, and what is rejected."""

import pytest

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtStep
from clers.operators.moves.move import (
    Bistellar,
    Collapse,
    Contract,
    Expand,
    Move,
    Split,
    Subdivide,
    Weld,
)
from clers.operators.moves.text import read, write

WRITTEN: tuple[tuple[Move, str], ...] = (
    (Collapse((0, 1), (0, 1, 2)), "collapse 0 1 / 0 1 2"),
    (Expand((0,), (0, 10)), "expand 0 / 0 10"),
    (Subdivide((0, 1), 7), "subdivide 0 1 / 7"),
    (Weld((0, 1), 7), "weld 0 1 / 7"),
    (Bistellar((0, 1), (2, 3)), "bistellar 0 1 / 2 3"),
    (Contract(3, 4), "contract 3 / 4"),
    (Split(0, 7, ((1, 2), (2, 3)), ((1,), (3,))), "split 0 / 7 / 1 2, 2 3 / 1, 3"),
    (Split(0, 7, ((1,),), ()), "split 0 / 7 / 1 /"),
    (Split(0, 7, (), ()), "split 0 / 7 /  /"),
)


@pytest.mark.parametrize(("move", "text"), WRITTEN)
def test_written(move: Move, text: str) -> None:
    """Clause: OPER-MOVE-8."""
    assert write((move,)) == text
    assert read(text) == Accepted((move,))


def test_lists() -> None:
    """Clause: OPER-MOVE-8."""
    moves = (Contract(0, 1), Weld((2,), 3))
    assert write(moves) == "contract 0 / 1; weld 2 / 3"
    for text in ("contract 0 / 1;weld 2/3", "\ncontract 0/1\r\n;; weld  2 /\t3 ;"):
        assert read(text) == Accepted(moves)
    assert write(()) == ""
    assert read(" ;\n") == Accepted(())


UNKNOWN, OPERAND = Reason.UNKNOWN_OPERATOR, Reason.BAD_OPERAND

REFUSED: tuple[tuple[str, Reason, int], ...] = (
    ("colapse 0 / 0 1", UNKNOWN, 0),
    ("Contract 0 / 1", UNKNOWN, 0),
    ("contract 0 / 1; 7", UNKNOWN, 1),
    ("contract", OPERAND, 0),
    ("contract 0", OPERAND, 0),
    ("contract 0 1 / 2", OPERAND, 0),
    ("contract 0, 1 / 2", OPERAND, 0),
    ("contract 0 / 1 / 2", OPERAND, 0),
    ("contract 0 / 1 2", OPERAND, 0),
    ("contract -1 / 0", OPERAND, 0),
    ("contract 01 / 0", OPERAND, 0),
    ("contract x / 0", OPERAND, 0),
    ("contract ١ / 0", OPERAND, 0),
    ("contract 1" + "0" * 1000 + " / 0", OPERAND, 0),
    ("; contract 0 / 1; collapse 0 1", OPERAND, 1),
    ("collapse 0 / 0 1 / 2", OPERAND, 0),
    ("collapse 0 1 / 0 1, 2", OPERAND, 0),
    ("collapse / 0", OPERAND, 0),
    ("expand 0, 1 / 0 1", OPERAND, 0),
    ("subdivide 0 1", OPERAND, 0),
    ("subdivide 0 1 / 2 3", OPERAND, 0),
    ("weld 0 1 / 2, 3", OPERAND, 0),
    ("bistellar 0 1 /", OPERAND, 0),
    ("split 0 / 7 / 1", OPERAND, 0),
    ("split 0 1 / 7 / 1 / 1", OPERAND, 0),
    ("split 0 / 7 / 1, / 1", OPERAND, 0),
    ("split 0 / 7 / 1 / ,", OPERAND, 0),
    ("split 0 / 7 / 1 / / ", OPERAND, 0),
)


@pytest.mark.parametrize(("text", "reason", "step"), REFUSED)
def test_refused(text: str, reason: Reason, step: int) -> None:
    """Clause: OPER-MOVE-8."""
    result = read(text)
    assert isinstance(result, Rejected)
    assert (result.reason, result.where) == (reason, AtStep(step))
    assert result.clause is Clause.OPER_MOVE_8


def test_the_fault_is_named() -> None:
    details = [
        ("contract 0x / 1", "'0x' is no number"),
        ("contract 0 / " + "z" * 30, "'" + "z" * 20 + "' is no number"),
        ("split 0 / 7 / 1, / 1", "a simplex without vertices"),
        ("contract 0", "contract with other operands than it has"),
        ("contrac 0", "contrac"),
    ]
    for text, detail in details:
        result = read(text)
        assert isinstance(result, Rejected)
        assert result.detail == detail


def test_a_thousand_digits_are_a_number() -> None:
    assert read("contract 1" + "0" * 999 + " / 0") == Accepted((Contract(10**999, 0),))
