"""Walking along boundary curves by swinging around their vertices."""

from collections.abc import Iterator

from clers.complexes.surface import BORDER, Corner, Surface, Vertex, next_corner, previous_corner


def outgoing_border(surface: Surface, corner: Corner) -> Corner:
    """The corner, at the same vertex, after whose vertex the border leaves along a face's edge.

    `corner` is any corner of a vertex on a boundary curve. In the face of the answer c the edge
    vertex[c] → vertex[next c] lies on the curve: opposite[previous c] is BORDER.
    """
    opposite = surface.opposite
    c = corner
    while (d := opposite[previous_corner(c)]) != BORDER:
        c = previous_corner(d)
    return c


def curve_from(surface: Surface, corner: Corner) -> Iterator[Vertex]:
    """The vertices of the boundary curve through a corner's vertex, from that vertex on.

    The curve runs as the faces run its edges: the surface lies on its left. Linear in the faces at
    the curve. Clause: CPLX-CURVE-1.
    """
    start = c = outgoing_border(surface, corner)
    while True:
        yield surface.vertex[c]
        c = outgoing_border(surface, next_corner(c))
        if c == start:
            return
