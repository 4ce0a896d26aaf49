"""Making a plane drawing easier to read: every triangle wants room for a circle inside it.

Descent on the sum of 1/r² over the triangles, r the radius of the inscribed circle. A triangle that
shrinks costs without bound, and no step is taken that turns one over, so that a plane drawing stays
one.
"""

from typing import Final

import numpy as np

from clers.pictures.tutte import Flags, Floats, Ints, areas_of

TRIES: Final = 600
"""How many steps are tried at most."""

WORK: Final = 1_500_000
"""How many triangles are looked at in all tries together, about."""

ENOUGH: Final = 2e-5
"""A step that makes things better by less than this fraction is the last."""

SHORTEST: Final = 1e-9
"""A step shorter than this fraction of what the slope suggests is no progress."""


def relaxed(triangles: Ints, places: Floats, free: Flags) -> Floats:
    """Better places for the free points; the same ones if a triangle is turned over already."""
    cost, slope = _cost(triangles, places)
    length = 0.01
    for _ in range(min(TRIES, WORK // len(triangles))):
        if not np.isfinite(cost) or length < SHORTEST:
            break
        direction = np.where(free[:, None], -slope / _stiffness(triangles, places), 0.0)
        tried = places + length * direction
        new_cost, new_slope = _cost(triangles, tried)
        if cost - ENOUGH * cost <= new_cost < cost:
            return tried
        if new_cost < cost:
            places, cost, slope, length = tried, new_cost, new_slope, 2 * length
        else:
            length /= 4
    return places


def _cost(triangles: Ints, places: Floats) -> tuple[float, Floats]:
    """The sum of (perimeter / area)² = 4/r², and its derivative by each point's place."""
    area = areas_of(triangles, places)
    if not (area > 0).all():
        return np.inf, places
    at = places[triangles]
    following, before = np.roll(at, -1, axis=1), np.roll(at, -2, axis=1)
    way = following - at
    length = np.sqrt((way**2).sum(axis=2))
    unit = way / length[:, :, None]
    perimeter = length.sum(axis=1)
    ratio = perimeter / area
    by_perimeter = np.roll(unit, 1, axis=1) - unit
    across = before - following
    by_area = np.stack([-across[:, :, 1], across[:, :, 0]], axis=2) / 2
    share = (2 * ratio / area)[:, None, None]
    slopes = share * (by_perimeter - ratio[:, None, None] * by_area)
    return float((ratio**2).sum()), _summed(triangles, slopes, len(places))


def _stiffness(triangles: Ints, places: Floats) -> Floats:
    """How quickly the slope changes at each point, about: the sum of 1/r⁴ over its triangles."""
    at = places[triangles]
    perimeter = np.sqrt(((np.roll(at, -1, axis=1) - at) ** 2).sum(axis=2)).sum(axis=1)
    radius = 2 * areas_of(triangles, places) / perimeter
    each = np.broadcast_to(radius[:, None, None] ** -4, (*triangles.shape, 2))
    return np.maximum(_summed(triangles, each, len(places)), 1e-300)


def _summed(triangles: Ints, values: Floats, points: int) -> Floats:
    """For each point the sum of what its corners have."""
    at = triangles.reshape(-1)
    return np.stack(
        [np.bincount(at, values[:, :, axis].reshape(-1), points) for axis in range(2)], axis=1
    )
