"""The element a rejection or a failed verdict points at. Clauses: CONV-RESULT-2, CONV-CLAUSE-5."""

from dataclasses import dataclass
from typing import Final, assert_never


@dataclass(frozen=True, slots=True)
class Whole:
    """The input as a whole: nothing smaller is to blame."""


@dataclass(frozen=True, slots=True)
class AtFace:
    """Face number `face` of a face list, counted from 0."""

    face: int


@dataclass(frozen=True, slots=True)
class AtVertex:
    """Vertex number `vertex`, counted from 0."""

    vertex: int


@dataclass(frozen=True, slots=True)
class AtEdge:
    """The directed edge `tail` to `head`, as face `face` runs it."""

    tail: int
    head: int
    face: int


@dataclass(frozen=True, slots=True)
class AtSymbol:
    """Symbol number `index` of a word, counted from 0."""

    index: int


@dataclass(frozen=True, slots=True)
class AtRecord:
    """Record number `index` of the handle data, counted from 0."""

    index: int


@dataclass(frozen=True, slots=True)
class AtStep:
    """Step number `index` of a script of operators, counted from 0."""

    index: int


@dataclass(frozen=True, slots=True)
class AtByte:
    """Byte `offset` of a file, counted from 0, inside the section named (empty: outside any)."""

    offset: int
    section: str = ""


@dataclass(frozen=True, slots=True)
class AtSimplex:
    """The simplex on these vertices, in increasing order."""

    vertices: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class AtPair:
    """Two simplices that do not go together, each by its vertices in increasing order."""

    first: tuple[int, ...]
    second: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class AtCell:
    """Cell number `number` of its dimension, counted from 0."""

    dimension: int
    number: int


@dataclass(frozen=True, slots=True)
class AtEntry:
    """Entry `index` of the array named, counted from 0."""

    array: str
    index: int


WHOLE: Final = Whole()

Where = (
    Whole
    | AtFace
    | AtVertex
    | AtEdge
    | AtSymbol
    | AtRecord
    | AtStep
    | AtByte
    | AtSimplex
    | AtPair
    | AtCell
    | AtEntry
)


def in_words(where: Where) -> str:
    """The element in words, as error lines print it."""
    match where:
        case Whole():
            return "of the whole input"
        case AtFace(face):
            return f"at face {face}"
        case AtVertex(vertex):
            return f"at vertex {vertex}"
        case AtEdge(tail, head, face):
            return f"at edge {tail}→{head} of face {face}"
        case AtSymbol(index):
            return f"at symbol {index}"
        case AtRecord(index):
            return f"at handle record {index}"
        case AtStep(index):
            return f"at step {index}"
        case AtByte(offset, ""):
            return f"at byte {offset}"
        case AtByte(offset, section):
            return f"at byte {offset} (section {section})"
        case AtSimplex(vertices):
            return f"at simplex {_listed(vertices)}"
        case AtPair(first, second):
            return f"at simplices {_listed(first)} and {_listed(second)}"
        case AtCell(dimension, number):
            return f"at {dimension}-cell {number}"
        case AtEntry(array, index):
            return f"at entry {index} of {array}"
        case _:
            assert_never(where)


def _listed(vertices: tuple[int, ...]) -> str:
    return "{" + ", ".join(map(str, vertices)) + "}"
