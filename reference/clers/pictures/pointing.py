"""Where in a drawing the things are that it is to point at. Clause: TOOL-PICTURE-14."""

from collections.abc import Iterator
from math import dist

from clers.complexes.surface import Corner, Surface, next_corner, previous_corner
from clers.pictures.compose import middle
from clers.pictures.drawing import Drawing, Point
from clers.pictures.options import Pointer
from clers.pictures.picture import Pointed, Target


def pointed(surface: Surface, drawing: Drawing, at: Pointer) -> tuple[Pointed, ...]:
    """The faces, then the triangle, then each place of the vertices, as far as they are there.

    A ribbon has no vertices, and no triangles but its faces. Clause: TOOL-PICTURE-14.
    """
    return tuple(_pointed(surface, drawing, at))


def _pointed(surface: Surface, drawing: Drawing, at: Pointer) -> Iterator[Pointed]:
    ring_of = {int(ring.face): ring for ring in drawing.rings}
    faces = [f for f in dict.fromkeys(at.faces) if 0 <= f < surface.faces]
    for f in faces:
        corners, ring = _face(drawing, f), ring_of.get(f)
        if ring is None:
            yield Pointed(Target.FACE, corners)
        else:
            yield Pointed(Target.FACE, corners, ring.radius, ring.centre)
    if drawing.ribbon:
        return
    places = _places(surface, drawing)
    if at.triangle is not None and all(0 <= v < surface.vertices for v in at.triangle):
        near = middle(*_face(drawing, faces[0])) if faces else places[at.triangle[0]][0]
        path = tuple(min(places[v], key=lambda place: dist(place, near)) for v in at.triangle)
        yield Pointed(Target.TRIANGLE, path)
    for v in dict.fromkeys(at.vertices):
        if 0 <= v < surface.vertices:
            for place in places[v]:
                yield Pointed(Target.VERTEX, (place,))


def _face(drawing: Drawing, face: int) -> tuple[Point, ...]:
    first = Corner(3 * face)
    return tuple(drawing.corners[c] for c in (first, next_corner(first), previous_corner(first)))


def _places(surface: Surface, drawing: Drawing) -> dict[int, tuple[Point, ...]]:
    """The places of each vertex, each once, by its first corner there."""
    found: dict[int, dict[Point, None]] = {}
    for c, v in enumerate(surface.vertex):
        found.setdefault(v, {})[drawing.corners[c]] = None
    return {v: tuple(at) for v, at in found.items()}
