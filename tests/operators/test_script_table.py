"""The table of effects as a predicate: it holds for the rows of the page and for nothing else."""

from itertools import product

import pytest

from clers.operators.effect import Effect
from clers.operators.script import (
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
    SplitEdge,
    SplitFace,
)
from clers.operators.script_table import in_table

Row = tuple[int, int, int, int, int]

VERTICES = range(-5, 10)
FACES = range(-9, 20)
SIGNS = (-1, 0, 1)

TABLE: tuple[tuple[Operator, set[Row]], ...] = (
    (SplitFace(0), {(1, 2, 0, 0, 0)}),
    (SplitEdge(0), {(1, 2, 0, 0, 0), (1, 1, 0, 0, 0)}),
    (FlipEdge(0), {(0, 0, 0, 0, 0)}),
    (Relabel(0), {(0, 0, 0, 0, 0)}),
    (AddEar(0), {(1, 1, 0, 0, 0)}),
    (FillCorner(0), {(0, 1, 0, 0, 0), (0, 1, 0, 0, -1)}),
    (CloseCurve(0), {(1, p, 0, 0, -1) for p in FACES if p >= 3}),
    (OpenCurve(0), {(0, -1, 0, 0, 1), (1, 1, 0, 0, 1), (2, 3, 0, 0, 1), (3, 5, 0, 0, 1)}),
    # A vertex goes with a face that has two sides on the border, and that opens no curve.
    (
        RemoveFace(0),
        {(0, -1, 0, 0, 0), (-1, -1, 0, 0, 0), (0, -1, 0, 0, 1), (-3, -1, -1, 0, -1)},
    ),
    (RemoveStar(0), {(-1, -d, 0, 0, 1) for d in range(3, 10)}),
    (CutEdge(0), {(1, 0, 0, 0, 0), (2, 0, 0, 0, -1), (2, 0, 1, 0, 1), (2, 0, 0, -1, 1)}),
    (AddTetrahedron(), {(4, 4, 1, 0, 0)}),
    (AddHandle(0, 0), {(k, 2 * k + 4, 0, 1, 0) for k in (0, 1, 2, 3, 4, 5, 6)}),
    (JoinComponents(0, 0), {(0, 4, -1, 0, 0)}),
    (Bridge(0, 0), {(0, 2, -1, 0, -1), (0, 2, 0, 0, 1), (0, 2, 0, 1, -1)}),
)
"""By operator: vertices, faces, components, genus, curves."""


@pytest.mark.parametrize(("operator", "rows"), TABLE)
def test_rows_of_the_page_and_no_others(operator: Operator, rows: set[Row]) -> None:
    """Clause: OPER-SCRIPT-5."""
    found = {
        (v, f, c, g, b)
        for v, f, c, g, b in product(VERTICES, FACES, SIGNS, SIGNS, SIGNS)
        if in_table(operator, v, f, Effect(c, g, b))
    }
    assert found == rows


@pytest.mark.parametrize(
    ("effect", "chi"),
    [
        (Effect(), 0),
        (Effect(components=1), 2),
        (Effect(genus=1), -2),
        (Effect(curves=1), -1),
        (Effect(components=3, genus=2, curves=1), 1),
    ],
)
def test_euler_characteristic_of_an_effect(effect: Effect, chi: int) -> None:
    """Clause: OPER-SCRIPT-3. A sphere has 2, a handle takes 2 away, a hole 1."""
    assert effect.chi == chi
