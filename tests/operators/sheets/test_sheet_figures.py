"""Figures 9 to 13 of the tutorial: what each operator makes, counted by hand before and after."""

import pytest
from golden_sheets import ANNULUS, DISK, TRIANGLE, TWO_TRIANGLES, script, sheet

from clers.complexes.homology import Field
from clers.conventions.result import Accepted
from clers.operators.sheets.apply import apply, run, steps
from clers.operators.sheets.numbers import Numbers, betti_of_closed, numbers
from clers.operators.sheets.operator import Undo, taken_apart
from clers.operators.sheets.sheet import EMPTY, Sheet, sheet_of
from clers.operators.sheets.surfaces import apply_to_surface

TORUS = (
    ("zero-handle 0 1 2", (3, 3, 1, 1, 1, 0, 1)),
    ("glue 2 1 3", (4, 5, 2, 1, 1, 0, 1)),  # Figure 10
    ("glue 2 3 4", (5, 7, 3, 1, 1, 0, 1)),
    ("glue 4 3 5", (6, 9, 4, 1, 1, 0, 1)),
    ("lower-strip 1 0 4 5", (6, 12, 6, 0, 1, 0, 2)),  # Figure 11: b+1, χ−1
    ("upper-strip 5 3 0 2", (6, 15, 8, -1, 1, 1, 1)),  # Figure 12: g+1, b−1, χ−1
    ("glue 5 2 6", (7, 17, 9, -1, 1, 1, 1)),
    ("complete 6 2 4", (7, 18, 10, -1, 1, 1, 1)),
    ("complete 6 4 0", (7, 19, 11, -1, 1, 1, 1)),
    ("complete 6 0 3", (7, 20, 12, -1, 1, 1, 1)),
    ("complete 6 3 1", (7, 21, 13, -1, 1, 1, 1)),
    ("two-handle 6 1 5", (7, 21, 14, 0, 1, 1, 0)),  # Figure 13: b−1, χ+1
)
"""The torus of seven vertices, each joined to each, by surface operators alone."""


def test_the_torus_of_seven_vertices() -> None:
    """OPER-SURFACE-1 … OPER-SURFACE-9, OPER-BUILD-6: every step, all its numbers."""
    found = steps(script("; ".join(text for text, _ in TORUS)))
    assert isinstance(found, Accepted)
    assert [stage.numbers for stage in found.value] == [Numbers(*n) for _, n in TORUS]
    torus = found.value[-1].sheet
    assert torus.loops == frozenset()
    assert betti_of_closed(torus, Field.GF2) == (1, 2, 1)


def test_the_torus_is_a_surface_all_the_way_and_back() -> None:
    """OPER-SURFACE-10."""
    made: list[Sheet] = [EMPTY]
    for text, _ in TORUS:
        (operator,) = script(text)
        result = apply_to_surface(operator, made[-1])
        assert isinstance(result, Accepted)
        made.append(result.value)
    for (text, _), before, after in reversed(list(zip(TORUS, made, made[1:], strict=False))):
        (operator,) = taken_apart(script(text))
        assert isinstance(operator, Undo)
        assert apply_to_surface(operator, after) == Accepted(before)


