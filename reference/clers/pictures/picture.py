"""Pictures as values: what is seen, not yet how it is written. Lengths in units of a panel."""

from dataclasses import dataclass
from enum import StrEnum

from clers.complexes.surface import Vertex
from clers.pictures.drawing import Point
from clers.pictures.palette import Letter
from clers.pictures.story import Visit

__all__ = [
    "Edge",
    "Gate",
    "Mark",
    "Note",
    "Panel",
    "Picture",
    "Point",
    "Pointed",
    "Role",
    "Shape",
    "State",
    "Target",
]


class State(StrEnum):
    """Whether a face is not yet visited, visited, or the one visited last."""

    BLANK = "blank"
    VISITED = "visited"
    LAST = "last"


class Role(StrEnum):
    """What an edge of a panel shows."""

    CURVE = "curve"
    REACHED = "reached"
    CUT = "cut"
    REMAINDER = "remainder"
    TREE = "tree"
    MORSE = "morse"


class Target(StrEnum):
    """What can be pointed at."""

    FACE = "face"
    VERTEX = "vertex"
    TRIANGLE = "triangle"


@dataclass(frozen=True, slots=True)
class Shape:
    """A face: its triangle from the tip on, and how it is seen.

    `far`: from behind. `light`: from 0 to 1. `ring`: the radius of the circle around `centre` that
    it is drawn as, all inside the triangle belonging to other faces; 0 for the triangle itself.
    `node` is a place inside it, where links of the dual tree meet and the letter stands; `room` is
    the radius of what fits there, or 0 where no letters are wanted.
    """

    visit: Visit
    state: State
    corners: tuple[Point, Point, Point]
    far: bool
    light: float
    ring: float
    centre: Point
    node: Point
    room: float


@dataclass(frozen=True, slots=True)
class Edge:
    """A line that shows something about an edge of the surface, by the ends it has in a face.

    For the dual tree it is half a link: from inside the face to the edge.
    """

    role: Role
    ends: tuple[Vertex, Vertex]
    path: tuple[Point, Point]
    far: bool


@dataclass(frozen=True, slots=True)
class Gate:
    """A gate from its left end to its right end, with the middle of the triangle behind it.

    `waiting` is 0 for the gate to be entered next, and counts from 1 down the stack from its top.
    """

    waiting: int
    tail: Vertex
    head: Vertex
    path: tuple[Point, Point]
    into: Point


@dataclass(frozen=True, slots=True)
class Mark:
    """A vertex at one of its places; `room` is the length of the shortest edge drawn there."""

    vertex: Vertex
    at: Point
    known: bool
    far: bool
    room: float


@dataclass(frozen=True, slots=True)
class Pointed:
    """Something that a panel points at: a face, a vertex, or a triangle that need not be a face.

    `path` is one place of a vertex, or the corners of a triangle; of a face with a `ring` around
    `centre` the outer edge is meant too. Clause: TOOL-PICTURE-14.
    """

    what: Target
    path: tuple[Point, ...]
    ring: float = 0.0
    centre: Point = (0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Note:
    """A letter beside a side of a surface that was cut open."""

    at: Point
    text: str


@dataclass(frozen=True, slots=True)
class Panel:
    """The state after `step` faces. `ground` is in the order of painting. TOOL-PICTURE-1."""

    step: int
    caption: str
    ground: tuple[Shape | Edge, ...]
    gates: tuple[Gate, ...]
    marks: tuple[Mark, ...]
    notes: tuple[Note, ...]
    pointed: tuple[Pointed, ...] = ()


@dataclass(frozen=True, slots=True)
class Picture:
    """Panels of one size in rows, with a legend. Clauses: TOOL-PICTURE-1 to TOOL-PICTURE-4.

    `width` and `height` are those of a panel's drawing, the greater of them 1, up is up. `pixels`
    is the length 1. `counts` are the faces of each letter. `turned`: see Drawing.
    """

    panels: tuple[Panel, ...]
    columns: int
    width: float
    height: float
    pixels: int
    labels: bool
    counts: tuple[tuple[Letter, int], ...]
    turned: int
