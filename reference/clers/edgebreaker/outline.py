"""The forward scan of a stream: components, faces, and which edges the handle data glues."""

from dataclasses import dataclass

from clers.conventions.result import Accepted, Rejected, and_then
from clers.edgebreaker.scanning import scanned
from clers.edgebreaker.stream import Stream
from clers.kernels.scan import Scan


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
    return and_then(scanned(stream), lambda scan: Accepted(outline_of(stream, scan)))


def outline_of(stream: Stream, scan: Scan) -> Outline:
    """What a scan tells, as a value that does not change."""
    parts = tuple(
        Part(scan.start[p], scan.start[p + 1], scan.face[p], p >= scan.with_boundary)
        for p in range(scan.components)
    )
    face = tuple(part.first + i for part in parts for i in range(part.stop - part.start))
    record_of = tuple(scan.record_of) or (-1,) * len(face)
    return Outline(stream, parts, scan.faces, face, record_of, tuple(scan.glue))
