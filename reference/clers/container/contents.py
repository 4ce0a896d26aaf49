"""What a file contains, and the sections it is written in; no triangle is made here."""

from dataclasses import dataclass
from typing import Final, assert_never

from clers.arithmetic.bits import Bits
from clers.codes import handle_data, registry
from clers.codes.closings import Closing, closings, records
from clers.container.head import HEAD, Head, PositionCoding, over_limits
from clers.container.layout import Window, read, write
from clers.container.limits import DEFAULT_FILE_LIMITS, FileLimits
from clers.container.numbers import REST, U8, raw
from clers.container.places import BITS, LATTICE
from clers.container.section import LONGEST, Section, section, sections
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.where import AtByte
from clers.edgebreaker.stream import Stream
from clers.geometry import exact
from clers.geometry.positions import Positions, Precision
from clers.geometry.quantised import Coded

MAGIC: Final = b"\x89CLERS\r\n"
"""The first eight bytes of each file. Clause: FILE-MAGIC-1."""

VERSION: Final = 1
"""The ninth. Clause: FILE-MAGIC-2."""

Stored = Positions | Coded | None
"""Exact positions, quantised ones, or connectivity alone. Clause: FILE-HEAD-3."""


@dataclass(frozen=True, slots=True)
class Contents:
    """All that a file says. Clauses: FILE-HEAD-1, FILE-HAND-1, FILE-WORD-1, FILE-POSN-1."""

    code: registry.CodeName
    faces: int
    vertices: int
    stream: Stream
    stored: Stored


@dataclass(frozen=True, slots=True)
class Opened:
    """A file whose sections are sound and whose HEAD is read, but nothing else yet."""

    data: bytes
    sections: tuple[Section, ...]
    head: Head

    def window(self, tag: str) -> tuple[Window, int]:
        """The payload of a section that is there, and where it starts."""
        found = next(s for s in self.sections if s.tag == tag)
        return found.window(self.data), found.start


def coding_of(stored: Stored) -> PositionCoding:
    """How positions are stored. Clause: FILE-HEAD-3."""
    match stored:
        case None:
            return PositionCoding.NONE
        case Positions(Precision.F32, _):
            return PositionCoding.EXACT_F32
        case Positions(_, _):
            return PositionCoding.EXACT_F64
        case Coded():
            return PositionCoding.LATTICE
        case _:
            assert_never(stored)


def compose(contents: Contents) -> Accepted[bytes] | Rejected:
    """The file with these contents. Clauses: FILE-MAGIC-1 … FILE-SECTION-5, FILE-COUNT-3."""
    stream = contents.stream

    def write(seen: tuple[Closing, ...]) -> Accepted[bytes] | Rejected:
        word = registry.encode_seen(contents.code, stream, seen)
        handles = handle_data.encode(seen, len(stream.word))
        return and_then(word, lambda bits: and_then(handles, lambda h: _compose(contents, bits, h)))

    return and_then(closings(stream), write)


def _compose(contents: Contents, word: Bits, handles: Bits) -> Accepted[bytes] | Rejected:
    stream, stored = contents.stream, contents.stored
    head = Head(
        contents.code,
        coding_of(stored),
        contents.faces,
        contents.vertices,
        stream.components_with_boundary,
        len(stream.word),
        len(stream.records),
    )
    payloads = [("HEAD", write(HEAD, head))]
    if stream.records:
        payloads.append(("HAND", write(BITS, handles)))
    payloads.append(("WORD", write(BITS, word)))
    match stored:
        case Positions():
            payloads.append(("POSN", write(REST, exact.encode(stored))))
        case Coded():
            payloads.append(("POSN", write(LATTICE, stored)))
        case None:
            pass
        case _:
            assert_never(stored)
    longest = max(len(payload) for _, payload in payloads)
    if longest > LONGEST:
        detail = f"a section of {longest} bytes"
        return Rejected(Reason.TOO_MANY_BYTES, Clause.FILE_SECTION_1, detail=detail)
    prologue = MAGIC + write(U8, VERSION)
    return Accepted(prologue + b"".join(section(tag, payload) for tag, payload in payloads))


def open_file(data: bytes, limits: FileLimits = DEFAULT_FILE_LIMITS) -> Accepted[Opened] | Rejected:
    """The sections and the HEAD of a file.

    Clauses: FILE-LIMIT-1, FILE-LIMIT-2, FILE-MAGIC-1, FILE-MAGIC-2, FILE-SECTION-1 … -5.
    """
    if len(data) > limits.bytes:
        detail = f"{len(data)} bytes, the limit is {limits.bytes}"
        return Rejected(Reason.TOO_MANY_BYTES, Clause.FILE_LIMIT_1, detail=detail)
    prologue = _prologue(data)
    if isinstance(prologue, Rejected):
        return prologue
    found = sections(data, prologue.value)
    return and_then(found, lambda parts: _open(data, parts, limits))


