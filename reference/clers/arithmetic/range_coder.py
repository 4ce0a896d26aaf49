"""A range coder: whole bytes, carries done at once, 56 bits of precision; linear time."""

from bisect import bisect_right
from collections.abc import Sequence
from typing import Final

from clers.arithmetic.bits import Bits
from clers.arithmetic.bytewise import strictly, truncated
from clers.arithmetic.coder import Coder, Reading
from clers.arithmetic.range_steps import BOTTOM, ENDING, WHOLE
from clers.conventions.result import Accepted, Rejected
from clers.information.model import MAXIMUM_TOTAL, Model, over_maximum, slots


def encode(model: Model, symbols: Sequence[int]) -> Accepted[Bits] | Rejected:
    """The bytes of a message, linear in symbols and bytes.

    Clauses: ARITH-RANGE-1 … ARITH-RANGE-5, ARITH-BYTES-1, ARITH-BYTES-3, ARITH-BYTES-4.
    """
    found = slots(model, symbols)
    if isinstance(found, Rejected):
        return found
    low, size = 0, WHOLE
    digits: list[int] = []
    for below, upto, total in found.value:
        unit = size // total
        low += unit * below
        size = size - unit * below if upto == total else unit * (upto - below)
        while size <= BOTTOM:
            digits.append(low // BOTTOM)
            low = low % BOTTOM << 8
            size <<= 8
    value = -(-low // ENDING)
    data = _carried([*digits, value >> 8, value & 255])
    return Accepted(Bits(data, 8 * len(data)))


def _carried(digits: Sequence[int]) -> bytes:
    """The bytes of digits that may be over 255. Clause: ARITH-RANGE-5."""
    out = bytearray()
    held = bytearray()  # one byte, or none before the first
    waiting = 0
    for digit in digits:
        if digit == 255:
            waiting += 1
            continue
        carry = digit >> 8
        out += bytes(byte + carry for byte in held)
        out += bytes([255 + carry & 255]) * waiting
        held, waiting = bytearray([digit & 255]), 0
    return bytes(out + held + b"\xff" * waiting)


def read(model: Model, bits: Bits, count: int) -> Accepted[Reading] | Rejected:
    """The first `count` symbols that any bits decode to (fewer if the model ends).

    Clauses: ARITH-RANGE-6, ARITH-RANGE-7, ARITH-BYTES-1, ARITH-BYTES-3.
    """
    return _read(model, bits, count, None)


def decode(model: Model, bits: Bits, count: int) -> Accepted[tuple[int, ...]] | Rejected:
    """The message that these bytes, and no others, encode. Clause: ARITH-BYTES-2."""
    return strictly(_read(model, bits, count, bits.length), bits)


def _read(
    model: Model, bits: Bits, count: int, longest: int | None
) -> Accepted[Reading] | Rejected:
    """Decode; give up as soon as the message must have more than `longest` bits, if given."""
    data = bits.data
    low, size, code = 0, WHOLE, int.from_bytes(data[:7].ljust(7, b"\0"), "big")
    length = 16
    if longest is not None and length > longest:
        return truncated(0, bits)
    at = 7
    symbols: list[int] = []
    for index in range(count):
        table = model.cumulative
        total = table[-1]
        if total > MAXIMUM_TOTAL:
            return over_maximum(index, total)
        if total == 0:
            break
        unit = size // total
        symbol = bisect_right(table, min(code // unit, total - 1)) - 1
        below, upto = table[symbol], table[symbol + 1]
        low += unit * below
        code -= unit * below
        size = size - unit * below if upto == total else unit * (upto - below)
        while size <= BOTTOM:
            low = low % BOTTOM << 8
            size <<= 8
            code = code << 8 | (data[at] if at < len(data) else 0)
            at += 1
            length += 8
        if longest is not None and length > longest:
            return truncated(index, bits)
        symbols.append(symbol)
        model = model.after(symbol)
    canonical = (low + code) // ENDING == -(-low // ENDING)
    return Accepted(Reading(tuple(symbols), length, canonical))


RANGE_CODER: Final = Coder(encode, decode, read)
