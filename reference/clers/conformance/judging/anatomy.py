"""What each byte of a file is for. Clause: ORCL-DIVERGE-4."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from clers.container.contents import MAGIC, Opened, open_file
from clers.container.head import PositionCoding
from clers.container.layout import Window
from clers.container.numbers import varint
from clers.container.section import Section
from clers.conventions.result import Accepted

COUNTS: Final = ("faces", "vertices", "components with boundary", "symbols", "handle records")
"""The numbers of HEAD, in their order. Clause: FILE-HEAD-1."""

AXES: Final = "xyz"

BITS: Final = "the bits"
"""What the last region of HAND and WORD is, and of POSN on a lattice."""


@dataclass(frozen=True, slots=True)
class Region:
    """Bytes start … stop−1 of a file: the section they are in (empty: none), and what they say."""

    start: int
    stop: int
    section: str
    meaning: str


def anatomy(data: bytes) -> tuple[Region, ...]:
    """The regions of a file, in order, without gaps; none of what is no file.

    Clauses: ORCL-DIVERGE-4, FILE-INSPECT-1.
    """
    opened = open_file(data)
    return tuple(_regions(opened.value)) if isinstance(opened, Accepted) else ()


def region_at(regions: tuple[Region, ...], offset: int) -> Region | None:
    """The region that a byte is in."""
    return next((r for r in regions if r.start <= offset < r.stop), None)


def _regions(opened: Opened) -> Iterator[Region]:
    yield Region(0, len(MAGIC), "", "the magic")
    yield Region(len(MAGIC), len(MAGIC) + 1, "", "the version")
    for part in opened.sections:
        start = part.start - 12
        yield Region(start, start + 4, part.tag, "the tag")
        yield Region(start + 4, start + 8, part.tag, "the length of the payload")
        yield Region(start + 8, part.start, part.tag, "the seal of tag and length")
        yield from _payload(opened, part)
        yield Region(part.stop, part.stop + 4, part.tag, "the seal of the payload")


def _payload(opened: Opened, part: Section) -> Iterator[Region]:
    positions = opened.head.positions
    if part.tag == "HEAD":
        yield Region(part.start, part.start + 1, part.tag, "the code of the word")
        yield Region(part.start + 1, part.start + 2, part.tag, "how positions are coded")
        yield from _numbers(opened.data, part, part.start + 2, COUNTS)
    elif part.tag == "POSN" and positions is PositionCoding.LATTICE:
        names = ("exponent", *(f"low {a}" for a in AXES), *(f"extent {a}" for a in AXES))
        yield from _numbers(opened.data, part, part.start, (*names, "number of bits"))
    elif part.tag == "POSN":
        width = 4 if positions is PositionCoding.EXACT_F32 else 8
        for k, start in enumerate(range(part.start, part.stop, width)):
            what = f"vertex {k // 3}, axis {AXES[k % 3]}"
            yield Region(start, min(start + width, part.stop), part.tag, what)
    else:
        yield from _numbers(opened.data, part, part.start, ("number of bits",))


def _numbers(data: bytes, part: Section, start: int, names: tuple[str, ...]) -> Iterator[Region]:
    """Numbers of variable length one after another; what is left of the payload are its bits."""
    layout, window = varint(64), Window(data, part.stop, part.tag)
    for name in names:
        read = layout.read(window, start)
        if not isinstance(read, Accepted):
            break
        yield Region(start, read.value.offset, part.tag, name)
        start = read.value.offset
    if start < part.stop:
        yield Region(start, part.stop, part.tag, BITS)
