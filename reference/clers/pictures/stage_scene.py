"""The stages of a script of operators as an image: a panel for each. Clause: TOOL-OPERATORS-4."""

from collections.abc import Iterator, Sequence
from math import ceil, hypot, sqrt
from textwrap import wrap
from typing import Final

from clers.operators.families import Stage
from clers.pictures.drawing import Point
from clers.pictures.lettering import letters
from clers.pictures.palette import COLOURS, FAINT, INK, MORSE, PAPER, Letter, mixed
from clers.pictures.scene import Disc, Group, Item, Line, Polygon, Scene, Style, Words
from clers.pictures.stages import Edge, Layout, Seen, Triangle, layout

PANEL: Final = 250.0
ALONE: Final = 700.0
FONT: Final = 12.0
GAP: Final = 30.0
COLUMNS: Final = 5

LABEL: Final = 13.0
"""How far from a vertex its label is."""

LABELLED: Final = 60
"""Up to so many vertices have labels."""

LOOPS: Final = tuple(
    COLOURS[letter] for letter in (Letter.SB, Letter.SH, Letter.L, Letter.E, Letter.S)
)
"""The colours of loops, in turn."""

_OLD: Final = Style("old", mixed(COLOURS[Letter.C], PAPER, 0.55), INK, 0.8)
_NEW: Final = Style("new", COLOURS[Letter.S], INK, 1.6)
_LATER: Final = Style("later", "", FAINT, 0.6)
_EDGE: Final = Style("edge", "", INK, 1.4)
_NEW_EDGE: Final = Style("new-edge", "", MORSE, 2.6)
_POINT: Final = Style("point", INK)
_NEW_POINT: Final = Style("new-point", MORSE)


def stage_scene(stages: Sequence[Stage], of: Sequence[Seen]) -> Scene:
    """The image of some stages, and of what is seen of each. Clause: TOOL-OPERATORS-4."""
    places = layout(of)
    columns = min(COLUMNS, ceil(sqrt(len(of))))
    size = ALONE if len(of) == 1 else PANEL
    fit = int(size / (0.58 * FONT))
    captions = [
        [line for text in _caption(k, stages) for line in wrap(text, fit)]
        for k in range(len(stages))
    ]
    high = size * places.height
    row = high + 2 * GAP + max(map(len, captions)) * FONT * 1.3
    cell = size + 1.6 * GAP
    groups: list[Group] = []
    for k, now in enumerate(of):
        down, right = divmod(k, columns)
        left, top = GAP + right * cell, GAP + down * row
        panel = _Panel(places, size, left + size * (1 - places.width) / 2, top + high)
        before = of[k - 1] if k else None
        words = [
            Words((left + size / 2, top + high + GAP + FONT * 1.3 * i), text, FONT, INK)
            for i, text in enumerate(captions[k])
        ]
        groups.append(Group(f"stage-{k}", (*panel.items(now, before), *words)))
    height = GAP + ceil(len(of) / columns) * row
    return Scene(GAP + columns * cell, height, f"{len(of)} stages", tuple(groups))


def _caption(k: int, stages: Sequence[Stage]) -> Iterator[str]:
    """The operator; why it did nothing; and the numbers, those that changed with what they were."""
    stage = stages[k]
    name = stage.operator or "to begin with"
    yield f"({letters(k)}) {name}" if len(stages) > 1 else name
    if stage.idle:
        yield f"nothing: {stage.idle}"
    was = dict(stages[k - 1].numbers) if k else {}
    shown = [
        f"{what} {was[what]}→{value}" if was.get(what, value) != value else f"{what} {value}"
        for what, value in stage.numbers
        if not what.startswith(("vertices", "edges", "faces", "#"))
    ]
    yield ", ".join(shown)


