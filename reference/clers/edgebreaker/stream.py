"""What Edgebreaker writes: a word over C, L, E, R, S and the handle data; nothing about bits."""

from dataclasses import dataclass
from enum import StrEnum
from typing import Final

from clers.complexes.row import Row
from clers.complexes.surface import Corner, Vertex

SYMBOLS: Final = "CLERS"
"""The alphabet, in the order that codes and models number it in. Clause: EB-WORD-1."""


class Kind(StrEnum):
    """What closes the left edge of an S before its turn. Clause: EB-HANDLE-2."""

    HANDLE = "handle"
    BOUNDARY = "boundary"


class Side(StrEnum):
    """Which edge of the closing triangle meets the left edge of the S. Clause: EB-HANDLE-4."""

    RIGHT = "right"
    LEFT = "left"


@dataclass(frozen=True, slots=True)
class Record:
    """One record of the handle data. Clauses: EB-HANDLE-1 … EB-HANDLE-4.

    `s`: the S, counted among all S of the word; `at`: the number of R, L and E before the closing
    triangle's symbol, in the whole word; `side`: the closing triangle's edge that is glued.
    """

    kind: Kind
    s: int
    at: int
    side: Side


@dataclass(frozen=True, slots=True)
class Stream:
    """The connectivity of a surface, up to labels: what is stored. Clause: EB-WORD-2."""

    word: str
    records: tuple[Record, ...] = ()
    components_with_boundary: int = 0


@dataclass(frozen=True, slots=True)
class Encoding:
    """A stream, and how it meets the surface it was made from. Clauses: EB-ORDER-1, EB-ORDER-2.

    `vertex_order[k]` is the surface's vertex that a decoder will number k; `tip_order[f]` is the
    corner that will be corner 3f of the decoded surface (the tip of the f-th created face).
    """

    stream: Stream
    vertex_row: Row[Vertex]
    tip_row: Row[Corner]

    @property
    def vertex_order(self) -> tuple[Vertex, ...]:
        """The surface's vertices in the order of a decoder."""
        return self.vertex_row.numbers

    @property
    def tip_order(self) -> tuple[Corner, ...]:
        """The tips of the surface's faces in the order of a decoder."""
        return self.tip_row.numbers
