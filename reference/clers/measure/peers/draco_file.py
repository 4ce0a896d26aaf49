"""The connectivity section of a Draco file: where it begins, what is in it, where it ends.

Written from the Draco bitstream specification, version 2.2. Nothing is decoded but lengths and
counts: what this is for is how many bytes the connectivity takes.
"""

from dataclasses import dataclass
from itertools import pairwise
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtByte

MAGIC: Final = b"DRACO"
HEADER: Final = 11
"""Bytes before the section: magic, version (two), kind, method, flags (two)."""

STANDARD: Final = 0
VALENCE: Final = 2
CONTEXTS: Final = 6
"""Valence Edgebreaker parts its symbols by the valences 2 to 7."""


@dataclass(frozen=True, slots=True)
class Connectivity:
    """The section's counts, and the bytes of its parts, which add up to all of it.

    `counts` is the traversal's kind and the numbers; `splits` the split events; `starts` the start
    faces; `seams` the attribute seams; `symbols` the symbols as they are, or by valences.
    """

    traversal: int
    vertices: int
    faces: int
    counts: int
    splits: int
    starts: int
    seams: int
    symbols: int

    @property
    def bytes(self) -> int:
        """The length of the section. Clause: TOOL-BITS-2."""
        return self.counts + self.splits + self.starts + self.seams + self.symbols


class _Reader:
    """A place in the bytes that only moves on; past the end it reads zeros."""

    __slots__ = ("at", "data", "too_long")

    def __init__(self, data: bytes) -> None:
        self.data, self.at = data, HEADER
        self.too_long: int | None = None

    def byte(self) -> int:
        value = self.data[self.at] if self.at < len(self.data) else 0
        self.at += 1
        return value

    def number(self) -> int:
        """Groups of seven binary digits, the lowest first; ten bytes at most."""
        start, value = self.at, 0
        for place in range(10):
            group = self.byte()
            value |= (group & 127) << (7 * place)
            if group < 128:
                return value
        if self.too_long is None:
            self.too_long = start
        return value

    def block(self) -> None:
        """A number, and so many bytes."""
        length = self.number()
        self.at += length

    @property
    def ended(self) -> bool:
        return self.at > len(self.data)


def connectivity(data: bytes) -> Accepted[Connectivity] | Rejected:
    """The connectivity section of a Draco file. Total; linear in the file's length.

    Clauses: TOOL-BITS-2, TOOL-BITS-3.
    """
    fault = _header(data)
    if fault is not None:
        return fault
    reader = _Reader(data)
    traversal = reader.byte()
    if traversal not in (STANDARD, VALENCE):
        return _rejected(Reason.UNKNOWN_FORMAT, HEADER, f"traversal {traversal}")
    vertices, faces = reader.number(), reader.number()
    seams = reader.byte()
    reader.number()  # symbols
    reader.number()  # split symbols
    marks = [HEADER, reader.at]
    _splits(reader)
    marks.append(reader.at)
    if traversal == STANDARD:
        reader.block()
    marks.append(reader.at)
    _coded_bits(reader)
    marks.append(reader.at)
    for _ in range(seams):
        _coded_bits(reader)
    marks.append(reader.at)
    tagged = _contexts(reader) if traversal == VALENCE else None
    marks.append(reader.at)
    if reader.too_long is not None:
        return _rejected(Reason.BAD_NUMBER, reader.too_long, "a number of more than ten bytes")
    if reader.ended:
        return _rejected(Reason.TRUNCATED_FILE, len(data), "the connectivity goes on")
    if tagged is not None:
        return _rejected(Reason.UNKNOWN_FORMAT, tagged, "symbols in the tagged scheme")
    counts, splits, plain, starts, sewn, contexts = (
        after - before for before, after in pairwise(marks)
    )
    return Accepted(
        Connectivity(traversal, vertices, faces, counts, splits, starts, sewn, plain + contexts)
    )


def _header(data: bytes) -> Rejected | None:
    """Clause: TOOL-BITS-3."""
    if not data.startswith(MAGIC):
        return _rejected(Reason.BAD_MAGIC, 0, data[: len(MAGIC)].hex(" "))
    if len(data) < HEADER:
        return _rejected(Reason.TRUNCATED_FILE, len(data), "the header goes on")
    major, minor, kind, method = data[5:9]
    if (major, minor) != (2, 2):
        return _rejected(Reason.UNKNOWN_VERSION, 5, f"version {major}.{minor}")
    if (kind, method) != (1, 1):
        return _rejected(Reason.UNKNOWN_FORMAT, 7, f"kind {kind}, method {method}")
    if data[10] & 0x80:
        return _rejected(Reason.UNKNOWN_FORMAT, 9, "with metadata")
    return None


def _rejected(reason: Reason, offset: int, detail: str) -> Rejected:
    return Rejected(reason, Clause.TOOL_BITS_3, AtByte(offset), detail)


def _splits(reader: _Reader) -> None:
    """Two numbers for each event, then a bit for each."""
    events = reader.number()
    for _ in range(2 * events):
        if reader.ended:
            return
        reader.number()
    reader.at += (events + 7) // 8


def _coded_bits(reader: _Reader) -> None:
    """Bits by a range coder: the probability of zero, a length, bytes."""
    reader.byte()
    reader.block()


def _contexts(reader: _Reader) -> int | None:
    """For each valence a count and its symbols; the place of a scheme that is not read here."""
    for _ in range(CONTEXTS):
        if reader.number() == 0:
            continue
        if reader.byte() != 1:
            return reader.at - 1
        reader.byte()  # the greatest width of a symbol
        _probabilities(reader)
        reader.block()
    return None


def _probabilities(reader: _Reader) -> None:
    """A table of probabilities: one to three bytes each, or a run of zeros in one byte."""
    left = reader.number()
    while left > 0 and not reader.ended:
        first = reader.byte()
        more = first & 3
        if more == 3:
            left -= first >> 2
        else:
            reader.at += more
        left -= 1
