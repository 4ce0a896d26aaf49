"""What coders that work in bytes have in common: when a reading is the whole code."""

from clers.arithmetic.bits import Bits
from clers.arithmetic.coder import Reading
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol


def strictly(
    reading: Accepted[Reading] | Rejected, bits: Bits
) -> Accepted[tuple[int, ...]] | Rejected:
    """The symbols of a reading that needs all of the bits and no more. Clause: ARITH-BYTES-2."""
    if isinstance(reading, Rejected):
        return reading
    found = reading.value
    if found.length < bits.length:
        detail = f"the message has {found.length} bits, {bits.length} are given"
        return Rejected(Reason.TRAILING_BITS, Clause.ARITH_BYTES_2, detail=detail)
    if not found.canonical:
        detail = "an encoder gives these symbols other bytes"
        return Rejected(Reason.NOT_CANONICAL, Clause.ARITH_BYTES_2, detail=detail)
    return Accepted(found.symbols)


def truncated(index: int, bits: Bits) -> Rejected:
    """The message up to symbol `index` needs more bits than there are. Clause: ARITH-BYTES-2."""
    detail = f"{bits.length} bits are given"
    return Rejected(Reason.TRUNCATED_BITS, Clause.ARITH_BYTES_2, AtSymbol(index), detail)
