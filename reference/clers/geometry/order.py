"""Positions follow their vertices into the order of creation, and back."""

from collections.abc import Sequence

from clers.geometry.positions import Positions


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
