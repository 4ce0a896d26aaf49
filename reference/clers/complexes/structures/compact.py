"""Compact half-edges: four levels, each with one array more and cheaper queries.

Half-edge 3t + i is side i of triangle t, from its i-th vertex to the next.
"""

from dataclasses import dataclass
from typing import Final

from clers.complexes.face_list import FaceList
from clers.complexes.surface import BORDER, Corner, Surface, Vertex, next_corner, previous_corner
from clers.complexes.topology import curves

NONE: Final = -1
"""What is opposite to a half-edge on the boundary. Clause: CPLX-COMPACT-1."""


@dataclass(frozen=True, slots=True)
class Level0:
    """A soup of triangles: three vertices each, and the number of vertices. CPLX-COMPACT-1."""

    vertex: tuple[int, ...]
    vertices: int


@dataclass(frozen=True, slots=True)
class Level1:
    """Adjacency: the half-edge that runs the other way, or NONE. Clause: CPLX-COMPACT-1."""

    soup: Level0
    opposite: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Level2:
    """One half-edge for each vertex, leaving it, and for each edge. Clause: CPLX-COMPACT-1."""

    table: Level1
    of_vertex: tuple[int, ...]
    edges: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Level3:
    """One half-edge for each boundary curve. Clause: CPLX-COMPACT-1."""

    cells: Level2
    curves: tuple[int, ...]


def after(h: int) -> int:
    """The next half-edge of the triangle. Clause: CPLX-COMPACT-1."""
    return next_corner(Corner(h))


def before(h: int) -> int:
    """The previous half-edge of the triangle. Clause: CPLX-COMPACT-1."""
    return previous_corner(Corner(h))


def face_list(of: Level0) -> FaceList:
    """The abstraction; vertices left over after the last triangle are no face: CPLX-COMPACT-2."""
    v = of.vertex
    return FaceList(tuple(zip(v[0::3], v[1::3], v[2::3], strict=False)), of.vertices)


def compact(of: Surface) -> Level3:
    """The construction, all four levels. Clauses: CPLX-COMPACT-2, CPLX-REFINE-1."""
    across = (of.opposite[before(h)] for h in range(len(of.vertex)))
    opposite = tuple(NONE if d == BORDER else after(d) for d in across)
    first = {v: h for h, v in reversed(tuple(enumerate(of.vertex)))}
    border = {of.vertex[h]: h for h, other in enumerate(opposite) if other == NONE}
    leaving = {**first, **border}
    loops = sorted(min(after(c) for c in curve.corners) for curve in curves(of))
    return Level3(
        Level2(
            Level1(Level0(tuple(of.vertex), of.vertices), opposite),
            tuple(leaving[Vertex(v)] for v in range(of.vertices)),
            tuple(h for h, other in enumerate(opposite) if other == NONE or h < other),
        ),
        tuple(loops),
    )


def integers(of: Level0 | Level1 | Level2 | Level3) -> int:
    """How many integers the arrays hold. Clause: CPLX-COMPACT-4."""
    match of:
        case Level0(vertex, _):
            return len(vertex)
        case Level1(soup, opposite):
            return integers(soup) + len(opposite)
        case Level2(table, of_vertex, edges):
            return integers(table) + len(of_vertex) + len(edges)
        case Level3(cells, loops):
            return integers(cells) + len(loops)
