"""Where the border of a disc is put: on a circle, or on a polygon inscribed in one."""

from math import cos, pi, sin

from clers.pictures.disc import Disc
from clers.pictures.drawing import Point


def border_places(disc: Disc, bulge: float) -> tuple[Point, ...]:
    """A place for each point of the border, counter-clockwise around the origin, radius 1.

    A side of a cut surface is straight, its points at even distances; with `bulge` up to 1 it bends
    outward to the circle, which makes the border strictly convex. Each edge of another border is a
    side of its own. The first side lies at the bottom.
    """
    count = len(disc.outer)
    begins = [place for place, _ in disc.sides] or list(range(count))
    ends = [*begins[1:], count]
    first = -pi / 2 - pi * ends[0] / count
    angles = [first + 2 * pi * i / count for i in range(count + 1)]
    places: list[Point] = []
    for begin, end in zip(begins, ends, strict=True):
        for i in range(begin, end):
            share = (i - begin) / (end - begin)
            x = (1 - share) * cos(angles[begin]) + share * cos(angles[end])
            y = (1 - share) * sin(angles[begin]) + share * sin(angles[end])
            places.append(
                (
                    (1 - bulge) * x + bulge * cos(angles[i]),
                    (1 - bulge) * y + bulge * sin(angles[i]),
                )
            )
    return tuple(places)
