"""The forward scan of a stream: components, faces, and which edges the handle data glues."""

from dataclasses import dataclass
from itertools import pairwise

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtRecord, AtSymbol
from clers.edgebreaker.stream import SYMBOLS, Kind, Side, Stream


@dataclass(frozen=True, slots=True)
class Part:
    """One component of a stream: its symbols are word[start:stop], its first face is `face`.

    A component with boundary has one face for each symbol; a closed one has P before them, so that
    symbol i makes face i - start + face, plus 1 if closed. Clause: EB-COMPONENT-3.
    """

    start: int
    stop: int
    face: int
    closed: bool

    @property
    def first(self) -> int:
        """The face of the component's first symbol."""
        return self.face + 1 if self.closed else self.face


@dataclass(frozen=True, slots=True)
class Outline:
    """What one forward scan tells of a stream. Clauses: EB-GRAMMAR-1 … EB-GRAMMAR-4.

    `faces`: how many; `face[i]`: the face of symbol i; `record_of[i]`: the record of the S at
    symbol i, or -1; `glue[r]`: for record r, the corner opposite to the closing triangle's edge.
    """

    stream: Stream
    parts: tuple[Part, ...]
    faces: int
    face: tuple[int, ...]
    record_of: tuple[int, ...]
    glue: tuple[int, ...]


def outline(stream: Stream) -> Accepted[Outline] | Rejected:
    """Scan a stream forwards. Linear. Clauses: EB-GRAMMAR-1 … EB-GRAMMAR-4."""
    word = stream.word
    if not word:
        return Rejected(Reason.EMPTY_WORD, Clause.EB_GRAMMAR_1, WHOLE)
    stranger = next((i for i, x in enumerate(word) if x not in SYMBOLS), None)
    if stranger is not None:
        detail = repr(word[stranger])
        return Rejected(Reason.UNKNOWN_SYMBOL, Clause.EB_GRAMMAR_1, AtSymbol(stranger), detail)
    record_of = _records_of_splits(stream)
    if isinstance(record_of, Rejected):
        return record_of
    parts = _parts(stream, record_of)
    if isinstance(parts, Rejected):
        return parts
    face = [part.first + i for part in parts for i in range(part.stop - part.start)]
    glue = _glue(stream, parts, face, record_of)
    if isinstance(glue, Rejected):
        return glue
    return Accepted(
        Outline(stream, tuple(parts), face[-1] + 1, tuple(face), tuple(record_of), tuple(glue))
    )


def _records_of_splits(stream: Stream) -> list[int] | Rejected:
    """For each symbol the number of its record, or -1. Clause: EB-GRAMMAR-2."""
    splits = [i for i, x in enumerate(stream.word) if x == "S"]
    for r, (before, record) in enumerate(pairwise(stream.records)):
        if before.s >= record.s:
            return Rejected(Reason.RECORD_ORDER, Clause.EB_GRAMMAR_2, AtRecord(r + 1))
    record_of = [-1] * len(stream.word)
    for r, record in enumerate(stream.records):
        if not 0 <= record.s < len(splits):
            detail = f"S number {record.s} of {len(splits)}"
            return Rejected(Reason.RECORD_OUT_OF_RANGE, Clause.EB_GRAMMAR_2, AtRecord(r), detail)
        record_of[splits[record.s]] = r
    return record_of


def _parts(stream: Stream, record_of: list[int]) -> list[Part] | Rejected:
    """Cut the word into components by the depth of the stack. Clause: EB-GRAMMAR-3."""
    parts: list[Part] = []
    start, face, depth = 0, 0, 1
    for i, x in enumerate(stream.word):
        if x == "S":
            depth += record_of[i] < 0
        elif x == "E":
            depth -= 1
            if depth == 0:
                closed = len(parts) >= stream.components_with_boundary
                parts.append(Part(start, i + 1, face, closed))
                face += i + 1 - start + closed
                start, depth = i + 1, 1
    if start < len(stream.word):
        detail = f"{depth} more E needed at least"
        last = AtSymbol(len(stream.word) - 1)
        return Rejected(Reason.UNFINISHED_WORD, Clause.EB_GRAMMAR_3, last, detail)
    if not 0 <= stream.components_with_boundary <= len(parts):
        detail = f"{len(parts)} components, {stream.components_with_boundary} with boundary"
        return Rejected(Reason.TOO_FEW_COMPONENTS, Clause.EB_GRAMMAR_3, WHOLE, detail)
    return parts


def _glue(
    stream: Stream, parts: list[Part], face: list[int], record_of: list[int]
) -> list[int] | Rejected:
    """The closing edge of each record, each edge once, after its S. Clause: EB-GRAMMAR-4."""
    closers = [i for i, x in enumerate(stream.word) if x in "RLE"]
    splits = [i for i, x in enumerate(stream.word) if x == "S"]
    open_part = max((part.stop for part in parts if not part.closed), default=0)
    glue: list[int] = []
    taken: set[int] = set()
    for r, record in enumerate(stream.records):
        if not 0 <= record.at < len(closers):
            detail = f"closing symbol {record.at} of {len(closers)}"
            return Rejected(Reason.RECORD_OUT_OF_RANGE, Clause.EB_GRAMMAR_4, AtRecord(r), detail)
        i = closers[record.at]
        if stream.word[i] not in ("RE" if record.side is Side.RIGHT else "LE"):
            detail = f"symbol {i} is {stream.word[i]}, its {record.side} edge leads on"
            return Rejected(Reason.RECORD_SIDE, Clause.EB_GRAMMAR_4, AtRecord(r), detail)
        if i < splits[record.s]:
            detail = f"symbol {i} comes before its S, symbol {splits[record.s]}"
            return Rejected(Reason.RECORD_OUTSIDE_BRANCH, Clause.EB_GRAMMAR_4, AtRecord(r), detail)
        if record.kind is Kind.BOUNDARY and splits[record.s] >= open_part:
            detail = "its component is closed"
            return Rejected(Reason.NOT_A_CURVE, Clause.EB_GRAMMAR_4, AtRecord(r), detail)
        edge = 3 * face[i] + (1 if record.side is Side.RIGHT else 2)
        if edge in taken:
            return Rejected(Reason.EDGE_CLOSED_TWICE, Clause.EB_GRAMMAR_4, AtRecord(r))
        taken.add(edge)
        glue.append(edge)
    return glue
