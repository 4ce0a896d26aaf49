"""Where a vertex is expected, from the vertices before it: the parallelogram rule."""

from collections.abc import Sequence
from typing import Final

from clers.complexes.surface import Corner, Surface, next_corner, previous_corner
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtVertex
from clers.geometry.box import Box

NONE: Final = Corner(-1)
"""In the place of a parallelogram corner: the vertex has none. Clause: GEOM-PREDICT-1."""


def parallelogram_corners(surface: Surface) -> tuple[Corner, ...]:
    """For each vertex the corner whose parallelogram predicts it, or NONE. Linear.

    Clauses: GEOM-PREDICT-1, GEOM-PREDICT-4.
    """
    vertex, opposite = surface.vertex, surface.opposite
    found = [NONE] * surface.vertices
    for c, v in enumerate(vertex):
        if found[v] != NONE:
            continue
        a, b, d = (
            vertex[c - 2 if c % 3 == 2 else c + 1],
            vertex[c - 1 if c % 3 else c + 2],
            opposite[c],
        )
        if a < v and b < v and d >= 0 and vertex[d] < v:
            found[v] = Corner(c)
    return tuple(found)


def parallelogram_corner_by_definition(surface: Surface, v: int) -> Corner:
    """GEOM-PREDICT-1 word for word; quadratic over a whole surface."""

    def predicts(c: Corner) -> bool:
        if surface.vertex[c] != v:
            return False
        sides = (surface.vertex[next_corner(c)], surface.vertex[previous_corner(c)])
        across = surface.opposite[c]
        return max(sides) < v and across >= 0 and surface.vertex[across] < v

    return next(filter(predicts, map(Corner, range(len(surface.vertex)))), NONE)


def prediction(
    surface: Surface, corner: Corner, v: int, axis: int, indices: Sequence[int], extent: int
) -> int:
    """The index expected for one coordinate of vertex v, from `indices` of vertices before it.

    Clauses: GEOM-PREDICT-2, GEOM-PREDICT-3.
    """
    if corner == NONE:
        return indices[3 * (v - 1) + axis] if v else 0
    a = surface.vertex[next_corner(corner)]
    b = surface.vertex[previous_corner(corner)]
    o = surface.vertex[surface.opposite[corner]]
    sum_of_three = indices[3 * a + axis] + indices[3 * b + axis] - indices[3 * o + axis]
    return min(max(sum_of_three, 0), extent)


def residuals(surface: Surface, box: Box, indices: Sequence[int]) -> tuple[int, ...]:
    """Index minus prediction, for each coordinate. Clause: GEOM-RESIDUAL-1."""
    corners = parallelogram_corners(surface)
    return tuple(
        q - prediction(surface, corners[i // 3], i // 3, i % 3, indices, box.extent[i % 3])
        for i, q in enumerate(indices)
    )


def indices_from(
    surface: Surface, box: Box, given: Sequence[int]
) -> Accepted[tuple[int, ...]] | Rejected:
    """The indices that have these residuals. Clauses: GEOM-RESIDUAL-1, GEOM-RESIDUAL-2."""
    corners = parallelogram_corners(surface)
    indices: list[int] = []
    for i, r in enumerate(given):
        v, axis = divmod(i, 3)
        extent = box.extent[axis]
        q = prediction(surface, corners[v], v, axis, indices, extent) + r
        if not 0 <= q <= extent:
            detail = f"{'xyz'[axis]} has index {q}, the box ends at {extent}"
            return Rejected(Reason.BAD_RESIDUAL, Clause.GEOM_RESIDUAL_2, AtVertex(v), detail)
        indices.append(q)
    for axis in range(3):
        column = indices[axis::3]
        if min(column, default=0) != 0 or max(column, default=0) != box.extent[axis]:
            detail = f"the box is not tight on {'xyz'[axis]}"
            return Rejected(Reason.BAD_RESIDUAL, Clause.GEOM_RESIDUAL_2, detail=detail)
    return Accepted(tuple(indices))