@pytest.mark.parametrize(
    ("start", "operators", "triangles", "loops"),
    [
        # Figure 9, from the triangle (0, 1, 2) with the loop 2 → 1 → 0.
        (TRIANGLE, "make-ev 1 0 3", [(0, 1, 2)], [(2, 1, 3, 1, 0)]),
        (TRIANGLE, "make-ev 1 0 3; make-te 2 1 3", [(0, 1, 2), (2, 1, 3)], [(2, 3, 1, 0)]),
        (TRIANGLE, "glue 2 1 3", [(0, 1, 2), (2, 1, 3)], [(2, 3, 1, 0)]),
        (
            TRIANGLE,
            "glue 2 1 3; glue 1 0 4; make-te 3 1 4",
            [(0, 1, 2), (2, 1, 3), (1, 0, 4), (3, 1, 4)],
            [(2, 3, 4, 0)],
        ),
        (
            TRIANGLE,
            "glue 2 1 3; make-te 3 1 0; make-sg 2 3 0",
            [(0, 1, 2), (2, 1, 3), (3, 1, 0), (2, 3, 0)],
            [],
        ),
        (TRIANGLE, "kill-sg 0 1 2", [], [(0, 1, 2), (2, 1, 0)]),
        (TRIANGLE, "kill-te 0 1 2", [], [(0, 1, 2, 1)]),
        (TRIANGLE, "kill-te 0 1 2; kill-ev 1 2 0", [], [(1, 2)]),
        (TWO_TRIANGLES, "join 1 0 3 5", [(0, 1, 2), (3, 4, 5), (1, 0, 3)], [(2, 1, 3, 5, 4, 3, 0)]),
        (
            TWO_TRIANGLES,
            "make-ekl 1 0 3 5",
            [(0, 1, 2), (3, 4, 5)],
            [(1, 3, 5, 4, 3, 1, 0, 2)],
        ),
        (
            TWO_TRIANGLES,
            "join-strip 1 0 3 5",
            [(0, 1, 2), (3, 4, 5), (1, 0, 3), (1, 3, 5)],
            [(2, 1, 5, 4, 3, 0)],
        ),
        ("", "zero-handle-polygon 3 4 5 6", [], [(3, 4, 5, 6)]),
    ],
)  # fmt: skip
def test_operators_by_hand(
    start: str,
    operators: str,
    triangles: list[tuple[int, ...]],
    loops: list[tuple[int, ...]],
) -> None:
    """OPER-EULER-1 … OPER-EULER-5, OPER-SURFACE-3, OPER-SURFACE-4, OPER-SURFACE-9."""
    begun = sheet(start)
    result = run(script(operators), begun)
    assert isinstance(result, Accepted)
    assert result.value == sheet_of(triangles, loops, result.value.polygons)
    assert run(taken_apart(script(operators)), result.value) == Accepted(begun)


@pytest.mark.parametrize(
    ("start", "operator", "loops"),
    [
        (DISK, "lower 1 0 4 5", [(1, 4, 5, 3), (4, 0, 2)]),
        (DISK, "lower-strip 1 0 4 5", [(1, 5, 3), (4, 0, 2)]),
        (ANNULUS, "upper 5 3 0 2", [(5, 0, 2, 4, 0, 3, 1)]),
        (ANNULUS, "upper-strip 5 3 0 2", [(5, 2, 4, 0, 3, 1)]),
        (ANNULUS, "make-ekl 5 3 0 2", [(5, 0, 2, 4, 0, 5, 3, 1)]),
    ],
)
def test_loops_by_hand(start: str, operator: str, loops: list[tuple[int, ...]]) -> None:
    """OPER-SURFACE-5, OPER-SURFACE-6, OPER-SURFACE-9, OPER-EULER-5."""
    (one,) = script(operator)
    result = apply(one, sheet(start))
    assert isinstance(result, Accepted)
    assert result.value.loops == sheet_of((), loops).loops


@pytest.mark.parametrize(
    ("start", "operator", "expected"),
    [
        (TWO_TRIANGLES, "make-ekl 1 0 3 5", (6, 7, 2, 1, 1, 0, 1)),
        (ANNULUS, "make-ekl 5 3 0 2", (6, 13, 6, -1, 1, 1, 1)),
        (TWO_TRIANGLES, "join 1 0 3 5", (6, 8, 3, 1, 1, 0, 1)),
        (DISK, "lower 1 0 4 5", (6, 11, 5, 0, 1, 0, 2)),
        (ANNULUS, "upper 5 3 0 2", (6, 14, 7, -1, 1, 1, 1)),
        (TRIANGLE, "zero-handle-polygon 5 6 7 8", (7, 7, 2, 2, 2, 0, 2)),
        (TRIANGLE, "kill-sg 0 1 2", (3, 3, 0, 0, 1, 0, 2)),
        (TRIANGLE, "kill-stv 0 1 2", (0, 0, 0, 0, 0, 0, 0)),
    ],
)
def test_numbers_by_hand(start: str, operator: str, expected: tuple[int, ...]) -> None:
    """OPER-SHEET-3, OPER-EFFECT-2."""
    (one,) = script(operator)
    result = apply(one, sheet(start))
    assert isinstance(result, Accepted)
    assert numbers(result.value) == Numbers(*expected)
