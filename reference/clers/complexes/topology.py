"""Components, boundary curves, Euler characteristic and genus of a surface, in linear time."""

from dataclasses import dataclass

from clers.complexes.border import border_from
from clers.complexes.surface import (
    BORDER,
    Corner,
    Face,
    Surface,
    Vertex,
    next_corner,
    previous_corner,
)


@dataclass(frozen=True, slots=True)
class Curve:
    """A boundary curve, run as the faces run its edges: the surface lies on its left.

    `vertices[i]` → `vertices[i+1]` (cyclically) is the edge opposite to `corners[i]`, and
    opposite[corners[i]] is BORDER. Clauses: CPLX-CURVE-1, CPLX-CURVE-2.
    """

    vertices: tuple[Vertex, ...]
    corners: tuple[Corner, ...]


@dataclass(frozen=True, slots=True)
class Component:
    """The counts of one connected component. Clauses: CPLX-COMPONENT-1 … CPLX-COMPONENT-3.

    All are numbers: of faces, vertices, edges, edges that lie in one face only, boundary curves;
    the genus g; and euler = χ = vertices − edges + faces = 2 − 2·genus − curves.
    `lowest` is the lowest face of the component.
    """

    lowest: Face
    faces: int
    vertices: int
    edges: int
    boundary_edges: int
    curves: int
    genus: int
    euler: int


def curves(surface: Surface) -> tuple[Curve, ...]:
    """All boundary curves, by their lowest corner opposite to BORDER, each started at that corner.

    Linear in the number of faces. Clauses: CPLX-CURVE-1, CPLX-CURVE-2, CPLX-CURVE-3.
    """
    done = bytearray(len(surface.vertex))
    found: list[Curve] = []
    for c, d in enumerate(surface.opposite):
        if d == BORDER and not done[c]:
            curve = curve_at(surface, Corner(c))
            for e in curve.corners:
                done[e] = 1
            found.append(curve)
    return tuple(found)


def curve_at(surface: Surface, corner: Corner) -> Curve:
    """The boundary curve through the edge opposite to a corner, begun with that edge.

    `opposite[corner]` is BORDER. Linear in the faces at the curve. Clause: CPLX-CURVE-2.
    """
    leaving = tuple(border_from(surface.opposite, next_corner(corner)))
    return Curve(
        tuple(surface.vertex[c] for c in leaving), tuple(previous_corner(c) for c in leaving)
    )


def component_of_faces(surface: Surface) -> tuple[int, ...]:
    """For each face the number of its component, counted by lowest faces.

    Linear in the number of faces. Clause: CPLX-COMPONENT-1.
    """
    opposite = surface.opposite
    number = [-1] * surface.faces
    count = 0
    for first in range(surface.faces):
        if number[first] >= 0:
            continue
        number[first] = count
        stack = [first]
        while stack:
            t = stack.pop()
            for d in opposite[3 * t : 3 * t + 3]:
                if d != BORDER and number[d // 3] < 0:
                    number[d // 3] = count
                    stack.append(d // 3)
        count += 1
    return tuple(number)


def components(surface: Surface) -> tuple[Component, ...]:
    """The components of a surface, by their lowest faces, each with its counts.

    Linear in the number of faces. Clauses: CPLX-COMPONENT-1 … CPLX-COMPONENT-3.
    """
    number = component_of_faces(surface)
    count = max(number) + 1
    lowest = [Face(-1)] * count
    faces, vertices, border, loops = [0] * count, [0] * count, [0] * count, [0] * count
    for t in range(len(number) - 1, -1, -1):
        faces[number[t]] += 1
        lowest[number[t]] = Face(t)
    home = [0] * surface.vertices
    for c, v in enumerate(surface.vertex):
        home[v] = number[c // 3]
        border[number[c // 3]] += surface.opposite[c] == BORDER
    for k in home:
        vertices[k] += 1
    for curve in curves(surface):
        loops[number[curve.corners[0] // 3]] += 1
    return tuple(
        _component(lowest[k], faces[k], vertices[k], border[k], loops[k]) for k in range(count)
    )


def _component(lowest: Face, faces: int, vertices: int, border: int, loops: int) -> Component:
    """Each edge has two corners opposite to it, or one. Clauses: CPLX-COMPONENT-2, -3."""
    edges = (3 * faces + border) // 2
    euler = vertices - edges + faces
    genus = (2 - loops - euler) // 2
    return Component(lowest, faces, vertices, edges, border, loops, genus, euler)
