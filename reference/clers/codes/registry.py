"""All codes of words, by the name that the command line and the container know them by."""

from collections.abc import Mapping
from enum import StrEnum
from typing import Final

from clers.arithmetic.bits import Bits
from clers.codes import (
    adaptive,
    best,
    context,
    enumerative,
    golden,
    huffman,
    king_rossignac,
    minimax,
    plain,
)
from clers.codes.closings import Closing, closings
from clers.codes.code import Code, Shape
from clers.codes.implied import coded_part, implied
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.where import AtRecord
from clers.edgebreaker.stream import Stream


class CodeName(StrEnum):
    """The codes. Clause: CODE-NAME-1."""

    PLAIN = "plain"
    KING_ROSSIGNAC = "king-rossignac"
    GOLDEN = "golden"
    MINIMAX_3 = "minimax-3"
    MINIMAX_8 = "minimax-8"
    ENUMERATIVE = "enumerative"
    HUFFMAN = "huffman"
    ADAPTIVE_1 = "adaptive-1"
    ADAPTIVE_3 = "adaptive-3"
    ADAPTIVE_6 = "adaptive-6"
    CONTEXT = "context"
    BEST = "best"


CODES: Final[Mapping[CodeName, Code]] = {
    CodeName.PLAIN: plain.CODE,
    CodeName.KING_ROSSIGNAC: king_rossignac.CODE,
    CodeName.GOLDEN: golden.CODE,
    CodeName.MINIMAX_3: minimax.code(minimax.MINIMAX_3),
    CodeName.MINIMAX_8: minimax.code(minimax.MINIMAX_8),
    CodeName.ENUMERATIVE: enumerative.CODE,
    CodeName.HUFFMAN: huffman.CODE,
    CodeName.ADAPTIVE_1: adaptive.code(1),
    CodeName.ADAPTIVE_3: adaptive.code(3),
    CodeName.ADAPTIVE_6: adaptive.code(6),
    CodeName.CONTEXT: context.CODE,
    CodeName.BEST: best.CODE,
}
"""What each name stands for. Clause: CODE-NAME-1."""

PARTIAL: Final[frozenset[CodeName]] = frozenset(
    {CodeName.MINIMAX_3, CodeName.MINIMAX_8, CodeName.ENUMERATIVE}
)
"""Codes that refuse some surfaces, as `not-representable`. Clause: CODE-NAME-5."""


def encode(code: CodeName, stream: Stream) -> Accepted[Bits] | Rejected:
    """The bits of a stream's word; not its handle data.

    Clauses: CODE-NAME-1, CODE-NAME-2; what is refused CODE-NAME-5, CODE-NAME-6.
    """

    return and_then(
        coded_part(stream),
        lambda part: and_then(closings(stream), lambda seen: _encode(code, stream, part, seen)),
    )


def encode_seen(
    code: CodeName, stream: Stream, seen: tuple[Closing, ...]
) -> Accepted[Bits] | Rejected:
    """The same, where the handle data is known as it is seen from the end. CODE-NAME-1."""
    return and_then(coded_part(stream), lambda part: _encode(code, stream, part, seen))


def _encode(
    code: CodeName, stream: Stream, part: str, seen: tuple[Closing, ...]
) -> Accepted[Bits] | Rejected:
    return CODES[code].encode(part, Shape(implied(stream.components_with_boundary), seen))


def decode(
    code: CodeName,
    bits: Bits,
    symbols: int,
    components_with_boundary: int,
    seen: tuple[Closing, ...] = (),
) -> Accepted[str] | Rejected:
    """The word of `symbols` symbols, with the handle data as it is seen from the end.

    Rejects bits no encoder writes. Clauses: CODE-NAME-1, CODE-NAME-2, CODE-IMPLIED-2, CODE-HAND-3.
    """
    fault = below_zero(seen)
    if fault is not None:
        return fault
    head = implied(components_with_boundary)
    count = symbols - len(head)
    if count < 0:
        return Rejected(Reason.EMPTY_WORD, Clause.CODE_IMPLIED_2, detail=f"{symbols} symbols")
    rest = CODES[code].decode(bits, count, Shape(head, seen))
    return Accepted(head + rest.value) if isinstance(rest, Accepted) else rest


def below_zero(seen: tuple[Closing, ...]) -> Rejected | None:
    """The first closing with a negative number, before the bits are looked at. CODE-HAND-3."""
    negative = next((i for i, c in enumerate(seen) if min(c.passed, c.between) < 0), None)
    if negative is None:
        return None
    where, detail = AtRecord(len(seen) - 1 - negative), "a negative number"
    return Rejected(Reason.RECORD_OUT_OF_RANGE, Clause.CODE_HAND_3, where, detail)


def most_symbols(code: CodeName, bits: int) -> int:
    """No word of more symbols has so few bits: what a reader may believe. Clause: CODE-NAME-3."""
    return CODES[code].most_symbols(bits)
