"""Laws of the flat layout, decided by exact signs of the coordinates that are drawn."""

from collections import Counter
from itertools import combinations
from math import dist
from typing import Final

from clers.complexes.given import SMALL_SURFACES, SURFACES
from clers.complexes.surface import BORDER, Corner, Surface, next_corner, previous_corner
from clers.complexes.topology import components
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.verdict import Fails, Verdict
from clers.conventions.where import AtFace
from clers.edgebreaker.encode import encode
from clers.edgebreaker.given import outlined
from clers.pictures.cut import cut_edges, ends
from clers.pictures.disc import disc_of
from clers.pictures.drawing import Point
from clers.pictures.options import Options
from clers.pictures.orientation import orientation
from clers.pictures.picture import Role, Shape
from clers.pictures.room import Corners
from clers.pictures.shown import edges_of, flat_picture, shapes_of
from clers.pictures.table import curves_of, filled, genus_of, table_of


def nothing_overlaps(surface: Surface) -> Verdict:
    """All triangles counter-clockwise, no two with a point inside both.

    A ring's triangle runs clockwise, for the ring lies outside of it. The faces of its component
    lie in it, the others outside its circle.
    """
    picture = flat_picture(surface, Options(steps=(surface.faces,)))
    if isinstance(picture, Fails):
        return picture
    shapes = shapes_of(picture.panels[0])
    inner = [shape for shape in shapes if not shape.ring]
    rings = [shape for shape in shapes if shape.ring]
    ways = [same(1, orientation(*s.corners), AtFace(s.visit.face)) for s in inner]
    ways += [same(-1, orientation(*s.corners), AtFace(s.visit.face)) for s in rings]
    pairs = [
        same((), (a.visit.face, b.visit.face)[: 2 * overlap(a.corners, b.corners)])
        for a, b in combinations(inner, 2)
    ]
    beside = [_beside(ring, shape) for ring in rings for shape in shapes if shape is not ring]
    return every(*ways, *pairs, *beside, same(0, picture.turned))


def overlap(a: Corners, b: Corners) -> bool:
    """Have two counter-clockwise triangles an inner point in common? Exact.

    They have none exactly if a side of one of them has the other triangle on its right.
    """
    return not (_separates(a, b) or _separates(b, a))


def _separates(a: Corners, b: Corners) -> bool:
    sides = (a[0], a[1]), (a[1], a[2]), (a[2], a[0])
    return any(all(orientation(p, q, corner) <= 0 for corner in b) for p, q in sides)


def _beside(ring: Shape, shape: Shape) -> Verdict:
    """Inside the ring's triangle, or outside the ring's circle."""
    if shape.visit.entry.component == ring.visit.entry.component:
        a, b, c = ring.corners
        inside = [
            orientation(p, q, corner) <= 0
            for p, q in ((a, b), (b, c), (c, a))
            for corner in shape.corners
        ]
        return same(True, all(inside), AtFace(shape.visit.face))
    away = min(dist(ring.centre, corner) for corner in shape.corners)
    return same(True, away >= ring.ring * 0.999, AtFace(shape.visit.face))


def neighbours_meet(surface: Surface) -> Verdict:
    """Neighbours have a common edge in the drawing, or the edge is drawn as a cut on both sides.

    Only components with handles are cut, along 2g to 6g−3 paths, each two sides of the polygon.
    """
    picture = flat_picture(surface, Options(steps=(surface.faces,)))
    if isinstance(picture, Fails):
        return picture
    panel = picture.panels[0]
    at: dict[Corner, Point] = {}
    for shape in shapes_of(panel):
        tip = shape.visit.tip
        at |= dict(zip((tip, next_corner(tip), previous_corner(tip)), shape.corners, strict=True))
    cuts = Counter(edge.path for edge in edges_of(panel, Role.CUT))
    verdicts: list[Verdict] = []
    for c, d in enumerate(surface.opposite):
        tail, head = next_corner(Corner(c)), previous_corner(Corner(c))
        here = at[tail], at[head]
        met = d == BORDER or here == (at[previous_corner(d)], at[next_corner(d)])
        verdicts.append(same(0 if met else 1, cuts[here], AtFace(c // 3)))
    genera = [part.genus for part in components(surface) if part.genus]
    least, most = sum(2 * g for g in genera), sum(6 * g - 3 for g in genera)
    letters = Counter(note.text for note in panel.notes)
    verdicts.append(same(True, 2 * least <= len(panel.notes) <= 2 * most))
    verdicts.append(same(0, sum(count % 2 for count in letters.values())))
    return every(*verdicts)


def cuts_leave_discs(surface: Surface) -> Verdict:
    """A component with handles, its holes filled, is cut along edges of its own into a disc.

    No path of the cut has a loose end, and none goes through a hole's new vertex.
    """
    plan = outlined(encode(surface).stream)
    tips = encode(surface).tip_order
    verdicts: list[Verdict] = []
    for part in plan.parts:
        table = table_of(surface, tips[part.face : part.first + part.stop - part.start])
        holes = curves_of(table)
        if genus_of(table, len(holes)) == 0:
            continue
        closed = filled(table, holes)
        cut = cut_edges(closed)
        disc = disc_of(table)
        valence = Counter(ends(closed, c)[0] for c in cut)
        edges = (len(closed.opposite) + len(cut)) // 2
        verdicts += [
            same(1, disc.points - edges + closed.faces),
            same(len(cut), len(disc.outer)),
            same(len(cut), len(set(disc.outer))),
            same(True, min(valence.values()) >= 2),
            same(True, max(valence) < table.real_vertices),
        ]
    return every(*verdicts)


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "flat-picture-overlaps-nowhere",
        Clause.TOOL_PICTURE_7,
        "in the flat layout triangles run counter-clockwise and none overlaps another",
        SMALL_SURFACES,
        nothing_overlaps,
    ),
    Law(
        "flat-picture-is-cut-along-paths",
        Clause.TOOL_PICTURE_6,
        "neighbours meet in the flat layout, but for cuts of components with handles",
        SURFACES,
        neighbours_meet,
    ),
    Law(
        "cuts-leave-discs",
        Clause.TOOL_PICTURE_6,
        "cutting a component with handles along its own edges leaves a disc",
        SURFACES,
        cuts_leave_discs,
    ),
)
