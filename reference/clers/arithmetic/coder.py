"""The arithmetic coder of the tutorial's Algorithms 1 and 2, mended: 32 bits, linear time."""

from bisect import bisect_right
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import chain, repeat
from typing import Final

from clers.arithmetic.bits import Bits, pack
from clers.arithmetic.steps import HALF, PRECISION, QUARTER, TOP
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol
from clers.information.model import MAXIMUM_TOTAL, Model, not_in_alphabet, over_maximum

_THREE_QUARTERS: Final = 3 * QUARTER


def encode(model: Model, symbols: Sequence[int]) -> Accepted[Bits] | Rejected:
    """The bits of a message, linear in symbols and bits.

    Clauses: ARITH-ENCODE-1, ARITH-SHIFT-2, ARITH-END-1, ARITH-END-2; for the length ARITH-LENGTH-1,
    ARITH-LENGTH-2, ARITH-LENGTH-3; rejections by INFO-MODEL-5, INFO-MODEL-6.
    """
    out = bytearray()  # one bit in each byte
    low, high, pending = 0, TOP, 0
    for index, symbol in enumerate(symbols):
        table = model.cumulative
        total = table[-1]
        if total > MAXIMUM_TOTAL:
            return over_maximum(index, total)
        if not 0 <= symbol < len(table) - 1:
            return not_in_alphabet(index, symbol)
        below, upto = table[symbol], table[symbol + 1]
        if below == upto:
            return not_in_alphabet(index, symbol)
        width = high - low + 1
        high = low + width * upto // total - 1
        low += width * below // total
        while True:
            if high < HALF:
                out.append(0)
                if pending:
                    out += b"\1" * pending
                    pending = 0
            elif low >= HALF:
                out.append(1)
                if pending:
                    out += bytes(pending)
                    pending = 0
                low -= HALF
                high -= HALF
            elif low >= QUARTER and high < _THREE_QUARTERS:
                pending += 1
                low -= QUARTER
                high -= QUARTER
            else:
                break
            low *= 2
            high += high + 1
        model = model.after(symbol)
    out += b"\0" + b"\1" * (pending + 1) if low < QUARTER else b"\1" + bytes(pending + 1)
    return Accepted(pack(out))


@dataclass(frozen=True, slots=True)
class Reading:
    """What a decoder saw in bits that may go on after the message. Clause: ARITH-DECODE-4.

    `symbols`; `length`, the number of bits that an encoder gives to these symbols; and whether
    the first `length` bits are those that an encoder gives.
    """

    symbols: tuple[int, ...]
    length: int
    canonical: bool


def read(model: Model, bits: Bits, count: int) -> Accepted[Reading] | Rejected:
    """The first `count` symbols that any bits decode to (fewer if the model ends).

    Linear in symbols and bits. Clauses: ARITH-DECODE-1 … ARITH-DECODE-4; rejection by INFO-MODEL-6.
    """
    # A symbol shifts 32 times at most, so that this bound is never met.
    return _read(model, bits, count, PRECISION * max(count, 0) + 2)


def decode(model: Model, bits: Bits, count: int) -> Accepted[tuple[int, ...]] | Rejected:
    """The message that these bits, and no others, encode: `count` symbols, or to the model's end.

    Linear in symbols and bits. Clauses: ARITH-STRICT-1 … ARITH-STRICT-4.
    """
    reading = _read(model, bits, count, bits.length)
    if isinstance(reading, Rejected):
        return reading
    found = reading.value
    if found.length < bits.length:
        detail = f"the message has {found.length} bits, {bits.length} are given"
        return Rejected(Reason.TRAILING_BITS, Clause.ARITH_STRICT_3, detail=detail)
    if not found.canonical:
        detail = "an encoder ends these symbols with other bits"
        return Rejected(Reason.NOT_CANONICAL, Clause.ARITH_STRICT_4, detail=detail)
    return Accepted(found.symbols)


def _read(model: Model, bits: Bits, count: int, longest: int) -> Accepted[Reading] | Rejected:
    """Decode; give up as soon as the message must be longer than `longest` bits.

    Clauses: ARITH-DECODE-1 … ARITH-DECODE-4, ARITH-STRICT-2.
    """
    next_bit = chain(bits.values(), repeat(0)).__next__
    low, high, value = 0, TOP, 0
    for _ in range(PRECISION):
        value += value + next_bit()
    length = 2
    symbols: list[int] = []
    if length > longest:
        return _truncated(0, bits)
    for index in range(count):
        table = model.cumulative
        total = table[-1]
        if total > MAXIMUM_TOTAL:
            return over_maximum(index, total)
        if total == 0:
            break
        width = high - low + 1
        symbol = bisect_right(table, ((value - low + 1) * total - 1) // width) - 1
        high = low + width * table[symbol + 1] // total - 1
        low += width * table[symbol] // total
        while True:
            if high < HALF:
                pass
            elif low >= HALF:
                low -= HALF
                high -= HALF
                value -= HALF
            elif low >= QUARTER and high < _THREE_QUARTERS:
                low -= QUARTER
                high -= QUARTER
                value -= QUARTER
            else:
                break
            low *= 2
            high += high + 1
            value += value + next_bit()
            length += 1
        if length > longest:
            return _truncated(index, bits)
        symbols.append(symbol)
        model = model.after(symbol)
    quarter = 1 if low < QUARTER else 2
    return Accepted(Reading(tuple(symbols), length, value // QUARTER == quarter))


def _truncated(index: int, bits: Bits) -> Rejected:
    """The message up to symbol `index` needs more bits than there are. Clause: ARITH-STRICT-2."""
    detail = f"{bits.length} bits are given"
    return Rejected(Reason.TRUNCATED_BITS, Clause.ARITH_STRICT_2, AtSymbol(index), detail)


@dataclass(frozen=True, slots=True)
class Coder:
    """An arithmetic coder as a value: what the laws of this chapter judge."""

    encode: Callable[[Model, Sequence[int]], Accepted[Bits] | Rejected]
    decode: Callable[[Model, Bits, int], Accepted[tuple[int, ...]] | Rejected]
    read: Callable[[Model, Bits, int], Accepted[Reading] | Rejected]


REFERENCE: Final = Coder(encode, decode, read)
