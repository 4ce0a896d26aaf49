"""rANS: an asymmetric numeral system with a state of 56 bits that moves in bytes; linear time."""

from bisect import bisect_right
from collections.abc import Sequence
from typing import Final

from clers.arithmetic.bits import Bits
from clers.arithmetic.bytewise import strictly, truncated
from clers.arithmetic.coder import Coder, Reading
from clers.arithmetic.rans_steps import BOTTOM, M, stretched
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.information.model import MAXIMUM_TOTAL, Model, Slot, over_maximum, slots

_HEAD: Final = 7
"""The bytes of a state."""


def encode(model: Model, symbols: Sequence[int]) -> Accepted[Bits] | Rejected:
    """The bytes of a message, linear in symbols and bytes.

    Clauses: ARITH-RANS-1 … ARITH-RANS-3, ARITH-BYTES-1, ARITH-BYTES-3, ARITH-BYTES-5.
    """
    found = slots(model, symbols)
    if isinstance(found, Rejected):
        return found
    state = BOTTOM
    sent = bytearray()
    for slot in reversed(found.value):
        below, frequency = stretched(slot)
        while state >= frequency << 26:
            sent.append(state & 255)
            state >>= 8
        state = M * (state // frequency) + below + state % frequency
    data = state.to_bytes(_HEAD, "big") + sent[::-1]
    return Accepted(Bits(data, 8 * len(data)))


def read(model: Model, bits: Bits, count: int) -> Accepted[Reading] | Rejected:
    """The first `count` symbols that any bits decode to (fewer if the model ends).

    Clauses: ARITH-RANS-4, ARITH-RANS-5, ARITH-BYTES-1, ARITH-BYTES-3.
    """
    return _read(model, bits, count, None)


def decode(model: Model, bits: Bits, count: int) -> Accepted[tuple[int, ...]] | Rejected:
    """The message that these bytes, and no others, encode. Clauses: ARITH-RANS-5, ARITH-BYTES-2."""
    return strictly(_read(model, bits, count, bits.length), bits)


def _read(
    model: Model, bits: Bits, count: int, longest: int | None
) -> Accepted[Reading] | Rejected:
    """Decode; give up as soon as the message must have more than `longest` bits, if given."""
    data = bits.data
    if bits.length < 8 * _HEAD:
        return truncated(0, bits)
    state = int.from_bytes(data[:_HEAD], "big")
    if state < BOTTOM:
        detail = f"the first state is {state}, must be {BOTTOM} or more"
        return Rejected(Reason.NOT_CANONICAL, Clause.ARITH_RANS_5, detail=detail)
    at = _HEAD
    symbols: list[int] = []
    for index in range(count):
        table = model.cumulative
        total = table[-1]
        if total > MAXIMUM_TOTAL:
            return over_maximum(index, total)
        if total == 0:
            break
        place = state % M
        symbol = bisect_right(table, ((place + 1) * total - 1) // M) - 1
        below, frequency = stretched(Slot(table[symbol], table[symbol + 1], total))
        state = frequency * (state // M) + place - below
        while state < BOTTOM:
            state = state << 8 | (data[at] if at < len(data) else 0)
            at += 1
        if longest is not None and 8 * at > longest:
            return truncated(index, bits)
        symbols.append(symbol)
        model = model.after(symbol)
    return Accepted(Reading(tuple(symbols), 8 * at, state == BOTTOM))


RANS: Final = Coder(encode, decode, read)
