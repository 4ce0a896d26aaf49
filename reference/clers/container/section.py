"""Sections: a tag, a length and a payload, each part sealed by a checksum of its own."""

from dataclasses import dataclass
from typing import Final, TypeVar
from zlib import crc32

from clers.container.layout import Layout, Read, Window, dependent, pair, write
from clers.container.numbers import U32, raw
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected

A = TypeVar("A")

TAGS: Final = ("HEAD", "HAND", "WORD", "POSN")
"""The sections there are, in their order. Clause: FILE-SECTION-3."""

LONGEST: Final = (1 << 32) - 1
"""The longest payload. Clause: FILE-SECTION-1."""


def sealed(inner: Layout[A]) -> Layout[A]:
    """A layout and the CRC-32 of its bytes, checked once they are read.

    Clauses: FILE-SECTION-2, FILE-DAMAGE-1, FILE-DAMAGE-2.
    """

    def write_sealed(value: A) -> bytes:
        data = inner.write(value)
        return data + write(U32, crc32(data))

    def read_sealed(window: Window, offset: int) -> Accepted[Read[A]] | Rejected:
        got = inner.read(window, offset)
        if isinstance(got, Rejected):
            return got
        end = got.value.offset
        seal = U32.read(window, end)
        if isinstance(seal, Rejected):
            return seal
        computed = crc32(memoryview(window.data)[offset:end])
        if seal.value.value != computed:
            detail = f"{seal.value.value:08x} is written, the bytes have {computed:08x}"
            where = window.at(end)
            return Rejected(Reason.BAD_CHECKSUM, Clause.FILE_SECTION_2, where, detail)
        return Accepted(Read(got.value.value, seal.value.offset))

    return Layout(write_sealed, read_sealed, inner.least + 4)


HEADER: Final[Layout[tuple[bytes, int]]] = sealed(pair(raw(4), U32))
"""Tag and length. Clause: FILE-SECTION-1."""

SECTION: Final[Layout[tuple[tuple[bytes, int], bytes]]] = dependent(
    HEADER, lambda header: sealed(raw(header[1]))
)
"""Header and payload. Clause: FILE-SECTION-1."""


@dataclass(frozen=True, slots=True)
class Section:
    """Where a payload lies in its file: bytes start … stop−1. Clause: FILE-SECTION-1."""

    tag: str
    start: int
    stop: int

    def window(self, data: bytes) -> Window:
        """The payload as something to read."""
        return Window(data, self.stop, self.tag)


def section(tag: str, payload: bytes) -> bytes:
    """The bytes of one section. Clause: FILE-SECTION-1."""
    return write(SECTION, ((tag.encode("ascii"), len(payload)), payload))


def sections(data: bytes, start: int) -> Accepted[tuple[Section, ...]] | Rejected:
    """All sections from `start` to the end of the file.

    Clauses: FILE-SECTION-1 … FILE-SECTION-4.
    """
    found: list[Section] = []
    window = Window(data, len(data))
    offset = start
    while offset < len(data):
        header = HEADER.read(window, offset)
        if isinstance(header, Rejected):
            return header
        tag = header.value.value[0].decode("latin-1")
        if tag not in TAGS:
            where, detail = window.at(offset), f"tag {tag!r}"
            return Rejected(Reason.UNKNOWN_SECTION, Clause.FILE_SECTION_3, where, detail)
        if found and TAGS.index(tag) <= TAGS.index(found[-1].tag):
            where, detail = window.at(offset), f"{tag} after {found[-1].tag}"
            return Rejected(Reason.BAD_SECTION, Clause.FILE_SECTION_4, where, detail)
        whole = SECTION.read(Window(data, len(data), tag), offset)
        if isinstance(whole, Rejected):
            return whole
        payload = header.value.offset
        found.append(Section(tag, payload, payload + header.value.value[1]))
        offset = whole.value.offset
    return Accepted(tuple(found))
