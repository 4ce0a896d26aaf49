"""A picture laid out on paper: panels in rows, captions below them, the legend at the bottom."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from textwrap import wrap
from typing import Final

from clers.complexes.surface import Vertex
from clers.pictures.drawing import Point
from clers.pictures.faces import Paper, edge, face, letter, outline
from clers.pictures.lettering import letters
from clers.pictures.palette import COLOURS, FAINT, INK
from clers.pictures.picture import Edge, Gate, Panel, Picture, Pointed, Role, Shape, Target
from clers.pictures.scene import Group, Item, Polygon, Scene, Style, Words
from clers.pictures.signs import gate, pointer, radius_of, vertex

WIDE: Final = 0.58
"""The width of a letter, about, of its height."""

TITLED: Final = 20_000
"""Up to so many faces have titles. Clause: TOOL-PICTURE-12."""

POINTED: Final = {
    Target.FACE: "the face pointed at",
    Target.VERTEX: "the vertex pointed at",
    Target.TRIANGLE: "the triangle pointed at",
}

NAMES: Final = {
    Role.CURVE: "boundary curve",
    Role.REACHED: "boundary curve, reached",
    Role.CUT: "cut: sides of one letter are one",
    Role.REMAINDER: "primal remainder",
    Role.TREE: "dual tree",
    Role.MORSE: "Morse edge",
}

FINE: Final = 600
"""Of more faces than this none has an outline."""


def scene(picture: Picture) -> Scene:
    """The image of a picture. Clauses: TOOL-PICTURE-1 to TOOL-PICTURE-4."""
    font = min(max(picture.pixels / 21, 9.0), 18.0)
    gap = font * 2.2
    across, high = picture.width * picture.pixels, picture.height * picture.pixels
    cell = max(across, 12 * font)
    fit = max(int(cell / (font * WIDE)), 8)
    captions = [wrap(text, fit) for text in _captions(picture)]
    lines = max(map(len, captions), default=0)
    row = high + gap + lines * font * 1.25
    rows = -(-len(picture.panels) // picture.columns)
    width = gap + picture.columns * (cell + gap)
    faces = sum(count for _, count in picture.counts)
    fine = faces > FINE
    titled = faces * len(picture.panels) <= TITLED
    groups: list[Group] = []
    for i, (panel, caption) in enumerate(zip(picture.panels, captions, strict=True)):
        down, right = divmod(i, picture.columns)
        left = gap + right * (cell + gap)
        bottom = gap + down * (row + gap * 0.5) + high
        paper = Paper(left + (cell - across) / 2, bottom, picture.pixels, font, fine, titled)
        words = [
            Words((left + cell / 2, bottom + gap + font * 1.25 * line), text, font, INK)
            for line, text in enumerate(caption)
        ]
        groups.append(Group(f"step-{panel.step}", (*_panel(paper, panel, picture.labels), *words)))
    top = gap + rows * (row + gap * 0.5) + font * 0.5
    legend, bottom = _legend(picture, font, (gap, top), width - gap)
    groups.append(Group("legend", tuple(legend)))
    title = f"Edgebreaker walk over {faces} triangles"
    return Scene(width, bottom + gap, title, tuple(groups))


def _captions(picture: Picture) -> Iterator[str]:
    """Lettered as in the tutorial's figures; with the step where steps are left out."""
    steps = [panel.step for panel in picture.panels]
    whole = steps == list(range(len(steps)))
    if len(steps) == 1:
        yield (
            ""
            if steps[0] == sum(n for _, n in picture.counts)
            else f"after {steps[0]}: {picture.panels[0].caption}"
        )
        return
    for i, panel in enumerate(picture.panels):
        yield f"({letters(i)}) {'' if whole else f'after {panel.step}: '}{panel.caption}"


