"""Walking along boundary curves by swinging around their vertices."""

from collections.abc import Iterator, Sequence

from clers.complexes.surface import BORDER, Corner, Surface, Vertex, next_corner, previous_corner


def outgoing_border(opposite: Sequence[Corner], corner: Corner) -> Corner:
    """The corner c of the same vertex from which the border leaves along a face's edge.

    `corner` is any corner of a vertex on a boundary curve. The edge from c to next c lies on the
    curve: opposite[previous c] is BORDER. Found by swinging. Clauses: CPLX-CORNER-4, CPLX-CURVE-1.
    """
    c = corner
    while (d := opposite[previous_corner(c)]) != BORDER:
        c = previous_corner(d)
    return c


def border_from(opposite: Sequence[Corner], corner: Corner) -> Iterator[Corner]:
    """The corners from which the boundary curve through a corner's vertex leaves, in its order.

    The curve runs as the faces run its edges: the surface lies on its left. It starts at the vertex
    of `corner`. Linear in the faces at the curve. Clause: CPLX-CURVE-1.
    """
    start = c = outgoing_border(opposite, corner)
    while True:
        yield c
        c = outgoing_border(opposite, next_corner(c))
        if c == start:
            return


def curve_from(surface: Surface, corner: Corner) -> Iterator[Vertex]:
    """The vertices of the boundary curve through a corner's vertex, from it on: CPLX-CURVE-1."""
    return (surface.vertex[c] for c in border_from(surface.opposite, corner))
