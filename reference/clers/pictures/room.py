"""Where a triangle has most room for a letter, away from its edges and from the signs at its ends.

One place serves all panels of a picture, so places are remembered.
"""

from functools import lru_cache
from math import dist
from typing import Final

from clers.pictures.drawing import Point

Corners = tuple[Point, Point, Point]

GRAIN: Final = 12
"""Places tried are means of the corners with weights that are multiples of 1/12."""

SIGN: Final = 0.037
"""The radius of a vertex's sign at its largest, in units of a panel."""


@lru_cache(maxsize=1 << 12)
def roomiest(corners: Corners) -> tuple[Point, float]:
    """The best place of those tried, and the radius of a disc that fits there."""
    tried = (
        _mean(corners, (i, j, GRAIN - i - j))
        for i in range(1, GRAIN - 1)
        for j in range(1, GRAIN - i)
    )
    room, at = max((_room(corners, at), at) for at in tried)
    return at, max(room, 0.0)


def _mean(corners: Corners, weights: tuple[int, int, int]) -> Point:
    (ax, ay), (bx, by), (cx, cy) = corners
    i, j, k = weights
    return (i * ax + j * bx + k * cx) / GRAIN, (i * ay + j * by + k * cy) / GRAIN


def _room(corners: Corners, at: Point) -> float:
    """The distance to the nearest edge or sign."""
    edges = zip(corners, (*corners[1:], corners[0]), strict=True)
    beside = min(_height(a, b, at) for a, b in edges)
    return min(beside, min(dist(corner, at) for corner in corners) - SIGN)


def _height(a: Point, b: Point, at: Point) -> float:
    """The distance of a point from the line through two others."""
    twice = abs((b[0] - a[0]) * (at[1] - a[1]) - (b[1] - a[1]) * (at[0] - a[0]))
    return twice / (dist(a, b) or 1.0)
