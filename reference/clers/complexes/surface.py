"""Oriented surfaces as corner tables: flat, frozen, and true to CPLX-SURFACE by construction.

Corner 3t+i is the i-th corner of triangle t; `next` and `previous` turn inside the triangle.
A corner stands for its vertex, for the edge opposite to it, and for the gate into its triangle
across that edge: one integer for three ideas, as in Rossignac's corner table (the tutorial's [59]).
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final, NewType

from librt.vecs import vec
from mypy_extensions import i64

from clers.complexes.row import Row, flat_row, listed

Vertex = NewType("Vertex", int)
Face = NewType("Face", int)
Corner = NewType("Corner", int)

Triangle = tuple[Vertex, Vertex, Vertex]

BORDER: Final = Corner(-1)
"""What is opposite to a corner whose edge lies on a boundary curve. Clause: CPLX-CORNER-2."""


@dataclass(frozen=True, slots=True)
class Surface:
    """An oriented simplicial surface, with or without boundary, of any number of components.

    Clauses: CPLX-CORNER-1, CPLX-CORNER-2. Built by `corner_table.surface`, never by hand.

    `vertex[c]` is the vertex at corner c; `opposite[c]` the corner across the edge opposite to c,
    or BORDER. Both have 3T entries. `vertices` counts the vertices, all of them used. Kernels take
    the same two rows flat.
    """

    vertex_row: Row[Vertex]
    opposite_row: Row[Corner]
    vertices: int

    @property
    def vertex(self) -> tuple[Vertex, ...]:
        """The vertex at each corner."""
        return self.vertex_row.numbers

    @property
    def opposite(self) -> tuple[Corner, ...]:
        """The corner across from each corner, or BORDER."""
        return self.opposite_row.numbers

    @property
    def faces(self) -> int:
        """T, the number of triangles."""
        return len(self.vertex_row) // 3

    def triangle(self, face: Face) -> Triangle:
        """The vertices of a face, in the order it was given in."""
        v = self.vertex
        return v[3 * face], v[3 * face + 1], v[3 * face + 2]

    def triangles(self) -> Iterator[Triangle]:
        """All faces, in order."""
        v = self.vertex
        return zip(v[0::3], v[1::3], v[2::3], strict=True)


def corners_listed(
    vertex: tuple[Vertex, ...], opposite: tuple[Corner, ...], vertices: int
) -> Surface:
    """The surface of these two tuples; nothing is checked."""
    return Surface(listed(vertex), listed(opposite), vertices)


def corners_flat(vertex: vec[i64], opposite: vec[i64], vertices: int) -> Surface:
    """The surface that a kernel has found. Clause: CPLX-CORNER-2."""
    return Surface(flat_row(vertex), flat_row(opposite), vertices)


def face_of(corner: Corner) -> Face:
    """The triangle a corner is in. Clause: CPLX-CORNER-1."""
    return Face(corner // 3)


def next_corner(corner: Corner) -> Corner:
    """The next corner of the same triangle, in its orientation. Clause: CPLX-CORNER-1."""
    return Corner(corner - 2 if corner % 3 == 2 else corner + 1)


def previous_corner(corner: Corner) -> Corner:
    """The previous corner of the same triangle. Clause: CPLX-CORNER-1."""
    return Corner(corner + 2 if corner % 3 == 0 else corner - 1)
