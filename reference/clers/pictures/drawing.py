"""A drawing: where the faces of a surface are in the plane, and in which order they are painted."""

from dataclasses import dataclass, replace

from clers.complexes.surface import Corner, Face

Point = tuple[float, float]
"""Right and up."""


@dataclass(frozen=True, slots=True)
class Ring:
    """A face drawn as all that lies between its triangle and a circle around it."""

    face: Face
    centre: Point
    radius: float


@dataclass(frozen=True, slots=True)
class Drawing:
    """A surface in the plane. Clauses: TOOL-PICTURE-5 to TOOL-PICTURE-9.

    `corners[c]` is the place of corner c. `order` has each face once, the first painted first; a
    ring is painted before the faces inside it. `far` (seen from behind) and `light` (from 0 to 1)
    are by face. `cuts` are the corners opposite to edges where the surface is cut open, `notes` the
    letters of the sides. `turned` counts the triangles that rounding turned over where none should
    be. In a `deep` drawing a face can hide what was painted before it. In a `ribbon` neighbours do
    not lie side by side, so that edges and vertices mean nothing.
    """

    corners: tuple[Point, ...]
    order: tuple[Face, ...]
    far: tuple[bool, ...]
    light: tuple[float, ...]
    rings: tuple[Ring, ...] = ()
    cuts: frozenset[Corner] = frozenset()
    notes: tuple[tuple[Point, str], ...] = ()
    turned: int = 0
    deep: bool = False
    ribbon: bool = False


def box_of(drawing: Drawing) -> tuple[float, float, float, float]:
    """The least x and y, then the greatest, of all that is drawn."""
    points = [
        *drawing.corners,
        *(
            (ring.centre[0] + dx * ring.radius, ring.centre[1] + dy * ring.radius)
            for ring in drawing.rings
            for dx, dy in ((-1, -1), (1, 1))
        ),
        *(at for at, _ in drawing.notes),
    ]
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return min(xs), min(ys), max(xs), max(ys)


def fitted(drawing: Drawing) -> tuple[Drawing, float, float]:
    """The same, moved and scaled so that it begins at 0 and the longer side is 1; both sides."""
    x0, y0, x1, y1 = box_of(drawing)
    side = max(x1 - x0, y1 - y0) or 1.0

    def place(at: Point) -> Point:
        return (at[0] - x0) / side, (at[1] - y0) / side

    moved = replace(
        drawing,
        corners=tuple(map(place, drawing.corners)),
        rings=tuple(
            Ring(ring.face, place(ring.centre), ring.radius / side) for ring in drawing.rings
        ),
        notes=tuple((place(at), text) for at, text in drawing.notes),
    )
    return moved, (x1 - x0) / side, (y1 - y0) / side
