"""Into the order of creation and back: surfaces and the positions that follow their vertices."""

from collections.abc import Sequence

from clers.complexes.surface import BORDER, Corner, Surface, Vertex, next_corner, previous_corner
from clers.edgebreaker.stream import Encoding
from clers.geometry.positions import Positions


def in_creation_order(surface: Surface, encoding: Encoding) -> Surface:
    """The surface that a decoder will make: the same, with its faces and vertices renumbered.

    Linear. Clause: GEOM-ORDER-3.
    """
    old = [c for tip in encoding.tip_order for c in (tip, next_corner(tip), previous_corner(tip))]
    corner = [BORDER] * len(old)
    for c, was in enumerate(old):
        corner[was] = Corner(c)
    vertex = [Vertex(0)] * surface.vertices
    for k, v in enumerate(encoding.vertex_order):
        vertex[v] = Vertex(k)
    across = (surface.opposite[was] for was in old)
    return Surface(
        tuple(vertex[surface.vertex[was]] for was in old),
        tuple(BORDER if d == BORDER else corner[d] for d in across),
        surface.vertices,
    )


def into_order(given: Positions, order: Sequence[int]) -> Positions:
    """Position k of the result is position order[k] of what is given. Clause: GEOM-ORDER-1."""
    flat = given.coordinates
    moved = tuple(x for v in order for x in flat[3 * v : 3 * v + 3])
    return Positions(given.precision, moved)


def out_of_order(given: Positions, order: Sequence[int]) -> Positions:
    """Position order[k] of the result is position k of what is given. Clause: GEOM-ORDER-2."""
    inverse = [0] * len(order)
    for k, v in enumerate(order):
        inverse[v] = k
    return into_order(given, inverse)
