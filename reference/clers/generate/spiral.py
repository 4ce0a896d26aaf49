"""Points for a surface that has none: its vertices breadth first, along a spiral on the sphere."""

from math import cos, pi, sin, sqrt
from typing import Final

from clers.codes.half_edges import half_edges
from clers.complexes.surface import Surface
from clers.geometry.positions import Positions, Precision

GOLDEN_ANGLE: Final = pi * (3 - sqrt(5))


def breadth_first(sphere: Surface) -> list[int]:
    """The vertices of a connected closed surface, from corner 0 on. Clause: TOOL-GENERATE-1."""
    edges = half_edges(sphere)
    seen = {edges.source[0]}
    order, leading = [edges.source[0]], [0]  # of each vertex the half-edge to begin with
    for begin in leading:
        for h in edges.around(begin):
            beyond = edges.twin[h]
            if (y := edges.source[beyond]) not in seen:
                seen.add(y)
                order.append(y)
                leading.append(beyond)
    return order


def spiral(sphere: Surface) -> Positions:
    """A place for each vertex. The faces may cross: these are no shape. TOOL-GENERATE-1."""
    places: dict[int, tuple[float, float, float]] = {}
    for k, v in enumerate(breadth_first(sphere)):
        z = 1 - (2 * k + 1) / sphere.vertices
        radius = sqrt(1 - z * z)
        places[v] = (radius * cos(k * GOLDEN_ANGLE), radius * sin(k * GOLDEN_ANGLE), z)
    return Positions(Precision.F64, tuple(x for v in range(sphere.vertices) for x in places[v]))
