"""The flat drawing: each component as a disc, none of its triangles over another."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt
from typing import Final

import numpy as np

from clers.complexes.surface import BORDER, Corner, Face, Surface, next_corner, previous_corner
from clers.pictures.disc import Disc, disc_of
from clers.pictures.drawing import Drawing, Point, Ring
from clers.pictures.orientation import turned
from clers.pictures.polygon import border_places
from clers.pictures.relax import relaxed
from clers.pictures.table import table_of
from clers.pictures.tutte import Floats, areas_of, tutte

AROUND: Final = 1.15
"""The radius of a disc's place, and of the ring that shows a sphere's last face."""

BULGES: Final = (0.0, 0.3)
"""Sides of a cut polygon are straight, unless a triangle has nothing but points of one side."""

THIN: Final = 1e-9
"""A triangle of a smaller area might as well lie on a line."""


@dataclass(frozen=True, slots=True)
class _Part:
    """One component, drawn around the origin with radius 1."""

    tips: tuple[Corner, ...]
    disc: Disc
    places: Floats
    turned: int


def flat(surface: Surface, components: Sequence[tuple[Corner, ...]]) -> Drawing:
    """Draw each component, given by its faces' tips in the order of the walk.

    Clauses: TOOL-PICTURE-6, TOOL-PICTURE-7.
    """
    parts = [_drawn(surface, tips) for tips in components]
    centres = _rows([sqrt(len(part.tips)) for part in parts])
    corners: list[Point] = [(0.0, 0.0)] * len(surface.vertex)
    rings: list[Ring] = []
    notes: list[tuple[Point, str]] = []
    cuts: set[Corner] = set()
    for part, (x, y, scale) in zip(parts, centres, strict=True):
        places: list[list[float]] = (part.places * scale + (x, y)).tolist()
        for f, tip in enumerate(part.tips):
            for i, c in enumerate((tip, next_corner(tip), previous_corner(tip))):
                px, py = places[part.disc.point[3 * f + i]]
                corners[c] = (px, py)
        if part.disc.outside:
            rings.append(Ring(Face(part.tips[-1] // 3), (x, y), AROUND * scale))
        for at, letter in _letters(part):
            notes.append(((x + scale * at[0], y + scale * at[1]), letter))
        cuts |= _cuts(surface, part)
    order = [Face(f) for f in range(surface.faces)]
    outside = {ring.face for ring in rings}
    return Drawing(
        corners=tuple(corners),
        order=tuple(sorted(order, key=lambda f: (f not in outside, f))),
        far=(False,) * surface.faces,
        light=(1.0,) * surface.faces,
        rings=tuple(rings),
        cuts=frozenset(cuts),
        notes=tuple(notes),
        turned=sum(part.turned for part in parts),
    )


def _drawn(surface: Surface, tips: tuple[Corner, ...]) -> _Part:
    """Tutte's drawing, made easier to read. Clause: TOOL-PICTURE-7."""
    disc = disc_of(table_of(surface, tips))
    triangles = np.array(disc.point, dtype=np.int64).reshape(-1, 3)
    if disc.outside:
        triangles = np.delete(triangles, disc.real - 1, axis=0)
    free = np.ones(disc.points, dtype=np.bool_)
    free[list(disc.outer)] = False
    places = np.zeros((disc.points, 2))
    for bulge in BULGES if disc.sides else (0.0,):
        places = np.zeros((disc.points, 2))
        places[list(disc.outer)] = border_places(disc, bulge)
        places = tutte(triangles, places, free)
        if float(areas_of(triangles, places).min()) > THIN:
            break
    places = relaxed(triangles, places, free)
    return _Part(tips, disc, places, turned(triangles, places))


def _rows(sizes: Sequence[float]) -> list[tuple[float, float, float]]:
    """A centre and a radius for each disc, in rows from left to right, the first row at the top.

    Rows are filled to about the width of a square that would hold all discs.
    """
    width = max(sqrt(sum((2 * AROUND * size) ** 2 for size in sizes)), 2 * AROUND * max(sizes))
    rows: list[list[float]] = [[]]
    for size in sizes:
        if rows[-1] and 2 * AROUND * (sum(rows[-1]) + size) > width * 1.001:
            rows.append([])
        rows[-1].append(size)
    centres: list[tuple[float, float, float]] = []
    top = 0.0
    for row in rows:
        x = 0.0
        for size in row:
            centres.append((x + AROUND * size, top - AROUND * max(row), size))
            x += 2 * AROUND * size
        top -= 2 * AROUND * max(row)
    return centres


def _letters(part: _Part) -> list[tuple[Point, str]]:
    """The letter of each side of a cut polygon, outside of the side's middle."""
    outer = part.disc.outer
    ends = [*(place for place, _ in part.disc.sides[1:]), len(outer)]
    found: list[tuple[Point, str]] = []
    for (begin, letter), end in zip(part.disc.sides, ends, strict=False):
        # the middle of the side, be it a point or the middle of an edge
        low, high = (begin + end) // 2, (begin + end + 1) // 2
        x, y = (part.places[outer[low]] + part.places[outer[high % len(outer)]]) / 2
        stretch = 1 + 0.1 / sqrt(x * x + y * y)
        found.append(((float(x) * stretch, float(y) * stretch), letter))
    return found


def _cuts(surface: Surface, part: _Part) -> set[Corner]:
    """The corners opposite to border edges of the disc that are no border of the surface."""
    if not part.disc.sides:
        return set()
    following = dict(zip(part.disc.outer, (*part.disc.outer[1:], part.disc.outer[0]), strict=True))
    found: set[Corner] = set()
    for f, tip in enumerate(part.tips):
        turns = (tip, next_corner(tip), previous_corner(tip))
        at = part.disc.point[3 * f : 3 * f + 3]
        for i, c in enumerate(turns):
            tail, head = at[(i + 1) % 3], at[(i + 2) % 3]
            if following.get(tail) == head and surface.opposite[c] != BORDER:
                found.add(c)
    return found
