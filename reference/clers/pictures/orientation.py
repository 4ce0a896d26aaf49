"""Which way three points of the plane run, without an error."""

from fractions import Fraction

import numpy as np

from clers.pictures.drawing import Point
from clers.pictures.tutte import Floats, Ints, areas_of

DOUBT = 4.0 * float(np.finfo(np.float64).eps)
"""Relative to the products, the floating-point determinant is nearer than this to the exact one."""


def orientation(a: Point, b: Point, c: Point) -> int:
    """1 if a, b, c run counter-clockwise, −1 if clockwise, 0 if they are on one line. Exact."""
    (ax, ay), (bx, by), (cx, cy) = a, b, c
    left, right = (bx - ax) * (cy - ay), (by - ay) * (cx - ax)
    if abs(left - right) > DOUBT * (abs(left) + abs(right)):
        return 1 if left > right else -1
    u = Fraction(bx) - Fraction(ax), Fraction(by) - Fraction(ay)
    v = Fraction(cx) - Fraction(ax), Fraction(cy) - Fraction(ay)
    exact = u[0] * v[1] - u[1] * v[0]
    return (exact > 0) - (exact < 0)


def turned(triangles: Ints, places: Floats) -> int:
    """How many triangles do not run counter-clockwise. Exact."""
    at = places[triangles]
    sides = np.abs(np.roll(at, -1, axis=1) - at).max(axis=(1, 2))
    doubtful = np.flatnonzero(areas_of(triangles, places) <= 1e-12 * sides**2)
    corners = at[doubtful].tolist()
    return sum(orientation(tuple(a), tuple(b), tuple(c)) <= 0 for a, b, c in corners)
