"""The ribbon: the faces in the order of the walk, as one strip of triangles broken into lines.

It shows the word and nothing of the surface's shape, but it can be drawn of any surface at once.
"""

from collections.abc import Sequence
from math import ceil, sqrt
from typing import Final

from clers.complexes.surface import Corner, Face, Surface, next_corner, previous_corner
from clers.pictures.drawing import Drawing, Point

HEIGHT: Final = sqrt(3) / 2
"""The height of a triangle whose sides are 1."""

GAP: Final = 0.35
"""The white between two lines."""


def ribbon(surface: Surface, tips: Sequence[Corner]) -> Drawing:
    """Lines are read as text is, and are about as long as all of them are high: TOOL-PICTURE-9."""
    count = len(tips)
    line = ceil(sqrt(2 * (HEIGHT + GAP) * count))
    corners: list[Point] = [(0.0, 0.0)] * len(surface.vertex)
    for step, tip in enumerate(tips):
        row, place = divmod(step, line)
        x, low = place / 2, -row * (HEIGHT + GAP)
        high = low + HEIGHT
        if place % 2 == 0:  # the tip is up, the left end left
            shape = (x + 0.5, high), (x, low), (x + 1, low)
        else:
            shape = (x + 0.5, low), (x + 1, high), (x, high)
        turns = tip, next_corner(tip), previous_corner(tip)
        for c, at in zip(turns, shape, strict=True):
            corners[c] = at
    faces = surface.faces
    return Drawing(
        corners=tuple(corners),
        order=tuple(Face(tip // 3) for tip in tips),
        far=(False,) * faces,
        light=(1.0,) * faces,
        ribbon=True,
    )
