"""The parts of the flat layout by themselves."""

from fractions import Fraction
from math import hypot, isclose
from typing import Final

import numpy as np
import pytest
from pictured import built

from clers.conventions.verdict import Holds
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import TORUS
from clers.pictures.cut import cut_edges, ends
from clers.pictures.disc import disc_of
from clers.pictures.drawing import Point
from clers.pictures.laws_flat import cuts_leave_discs
from clers.pictures.lettering import letters
from clers.pictures.orientation import orientation, turned
from clers.pictures.polygon import border_places
from clers.pictures.relax import relaxed
from clers.pictures.table import curves_of, filled, table_of
from clers.pictures.tutte import tutte

FAN: Final = np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])
"""A square with a point inside."""

SQUARE: Final = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]


@pytest.mark.parametrize(("far", "farther"), [(12.0, 24.0), (8.8000000000000007, 12.1)])
def test_orientation_is_exact(far: float, farther: float) -> None:
    """On a grid of neighbouring doubles near a line through two points of the diagonal.

    There the determinant in floating point is wrong: zero for the first pair, and often of the
    wrong sign for the second (Kettner and others, 2008). Clause: TOOL-PICTURE-7.
    """
    b, c = (far, far), (farther, farther)
    wrong = 0
    for i in range(48):
        for j in range(48):
            a: Point = (0.5 + i * 2.0**-53, 0.5 + j * 2.0**-53)
            (ax, ay), (bx, by), (cx, cy) = ((Fraction(x), Fraction(y)) for x, y in (a, b, c))
            exact = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
            assert orientation(a, b, c) == (exact > 0) - (exact < 0)
            inexact = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
            wrong += (inexact > 0) - (inexact < 0) != (exact > 0) - (exact < 0)
    assert wrong > 1000


def test_turned_triangles_are_counted() -> None:
    """Those on a line too. Clause: TOOL-PICTURE-7."""
    free = [[0.5, 0.5], [0.5, 0.0], [0.5, -1.0], [2.0, 2.0]]
    assert [turned(FAN, np.array([*SQUARE, at])) for at in free] == [0, 1, 1, 2]


def test_tutte_puts_a_point_amid_its_neighbours() -> None:
    """Clause: TOOL-PICTURE-7."""
    places = np.array([*SQUARE, [7.0, -3.0]])
    solved = tutte(FAN, places, np.array([False] * 4 + [True]))
    assert solved[:4].tolist() == SQUARE
    assert np.allclose(solved[4], [0.5, 0.5])


def test_relaxing_goes_to_the_middle_and_never_through_an_edge() -> None:
    """A drawing with a turned triangle is left alone. Clause: TOOL-PICTURE-7."""
    free = np.array([False] * 4 + [True])
    better = relaxed(FAN, np.array([*SQUARE, [0.9, 0.8]]), free)
    assert np.allclose(better[4], [0.5, 0.5], atol=0.02)
    over = np.array([*SQUARE, [0.5, -0.01]])
    assert relaxed(FAN, over, free).tolist() == over.tolist()


@pytest.mark.parametrize("bulge", [0.0, 0.3, 1.0])
def test_border_is_convex(bulge: float) -> None:
    """Inside the circle, on it at the sides' ends; sides bend if asked. Clause: TOOL-PICTURE-7."""
    disc = disc_of(table_of(TORUS, encode(TORUS).tip_order))
    places = border_places(disc, bulge)
    assert [place for place, _ in disc.sides] == [0, 3, 6, 9]
    assert all(isclose(hypot(*places[i]), 1) for i in (0, 3, 6, 9))
    assert all(hypot(*place) <= 1 + 1e-12 for place in places)
    turns = [orientation(places[i - 1], places[i], places[(i + 1) % 12]) for i in range(12)]
    assert all(turns[i] == 1 for i in (0, 3, 6, 9))
    if bulge > 0:
        assert turns == [1] * 12
    else:
        for i in (1, 2):
            assert isclose(places[i][1], places[0][1])
    if bulge == 1:
        assert all(isclose(hypot(*place), 1) for place in places)


def test_tree_of_vertices_goes_around_holes() -> None:
    """A torus of 9 × 9 squares with a hole of 5 × 5: the way across the hole would be short.

    Clause: TOOL-PICTURE-6.
    """
    faces = [
        (9 * i + j, 9 * k + j, 9 * k + m, 9 * i + m)
        for i in range(9)
        for j in range(9)
        for k, m in [((i + 1) % 9, (j + 1) % 9)]
        if not (2 <= i < 7 and 2 <= j < 7)
    ]
    used = sorted({v for face in faces for v in face})
    at = {v: n for n, v in enumerate(used)}
    triangles = [
        (at[x], at[y], at[z]) for a, b, c, d in faces for x, y, z in ((a, b, c), (a, c, d))
    ]
    holed = built(triangles, len(used))
    table = table_of(holed, encode(holed).tip_order)
    (hole,) = curves_of(table)
    assert len(hole) == 20
    closed = filled(table, [hole])
    cut = cut_edges(closed)
    assert {v for c in cut for v in ends(closed, c)} <= set(range(len(used)))
    assert len(cut) == 2 * (9 + 9)
    assert cuts_leave_discs(holed) == Holds()


def test_letters_count_on() -> None:
    """Clause: TOOL-PICTURE-6."""
    assert [letters(n) for n in (0, 25, 26, 27, 51, 52, 701, 702)] == [
        "a", "z", "aa", "ab", "az", "ba", "zz", "aaa",
    ]  # fmt: skip
