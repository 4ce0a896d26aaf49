"""Tutte's drawing: border points are given, every other point is a mean of its neighbours.

With positive weights and a convex border no triangle of a disc is turned over (Tutte 1963, Floater
2003). So the weights may be chosen for the eye: an edge beside large triangles pulls harder.
"""

from typing import Final

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]
Flags = npt.NDArray[np.bool_]

ROUNDS: Final = 3
"""How often weights are chosen anew."""

STILL: Final = 1e-14
"""The largest force, relative to the weights at a point, that leaves the point where it is."""


def tutte(triangles: Ints, places: Floats, free: Flags) -> Floats:
    """The places of all points of a disc, given those that are not free.

    `triangles` has a row of three points for each triangle, `places` a row (x, y) for each point.
    Where rounding turned triangles over in a later round, an earlier round's drawing is the answer.
    """
    sides = np.sort(np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)]), axis=1)
    edges, edge, count = np.unique(sides, axis=0, return_inverse=True, return_counts=True)
    edge = edge.reshape(-1)
    weights = np.ones(len(edges))
    best = _balanced(edges, weights, places, free)
    for _ in range(ROUNDS):
        areas = np.maximum(areas_of(triangles, best), 0.0)
        beside = np.bincount(edge, np.tile(areas, 3), len(edges)) / count
        weights = weights * np.sqrt(np.maximum(beside / beside.mean(), 1e-6))
        places = _balanced(edges, weights, best, free)
        if (areas_of(triangles, places) <= 0).any():
            break
        best = places
    return best


def areas_of(triangles: Ints, places: Floats) -> Floats:
    """The signed areas, positive where the points run counter-clockwise."""
    a, b, c = places[triangles[:, 0]], places[triangles[:, 1]], places[triangles[:, 2]]
    u, v = b - a, c - a
    return (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2


def _balanced(edges: Ints, weights: Floats, places: Floats, free: Flags) -> Floats:
    """Solve Σ w (neighbour − point) = 0 at the free points by conjugate gradients.

    The matrix is a weighted Laplacian with rows left out: symmetric and positive definite. Divided
    by its diagonal it needs about as many rounds as the drawing is points wide.
    """
    a, b = edges[:, 0], edges[:, 1]
    points = len(places)
    pull = _sums(a, weights, points) + _sums(b, weights, points)
    solved = places.copy()
    for axis in range(2):
        x = places[:, axis].copy()
        force = _forces(a, b, weights, pull, free, x)
        step = force / pull
        power = float(force @ step)
        direction = step
        for _ in range(points + 100):
            if float(np.max(np.abs(force) / pull)) <= STILL:
                break
            answer = -_forces(a, b, weights, pull, free, direction)
            length = power / float(direction @ answer)
            x = x + length * direction
            force = force - length * answer
            step = force / pull
            before, power = power, float(force @ step)
            direction = step + (power / before) * direction
        solved[:, axis] = x
    return solved


def _forces(a: Ints, b: Ints, weights: Floats, pull: Floats, free: Flags, x: Floats) -> Floats:
    """For each free point the weighted sum of the ways to its neighbours; 0 for the others."""
    towards = _sums(a, weights * x[b], len(x)) + _sums(b, weights * x[a], len(x))
    return np.where(free, towards - pull * x, 0.0)


def _sums(of: Ints, values: Floats, points: int) -> Floats:
    """For each point the sum of its values."""
    return np.bincount(of, values, points).astype(np.float64)