class _Panel:
    """Where one panel lies, and how things are painted there; private, and of one call."""

    __slots__ = ("bottom", "left", "places", "size")

    def __init__(self, places: Layout, size: float, left: float, bottom: float) -> None:
        self.places, self.size, self.left, self.bottom = places, size, left, bottom

    def at(self, point: Point) -> Point:
        """A point of the layout in the image."""
        return self.left + point[0] * self.size, self.bottom - point[1] * self.size

    def items(self, now: Seen, before: Seen | None) -> Iterator[Item]:
        """Outlines of what is not there, triangles, bare edges, loops, vertices, letters."""
        old = before or Seen(frozenset(), (), frozenset())
        here, there = set(now.triangles), set(old.triangles)
        yield from (self.triangle(t, _LATER, "later") for t in self.ringed() if t not in here)
        for t in self.ringed(now.triangles):
            yield self.triangle(t, _OLD if t in there else _NEW, "old" if t in there else "new")
        carried = {e for t in now.triangles for e in _edges_of(t)}
        for edge in sorted(now.edges - carried):
            fresh = edge not in old.edges
            yield Line(self.nearest(edge), _NEW_EDGE if fresh else _EDGE, "edge")
        for i, loop in enumerate(now.loops):
            style = Style(f"loop-{i % len(LOOPS)}", "", LOOPS[i % len(LOOPS)], 3.0)
            yield from (Line(self.beside(side, now), style, f"loop-{i}") for side in loop)
        yield from self.points(now, old)
        yield from (
            Words(self.at(place), text, FONT * 1.2, INK, bold=True)
            for place, text in self.places.notes
        )

    def ringed(self, some: Sequence[Triangle] | None = None) -> list[Triangle]:
        """Triangles (of the whole surface, if none are given), those drawn around others first."""
        rings = self.places.rings
        return sorted(self.places.whole if some is None else some, key=lambda t: t not in rings)

    def triangle(self, t: Triangle, style: Style, kind: str) -> Item:
        ring = self.places.rings.get(t)
        title = " ".join(map(str, t))
        if ring is not None:
            return Disc(self.at(ring.centre), ring.radius * self.size, style, kind, title)
        return Polygon(tuple(map(self.at, self.places.corners[t])), style, kind, title)

    def nearest(self, edge: Edge) -> tuple[Point, Point]:
        """An edge between those places of its ends that are nearest."""
        a, b = edge
        return min(
            ((self.at(p), self.at(q)) for p in self.places.at[a] for q in self.places.at[b]),
            key=lambda ends: hypot(ends[0][0] - ends[1][0], ends[0][1] - ends[1][1]),
        )

    def beside(self, side: Edge, now: Seen) -> tuple[Point, Point]:
        """A side of a loop, moved a little to its left, where the surface is missing."""
        path = self.nearest(side)
        for t in now.triangles:
            points = dict(zip(t, map(self.at, self.places.corners[t]), strict=True))
            if side in ((t[1], t[0]), (t[2], t[1]), (t[0], t[2])):
                path = points[side[0]], points[side[1]]
        (x, y), (u, v) = path
        length = hypot(u - x, v - y) or 1.0
        outward = (
            -3.0
            if any(set(side) <= set(t) for t in self.places.rings if t in now.triangles)
            else 3.0
        )
        right, down = outward * (v - y) / length, -outward * (u - x) / length
        return (x + right, y + down), (u + right, v + down)

    def points(self, now: Seen, old: Seen) -> Iterator[Item]:
        few = len(self.places.at) <= LABELLED
        for v in sorted(now.vertices):
            style = _POINT if v in old.vertices else _NEW_POINT
            for place in self.places.at[v]:
                x, y = self.at(place)
                yield Disc((x, y), 3.0, style, "vertex", str(v))
                if few:
                    yield Words(self.outward(x, y), str(v), FONT, INK, bold=True)

    def outward(self, x: float, y: float) -> Point:
        """Where a vertex's label is: on the side away from the middle of the panel."""
        dx = x - self.left - self.size * self.places.width / 2
        dy = y - self.bottom + self.size * self.places.height / 2
        length = hypot(dx, dy)
        if length < 1.0:
            return x, y - LABEL
        return x + LABEL * dx / length, y + LABEL * dy / length


def _edges_of(t: Triangle) -> Iterator[Edge]:
    a, b, c = t
    for x, y in ((a, b), (b, c), (c, a)):
        yield min(x, y), max(x, y)