def _prologue(data: bytes) -> Accepted[int] | Rejected:
    """Where the sections of a file begin. Clauses: FILE-MAGIC-1, FILE-MAGIC-2."""
    window = Window(data, len(data))
    first = raw(len(MAGIC)).read(window, 0)
    if isinstance(first, Rejected):
        return first
    magic = first.value.value
    if magic != MAGIC:
        return Rejected(Reason.BAD_MAGIC, Clause.FILE_MAGIC_1, AtByte(0), magic.hex(" "))
    second = U8.read(window, first.value.offset)
    if isinstance(second, Rejected):
        return second
    version = second.value.value
    if version != VERSION:
        where = AtByte(len(MAGIC))
        return Rejected(Reason.UNKNOWN_VERSION, Clause.FILE_MAGIC_2, where, f"version {version}")
    return Accepted(second.value.offset)


def _open(
    data: bytes, parts: tuple[Section, ...], limits: FileLimits
) -> Accepted[Opened] | Rejected:
    if not parts or parts[0].tag != "HEAD":
        return Rejected(Reason.BAD_SECTION, Clause.FILE_SECTION_5, AtByte(9), "no HEAD")
    window, start = parts[0].window(data), parts[0].start
    head = read(HEAD, window, start)
    if isinstance(head, Rejected):
        return head
    over = over_limits(head.value, limits.mesh, window.at(start))
    if over is not None:
        return over
    wanted = tags_of(head.value)
    got = tuple(s.tag for s in parts)
    if got != wanted:
        detail = f"{' '.join(got)}, its HEAD asks for {' '.join(wanted)}"
        return Rejected(Reason.BAD_SECTION, Clause.FILE_SECTION_5, AtByte(len(data)), detail)
    return Accepted(Opened(data, parts, head.value))


def tags_of(head: Head) -> tuple[str, ...]:
    """The sections that a file with this HEAD has. Clause: FILE-SECTION-5."""
    hand = ("HAND",) if head.records else ()
    posn = () if head.positions is PositionCoding.NONE else ("POSN",)
    return ("HEAD", *hand, "WORD", *posn)


def parse(data: bytes, limits: FileLimits = DEFAULT_FILE_LIMITS) -> Accepted[Contents] | Rejected:
    """The contents of a file; whether a surface has them is not asked. Clause: FILE-PARSE-1."""
    return and_then(open_file(data, limits), _parse)


def _parse(opened: Opened) -> Accepted[Contents] | Rejected:
    """Clauses: FILE-HAND-1, FILE-WORD-1, FILE-PARSE-1."""
    nothing = Accepted(Bits(b"", 0))
    hand = read(BITS, *opened.window("HAND")) if opened.head.records else nothing
    word = and_then(hand, lambda _: read(BITS, *opened.window("WORD")))
    return and_then(hand, lambda h: and_then(word, lambda w: _parse_bits(opened, h, w)))


def _parse_bits(opened: Opened, hand: Bits, word: Bits) -> Accepted[Contents] | Rejected:
    """Counts before bits, handle data before the word. Clauses: FILE-COUNT-1, FILE-COUNT-2."""
    head = opened.head
    if head.symbols > registry.most_symbols(head.code, word.length):
        window, start = opened.window("WORD")
        detail = f"{head.symbols} symbols in {word.length} bits"
        where = window.at(start)
        return Rejected(Reason.IMPOSSIBLE_COUNT, Clause.FILE_COUNT_2, where, detail)
    if head.records > head.symbols:
        window, start = opened.window("HAND")
        detail = f"{head.records} records for {head.symbols} symbols"
        where = window.at(start)
        return Rejected(Reason.IMPOSSIBLE_COUNT, Clause.FILE_COUNT_1, where, detail)
    seen: Accepted[tuple[Closing, ...]] | Rejected = Accepted(())
    if head.records:
        seen = handle_data.decode(hand, head.records, head.symbols)
    return and_then(seen, lambda found: _parse_word(opened, word, found))


def _parse_word(
    opened: Opened, bits: Bits, seen: tuple[Closing, ...]
) -> Accepted[Contents] | Rejected:
    """Clauses: FILE-HAND-2, FILE-WORD-1."""
    head, components = opened.head, opened.head.components_with_boundary
    word = registry.decode(head.code, bits, head.symbols, components, seen)
    if isinstance(word, Rejected):
        return word
    known = records(word.value, seen)
    if isinstance(known, Rejected):
        return known
    stored = _parse_positions(opened)
    if isinstance(stored, Rejected):
        return stored
    stream = Stream(word.value, known.value, components)
    return Accepted(Contents(head.code, head.faces, head.vertices, stream, stored.value))


def _parse_positions(opened: Opened) -> Accepted[Stored] | Rejected:
    """Clauses: FILE-POSN-1, FILE-POSN-2."""
    match opened.head.positions:
        case PositionCoding.NONE:
            return Accepted(None)
        case PositionCoding.EXACT_F32:
            return _parse_exact(opened, Precision.F32)
        case PositionCoding.EXACT_F64:
            return _parse_exact(opened, Precision.F64)
        case PositionCoding.LATTICE:
            return read(LATTICE, *opened.window("POSN"))
        case _:
            assert_never(opened.head.positions)


def _parse_exact(opened: Opened, precision: Precision) -> Accepted[Positions] | Rejected:
    data = read(REST, *opened.window("POSN"))
    return and_then(data, lambda b: exact.decode(precision, b, opened.head.vertices))
