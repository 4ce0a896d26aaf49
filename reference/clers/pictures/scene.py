"""What every writer of pictures understands: polygons, lines, discs and words, in pixels."""

from dataclasses import dataclass

from clers.pictures.drawing import Point
from clers.pictures.palette import Colour

FONT = "DejaVu Sans, Verdana, Arial, sans-serif"


@dataclass(frozen=True, slots=True)
class Style:
    """How something is painted; `name` is unique in a scene. An empty colour: not at all."""

    name: str
    fill: Colour = ""
    stroke: Colour = ""
    width: float = 0.0
    dash: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class Polygon:
    """A polygon; of a `kind` that users can look for, with a title for those who point at it."""

    points: tuple[Point, ...]
    style: Style
    kind: str
    title: str = ""


@dataclass(frozen=True, slots=True)
class Disc:
    """A disc, with the same."""

    centre: Point
    radius: float
    style: Style
    kind: str
    title: str = ""


@dataclass(frozen=True, slots=True)
class Line:
    """A line between two points."""

    path: tuple[Point, Point]
    style: Style
    kind: str


@dataclass(frozen=True, slots=True)
class Words:
    """Words on one line: the middle of their height is at the point, as is their middle, or their
    beginning where they are not `centred`."""

    at: Point
    text: str
    size: float
    colour: Colour
    centred: bool = True
    bold: bool = False


Item = Polygon | Disc | Line | Words


@dataclass(frozen=True, slots=True)
class Group:
    """Things that belong together, the first painted first."""

    name: str
    items: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class Scene:
    """An image of these sides, in pixels; x to the right, y downward."""

    width: float
    height: float
    title: str
    groups: tuple[Group, ...]
