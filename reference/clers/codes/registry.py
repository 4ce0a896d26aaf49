"""All codes of words, by the name that the command line and the container know them by."""

from enum import StrEnum
from math import floor
from typing import assert_never

from clers.arithmetic.bits import Bits
from clers.codes import golden, plain
from clers.codes.implied import coded_part, implied
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.stream import Stream


class CodeName(StrEnum):
    """The codes. Clause: CODE-NAME-1."""

    PLAIN = "plain"
    GOLDEN = "golden"


def encode(code: CodeName, stream: Stream) -> Accepted[Bits] | Rejected:
    """The bits of a stream's word; not its handle data. Clauses: CODE-NAME-1, CODE-NAME-2."""
    part = coded_part(stream)
    if isinstance(part, Rejected):
        return part
    match code:
        case CodeName.PLAIN:
            return plain.encode(part.value)
        case CodeName.GOLDEN:
            return golden.encode(part.value, implied(stream.components_with_boundary))
        case _:
            assert_never(code)


def decode(
    code: CodeName, bits: Bits, symbols: int, components_with_boundary: int
) -> Accepted[str] | Rejected:
    """The word of `symbols` symbols. Rejects bits no encoder writes. CODE-NAME-1, CODE-NAME-2."""
    head = implied(components_with_boundary)
    count = symbols - len(head)
    if count < 0:
        return Rejected(Reason.EMPTY_WORD, Clause.CODE_IMPLIED_2, detail=f"{symbols} symbols")
    match code:
        case CodeName.PLAIN:
            rest = plain.decode(bits, count)
        case CodeName.GOLDEN:
            rest = golden.decode(bits, count, head)
        case _:
            assert_never(code)
    return Accepted(head + rest.value) if isinstance(rest, Accepted) else rest


def most_symbols(code: CodeName, bits: int) -> int:
    """No word of more symbols has so few bits: what a reader may believe. Clause: CODE-NAME-3."""
    match code:
        case CodeName.PLAIN:
            return bits + 1
        case CodeName.GOLDEN:
            return floor(bits / golden.UNIT) + 2
        case _:
            assert_never(code)
