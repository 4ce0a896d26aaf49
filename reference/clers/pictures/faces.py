"""How faces and edges of a panel are painted."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from clers.pictures.caption import names
from clers.pictures.drawing import Point
from clers.pictures.palette import (
    COLOURS,
    FAINT,
    INK,
    MORSE,
    PAPER,
    REMAINDER,
    SEAM,
    TREE,
    mixed,
    readable_on,
)
from clers.pictures.picture import Edge, Role, Shape, State
from clers.pictures.scene import Disc, Item, Line, Polygon, Style, Words

LEVELS: Final = 8
"""How many brightnesses are told apart."""


@dataclass(frozen=True, slots=True)
class Paper:
    """Where a panel's drawing lies in the image: its lower left corner, and its scale in pixels.

    `font` is the size of letters. `fine`: faces are too many for outlines; `titled`: few enough for
    titles.
    """

    left: float
    bottom: float
    pixels: float
    font: float
    fine: bool
    titled: bool

    def at(self, point: Point) -> Point:
        """A point of the panel in the image."""
        return self.left + point[0] * self.pixels, self.bottom - point[1] * self.pixels


def face(paper: Paper, shape: Shape) -> Item:
    """A face as one element. Clauses: TOOL-PICTURE-1, TOOL-PICTURE-12."""
    kind = "blank" if shape.state is State.BLANK else shape.visit.letter.value
    title = told(shape) if paper.titled else ""
    style = style_of(shape, paper.fine)
    if shape.ring:
        return Disc(paper.at(shape.centre), shape.ring * paper.pixels, style, kind, title)
    return Polygon(tuple(map(paper.at, shape.corners)), style, kind, title)


def told(shape: Shape) -> str:
    """Step, letter, vertices and gate of a face in words. Clause: TOOL-PICTURE-12."""
    visit = shape.visit
    a, b = visit.entry.gate
    gate = "" if visit.entry.symbol == "P" else f", gate {a} to {b}"
    return f"step {visit.step}: {visit.letter}, face {visit.face} = {names(visit.names)}{gate}"


def colour_of(shape: Shape) -> str:
    """The colour of a face in its light."""
    blank = shape.state is State.BLANK
    plain = PAPER if blank else COLOURS[shape.visit.letter]
    level = round(shape.light * LEVELS) / LEVELS
    shaded = mixed(plain, "#000000", (0.2 if blank else 0.4) * (1 - level))
    return mixed(shaded, "#d8d8d8" if blank else PAPER, 0.55) if shape.far else shaded


def style_of(shape: Shape, fine: bool) -> Style:
    """Equal styles have equal names."""
    blank = shape.state is State.BLANK
    fill = colour_of(shape)
    last = shape.state is State.LAST and not fine
    name = "-".join(
        (
            "blank" if blank else shape.visit.letter.value,
            str(round(shape.light * LEVELS)),
            *(("far",) if shape.far else ()),
            *(("last",) if last else ()),
        )
    )
    if fine:
        return Style(name, fill, mixed(fill, FAINT, 0.6) if blank else fill, 0.4)
    return Style(name, fill, FAINT if blank else "#5a5a5a", 1.0)


def outline(paper: Paper, shape: Shape) -> Iterator[Item]:
    """The strong outline of the face visited last. Clause: TOOL-PICTURE-1."""
    if shape.state is State.LAST:
        wide = Style("outline", "", INK, paper.font / 5.5)
        yield Polygon(tuple(map(paper.at, shape.corners)), wide, "outline")
        if shape.ring:
            yield Disc(paper.at(shape.centre), shape.ring * paper.pixels, wide, "outline")


def letter(paper: Paper, shape: Shape, node: bool) -> Iterator[Item]:
    """The letter of a visited face, where it has room; on a disc where it is a `node` of a tree."""
    size = min(paper.font * 1.15, 1.3 * shape.room * paper.pixels)
    at = shape.node
    if shape.state is not State.BLANK and not shape.far and size >= 4:
        colour = colour_of(shape)
        if node:
            style = Style(f"node-{colour[1:]}", colour, "", 0.0)
            yield Disc(paper.at(at), 0.72 * size, style, "node")
        ink = readable_on(colour)
        yield Words(paper.at(at), shape.visit.letter.value, size, ink, bold=True)


def edge(paper: Paper, shown: Edge) -> Item:
    """A line in its role's style."""
    unit = paper.font / 12 if not paper.fine else max(paper.pixels / 1000, 0.5)
    colour, width, dash = {
        Role.CURVE: (INK, 1.4, ()),
        Role.REACHED: (INK, 3.2, ()),
        Role.CUT: (SEAM, 1.6, (1.5, 2.5)),
        Role.REMAINDER: (REMAINDER, 2.6, ()),
        Role.TREE: (TREE, 1.8, ()),
        Role.MORSE: (MORSE, 4.0, ()),
    }[shown.role]
    name = shown.role.value
    if shown.far:
        colour, name = mixed(colour, PAPER, 0.5), f"{name}-far"
    style = Style(name, "", colour, width * unit, tuple(unit * length for length in dash))
    return Line((paper.at(shown.path[0]), paper.at(shown.path[1])), style, shown.role.value)
