"""Into the order of creation and back: surfaces and the positions that follow their vertices."""

from collections.abc import Sequence
from typing import TypeVar

from clers.complexes.surface import Surface, corners_flat
from clers.edgebreaker.stream import Encoding
from clers.geometry.positions import Positions
from clers.kernels.order import Renumbered

N = TypeVar("N", int, float)


def in_creation_order(surface: Surface, encoding: Encoding) -> Surface:
    """The surface that a decoder will make: the same, with its faces and vertices renumbered.

    Linear. Clause: GEOM-ORDER-3.
    """
    found = Renumbered(
        surface.vertex_row.flat,
        surface.opposite_row.flat,
        encoding.tip_row.flat,
        encoding.vertex_row.flat,
    )
    return corners_flat(found.vertex, found.opposite, surface.vertices)


def into_order(given: Positions, order: Sequence[int]) -> Positions:
    """Position k of the result is position order[k] of what is given. Clause: GEOM-ORDER-1."""
    return Positions(given.precision, in_order(given.coordinates, order))


def in_order(flat: Sequence[N], order: Sequence[int]) -> tuple[N, ...]:
    """The same of any three numbers for each vertex, flat. Clause: GEOM-ORDER-1."""
    return tuple(x for v in order for x in flat[3 * v : 3 * v + 3])


def out_of_order(given: Positions, order: Sequence[int]) -> Positions:
    """Position order[k] of the result is position k of what is given. Clause: GEOM-ORDER-2."""
    inverse = [0] * len(order)
    for k, v in enumerate(order):
        inverse[v] = k
    return into_order(given, inverse)
