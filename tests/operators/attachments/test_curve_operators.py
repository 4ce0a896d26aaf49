"""Curves: the rows of the table on curves drawn by hand, and what stays a curve."""

from pathlib import Path

import pytest

from clers.complexes.simplicial import Complex, closure
from clers.conventions.result import Accepted
from clers.operators.attachments.apply import apply, valence
from clers.operators.attachments.curves import (
    TABLE,
    CurveCase,
    CurveChange,
    curve_case,
    curve_change,
    ends,
    is_curve,
)
from clers.operators.attachments.operator import (
    CurveOperator,
    EdgeAndVertex,
    EdgeAtInterior,
    EdgeBetweenEnds,
    FirstVertex,
    Undo,
)

ARC = closure([(0, 1), (1, 2), (2, 3)])
TWO = closure([(0, 1), (1, 2), (2, 3), (4, 5), (5, 6), (7,)])

# Drawn and counted by hand: #0, #1, χ, components, closed curves, ends.
ROWS: tuple[tuple[CurveOperator, CurveCase, tuple[int, ...]], ...] = (
    (FirstVertex(8), CurveCase.FIRST_VERTEX, (1, 0, 1, 1, 0, 2)),
    (EdgeAndVertex(0, 8), CurveCase.MEV_AT_END, (1, 1, 0, 0, 0, 0)),
    (EdgeAndVertex(7, 8), CurveCase.MEV_AT_END, (1, 1, 0, 0, 0, 0)),
    (EdgeAndVertex(1, 8), CurveCase.MEV_INSIDE, (1, 1, 0, 0, 0, 1)),
    (EdgeBetweenEnds(0, 3), CurveCase.CLOSES, (0, 1, -1, 0, 1, -2)),
    (EdgeBetweenEnds(3, 4), CurveCase.JOINS, (0, 1, -1, -1, 0, -2)),
    (EdgeBetweenEnds(7, 4), CurveCase.JOINS, (0, 1, -1, -1, 0, -2)),
    (EdgeAtInterior(1, 3), CurveCase.INSIDE_TO_END, (0, 1, -1, 0, 1, -1)),
    (EdgeAtInterior(1, 4), CurveCase.INSIDE_TO_OTHER_END, (0, 1, -1, -1, 0, -1)),
    (EdgeAtInterior(1, 7), CurveCase.INSIDE_TO_OTHER_END, (0, 1, -1, -1, 0, -1)),
    (EdgeAtInterior(1, 5), CurveCase.INSIDE_TO_OTHER, (0, 1, -1, -1, 0, 0)),
)


@pytest.mark.parametrize(("operator", "case", "numbers"), ROWS)
def test_row(operator: CurveOperator, case: CurveCase, numbers: tuple[int, ...]) -> None:
    """OPER-CURVE-2, OPER-CURVE-3, OPER-CURVE-4, OPER-CURVE-5, OPER-CURVE-6."""
    after = apply(operator, TWO)
    assert isinstance(after, Accepted)
    assert curve_case(TWO, operator) is case
    assert curve_change(TWO, after.value) == CurveChange(*numbers) == TABLE[case]
    assert apply(Undo(operator), after.value) == Accepted(TWO)


def test_a_chord_between_interior_vertices() -> None:
    """The row that no pair of vertices of TWO has. Clause: OPER-CURVE-6."""
    circle = closure([(0, 1), (1, 2), (2, 3), (3, 0)])
    after = apply(EdgeAtInterior(0, 2), circle)
    assert after == Accepted(closure([(0, 1), (1, 2), (2, 3), (3, 0), (0, 2)]))
    assert curve_case(circle, EdgeAtInterior(0, 2)) is CurveCase.INSIDE
    assert curve_change(circle, after.value) == TABLE[CurveCase.INSIDE]
    assert TABLE[CurveCase.INSIDE] == CurveChange(0, 1, -1, 0, 1, 0)


def test_the_table_of_the_clause() -> None:
    """Clause: OPER-CURVE-6."""
    page = Path(__file__).parents[3] / "spec" / "04-attachments.md"
    text = page.read_text("utf-8").replace("−", "-")
    for case, change in TABLE.items():
        (row,) = [r for r in text.splitlines() if r.startswith(f"> | {case} |")]
        numbers = tuple(int(cell) for cell in row.split("|")[2:-1])
        assert CurveChange(*numbers) == change


@pytest.mark.parametrize(
    ("k", "curve", "free"),
    [
        (Complex(frozenset()), True, 0),
        (closure([(0,)]), True, 2),
        (ARC, True, 2),
        (TWO, True, 6),
        (closure([(0, 1), (1, 2), (0, 2)]), True, 0),
        (closure([(0, 1), (0, 2), (0, 3)]), False, 3),
        (closure([(0, 1, 2)]), False, 0),
    ],
)
def test_curves_and_ends(k: Complex, curve: bool, free: int) -> None:
    """Clauses: OPER-CURVE-6, OPER-CURVE-7."""
    assert is_curve(k) is curve
    assert ends(k) == free


def test_valence() -> None:
    """Clause: OPER-CURVE-1."""
    assert [valence(TWO, v) for v in range(9)] == [1, 2, 2, 1, 1, 2, 1, 0, 0]
