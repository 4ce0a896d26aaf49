"""Index lists: faces in a buffer, as graphics libraries hold them."""

from dataclasses import dataclass
from itertools import chain
from struct import pack
from typing import Final

from librt.vecs import vec
from mypy_extensions import i64

from clers.complexes.face_list import FaceList
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.kernels import table

FACE_BYTES: Final = 12
"""Three numbers of 32 bits. Clause: CPLX-INPUT-5."""


@dataclass(frozen=True, slots=True)
class IndexList:
    """The vertices of the faces, one face after another; whole faces, and nothing else checked.

    `buffer`: 12 bytes a face, each number of 32 bits, lowest byte first. Clause: CPLX-INPUT-5.
    """

    buffer: bytes
    vertices: int

    @property
    def faces(self) -> int:
        """How many faces."""
        return len(self.buffer) // FACE_BYTES

    def flat(self) -> vec[i64]:
        """The vertex at each corner, for kernels."""
        return table.indices(self.buffer)


def index_list(buffer: bytes, vertices: int) -> Accepted[IndexList] | Rejected:
    """The index list of a buffer. Clause: CPLX-INPUT-5."""
    if len(buffer) % FACE_BYTES:
        detail = f"{len(buffer)} bytes, a face has {FACE_BYTES}"
        return Rejected(Reason.NOT_TRIANGLES, Clause.CPLX_INPUT_5, detail=detail)
    return Accepted(IndexList(buffer, vertices))


def listed_faces(given: IndexList) -> FaceList:
    """The face list of an index list. Clause: CPLX-INPUT-5."""
    numbers = iter(given.flat())
    return FaceList(tuple(zip(numbers, numbers, numbers, strict=True)), given.vertices)


def buffered(given: FaceList) -> IndexList:
    """The index list of a face list, whose numbers are from 0 to 2^32 - 1. CPLX-INPUT-5."""
    numbers = tuple(chain.from_iterable(given.faces))
    return IndexList(pack(f"<{len(numbers)}I", *numbers), given.vertices)