def _panel(paper: Paper, panel: Panel, labels: bool) -> Iterator[Item]:
    """Faces and edges, letters, gates, vertices."""
    shapes = [item for item in panel.ground if isinstance(item, Shape)]
    roles = {item.role for item in panel.ground if isinstance(item, Edge)}
    last = max(i for i, item in enumerate(panel.ground) if isinstance(item, Shape))
    for i, item in enumerate(panel.ground):
        match item:
            case Shape():
                yield face(paper, item)
            case Edge():
                yield edge(paper, item)
        if i == last and not paper.fine:
            for shape in shapes:
                yield from outline(paper, shape)
    back = min((radius_of(paper, mark) for mark in panel.marks), default=0.0)
    for one in panel.pointed:
        yield from pointer(paper, one)
    for shown in panel.gates:
        yield from gate(paper, shown, back)
    if labels:
        for shape in shapes:
            yield from letter(paper, shape, Role.TREE in roles)
    for mark in panel.marks:
        yield from vertex(paper, mark)
    for note in panel.notes:
        yield Words(paper.at(note.at), note.text, paper.font, "#6f6f6f")


def _legend(picture: Picture, font: float, start: Point, width: float) -> tuple[list[Item], float]:
    """Swatches with letters and counts, then samples of lines; and where the legend ends."""
    items: list[Item] = []
    x, y = start
    for sample, text in (*_swatches(picture), *_samples(picture, font)):
        needed = font * (2.5 + WIDE * len(text))
        if x + needed > width and x > start[0]:
            x, y = start[0], y + font * 1.7
        items += sample((x, y), font)
        items.append(Words((x + font * 1.5, y), text, font, INK, centred=False))
        x += needed
    return items, y


Sample = Callable[[Point, float], list[Item]]


def _swatches(picture: Picture) -> Iterator[tuple[Sample, str]]:
    """A square of each letter's colour, with the letter and how often it occurs."""
    for known, count in picture.counts:
        style = Style(f"legend-{known}", COLOURS[known], FAINT, 0.6)
        yield partial(_square, style), f"{known} {count}"


def _square(style: Style, at: Point, font: float) -> list[Item]:
    (x, y), half = at, font / 2
    corners = (x, y - half), (x + font, y - half), (x + font, y + half), (x, y + half)
    return [Polygon(corners, style, "swatch")]


def _samples(picture: Picture, font: float) -> Iterator[tuple[Sample, str]]:
    """A piece of each kind of line that is drawn, with its name."""
    ways = {gate.waiting == 0 for panel in picture.panels for gate in panel.gates}
    for now, text in ((True, "next gate"), (False, "gate on the stack")):
        if now in ways:
            yield partial(_arrow, now), text
    roles = {
        item.role for panel in picture.panels for item in panel.ground if isinstance(item, Edge)
    }
    for role in Role:
        if role in roles:
            yield partial(_line, role), NAMES[role]
    targets = {one.what for panel in picture.panels for one in panel.pointed}
    for what in Target:
        if what in targets:
            yield partial(_pointer, what), POINTED[what]


def _line(role: Role, at: Point, font: float) -> list[Item]:
    paper = Paper(at[0], at[1], font * 1.2, font, fine=False, titled=False)
    return [edge(paper, Edge(role, (Vertex(0), Vertex(0)), ((0.0, 0.0), (1.0, 0.0)), far=False))]


def _pointer(what: Target, at: Point, font: float) -> list[Item]:
    """A small triangle, or a ring."""
    paper = Paper(at[0], at[1] + 0.4 * font, font, font, fine=False, titled=False)
    path = ((0.5, 0.4),) if what is Target.VERTEX else ((0.0, 0.0), (1.0, 0.0), (0.5, 0.85))
    return list(pointer(replace(paper, font=0.7 * font), Pointed(what, path)))


def _arrow(now: bool, at: Point, font: float) -> list[Item]:
    paper = Paper(at[0], at[1] + 0.2 * font, font * 1.2, font, fine=False, titled=False)
    ends, into = ((0.0, 0.0), (1.0, 0.0)), (0.5, 1.0)
    return list(gate(paper, Gate(0 if now else 1, Vertex(0), Vertex(0), ends, into), 0.0))
