"""How gates and vertices of a panel are painted."""

from collections.abc import Iterator
from itertools import pairwise
from math import dist

from clers.pictures.drawing import Point
from clers.pictures.faces import Paper
from clers.pictures.palette import FAINT, GATE, INK, PAPER, POINTER
from clers.pictures.picture import Gate, Mark, Pointed, Target
from clers.pictures.scene import Disc, Item, Line, Polygon, Style, Words


def radius_of(paper: Paper, mark: Mark) -> float:
    """A vertex's radius: less where edges are short."""
    return max(min(paper.font * 0.78, mark.room * paper.pixels * 0.3), 1.2)


def vertex(paper: Paper, mark: Mark) -> Iterator[Item]:
    """A disc with the vertex's number, or a dot. Clause: TOOL-PICTURE-1."""
    radius = radius_of(paper, mark)
    text = str(mark.vertex)
    known = "known" if mark.known else "unknown"
    ink = FAINT if mark.far else INK
    if mark.known:
        style = Style(f"{known}-far" if mark.far else known, ink, PAPER, 0.8)
    else:
        style = Style(f"{known}-far" if mark.far else known, PAPER, FAINT, 1.0)
    at = paper.at(mark.at)
    yield Disc(at, radius, style, "vertex", f"vertex {mark.vertex}")
    size = radius * (1.25 if len(text) == 1 else 1.05 if len(text) == 2 else 2.1 / len(text))
    if size >= 4 and not mark.far:
        yield Words(at, text, size, PAPER if mark.known else "#6f6f6f")


def gate(paper: Paper, shown: Gate, back: float) -> Iterator[Item]:
    """An arrow from the left end to the right end, and a smaller one into the triangle.

    `back` is how far the arrow stays from its ends. Clause: TOOL-PICTURE-1.
    """
    a, b, into = paper.at(shown.path[0]), paper.at(shown.path[1]), paper.at(shown.into)
    length = dist(a, b)
    if length < 1e-9:
        return
    along = (b[0] - a[0]) / length, (b[1] - a[1]) / length
    unit = min(paper.font / 12, max(length / 30, 0.6))
    back = min(back, length * 0.3)
    start, end = _moved(a, along, back), _moved(b, along, -back)
    now = shown.waiting == 0
    width, head = (3.6, 10.0) if now else (2.0, 7.5)
    kind = "gate" if now else "waiting"
    solid = Style(f"{kind}-{unit:.2f}", GATE, PAPER, 0.8 * unit)
    dash = () if now else (4 * unit, 3 * unit)
    halo = Style(f"{kind}-halo-{unit:.2f}", "", PAPER, (width + 1.8) * unit)
    shaft = Style(f"{kind}-shaft-{unit:.2f}", "", GATE, width * unit, dash)
    neck = _moved(end, along, -head * unit)
    yield Line((start, neck), halo, f"{kind}-halo")
    yield Line((start, neck), shaft, kind)
    yield Polygon(_head(end, along, head * unit), solid, f"{kind}-head")
    middle = _moved(a, along, length / 2)
    # across the edge, towards the triangle: up is down here, so turn by the side `into` lies on
    side = (into[0] - a[0]) * along[1] - (into[1] - a[1]) * along[0]
    across = (along[1], -along[0]) if side > 0 else (-along[1], along[0])
    tip = _moved(middle, across, (head + 0.7 * width) * unit)
    yield Polygon(_head(tip, across, head * unit), solid, f"{kind}-into")


def pointer(paper: Paper, shown: Pointed) -> Iterator[Item]:
    """An outline that nothing else has: on light ground, so that it stands out on every colour.

    Clause: TOOL-PICTURE-14.
    """
    path, width = tuple(map(paper.at, shown.path)), paper.font / 3.6
    kind = f"pointed-{shown.what}"
    halo = Style(f"pointed-halo-{width:.2f}", "", PAPER, 1.8 * width)
    if shown.what is Target.VERTEX:
        ring = Style(f"pointed-{width:.2f}", "", POINTER, width)
        yield Disc(path[0], paper.font, halo, f"{kind}-halo")
        yield Disc(path[0], paper.font, ring, kind, "what is pointed at")
        return
    dash = (1.4 * width, 1.1 * width) if shown.what is Target.TRIANGLE else ()
    line = Style(f"pointed{'-dashed' if dash else ''}-{width:.2f}", "", POINTER, width, dash)
    yield Polygon(path, halo, f"{kind}-halo")
    if shown.what is Target.TRIANGLE:
        yield from (Line(side, line, kind) for side in pairwise((*path, path[0])))
        return
    if shown.ring:
        yield Disc(paper.at(shown.centre), shown.ring * paper.pixels, line, kind)
    yield Polygon(path, line, kind, "what is pointed at")


def _moved(point: Point, way: Point, length: float) -> Point:
    return point[0] + way[0] * length, point[1] + way[1] * length


def _head(tip: Point, way: Point, length: float) -> tuple[Point, ...]:
    """The triangle of an arrow's head."""
    base = _moved(tip, way, -length)
    across = (way[1], -way[0])
    return tip, _moved(base, across, length * 0.48), _moved(base, across, -length * 0.48)
