"""Places in files, and edits there. Clause: ORCL-FAULT-2."""

from collections.abc import Sequence
from dataclasses import dataclass

from clers.conformance import payloads as form
from clers.conformance.cases.case import Edit
from clers.conformance.cases.edits import replaced
from clers.container.file import decode
from clers.conventions.clause import Clause
from clers.conventions.result import Accepted
from clers.oracle.negatives.by_hand import File
from clers.oracle.negatives.draft import Draft, Slip, good
from clers.oracle.positives.asked import needed

HEADER = 12
PROLOGUE = 9


@dataclass(frozen=True, slots=True)
class Place:
    """Where a section is: its header, its payload up to `stop`, then the seal. FILE-SECTION-1."""

    tag: bytes
    header: int
    start: int
    stop: int

    @property
    def end(self) -> int:
        """The first byte after the section."""
        return self.stop + 4


def places(file: File) -> tuple[Place, ...]:
    """The sections of a file."""
    at, found = PROLOGUE, list[Place]()
    for tag, payload in file.parts:
        start = at + HEADER
        found.append(Place(tag, at, start, start + len(payload)))
        at = found[-1].end
    return tuple(found)


def place(file: File, tag: bytes) -> Place:
    """The section of this tag."""
    return next(place for place in places(file) if place.tag == tag)


def exchanged(at: int, old: bytes, new: bytes) -> Edit:
    """Bytes exchanged for others."""
    return replaced("/hex", 2 * at, old.hex(), new.hex())


def cut(file: File, at: int) -> Edit:
    """All from here on gone."""
    return exchanged(at, file.data[at:], b"")


def flipped(file: File, at: int, bit: int = 1) -> Edit:
    """One bit of a byte the other way."""
    old = file.data[at]
    return exchanged(at, bytes([old]), bytes([old ^ bit]))


def payload(file: File, tag: bytes, new: bytes) -> tuple[Edit, ...]:
    """Another payload for a section, and its length, to be sealed anew.

    Only what differs between the old and the new is edited.
    """
    here = place(file, tag)
    old = file.data[here.start : here.stop]
    same = next((i for i in range(min(len(old), len(new))) if old[i] != new[i]), None)
    first = min(len(old), len(new)) if same is None else same
    tail = 0
    while tail < min(len(old), len(new)) - first and old[-1 - tail] == new[-1 - tail]:
        tail += 1
    inner = exchanged(
        here.start + first, old[first : len(old) - tail], new[first : len(new) - tail]
    )
    if len(old) == len(new):
        return (inner,)
    lengths = (len(x).to_bytes(4, "little") for x in (old, new))
    return inner, exchanged(here.header + 4, *lengths)


def field(file: File, at: int, new: bytes) -> tuple[Edit, ...]:
    """Another code (0), position coding (1) or count (2 …) in HEAD, each of one byte before."""
    head = file.parts[0][1]
    if len(head) != 7:
        raise Slip(f"a HEAD of {len(head)} bytes")
    return payload(file, b"HEAD", head[:at] + new + head[at + 1 :])


def parent(slug: str, file: File, flags: Sequence[str] = ()) -> Draft:
    """The case of a file put together by hand. Clause: ORCL-GRAMMAR-2."""
    found = decode(file.data)
    if not isinstance(found, Accepted):
        raise Slip(f"{slug}: {found.line()}")
    clauses = {
        1: Clause.FILE_WORD_1, 2: Clause.FILE_POSN_1, 3: Clause.FILE_POSN_1, 4: Clause.FILE_POSN_2,
    }  # fmt: skip
    hand = (Clause.FILE_HAND_1,) if file.closings else ()
    surface = found.value.surface
    return good(
        slug, "mesh.decode", form.FileForm(hex=file.data.hex()),
        (Clause.FILE_SECTION_1, Clause.FILE_HEAD_1, *hand, clauses[file.coding]),
        requires=(f"code.{file.code}", *needed(surface)), size=surface.faces, flags=flags,
    )  # fmt: skip
