"""The interval of the arithmetic coder, narrowed and shifted, with its bits written or read.

Shifts are done at once that the clauses do one by one: first all those of a half, as many as the
ends have leading bits in common; then those of the central half, as many as there are ones in the
lower end and zeros in the higher one after the first bit. A shift of the central half leaves the
first bits unlike, so that none of a half comes after it. Clauses: ARITH-SHIFT-1, -2.

Why nothing wraps: `low` and `high` lie from 0 to 2^32 - 1 after every step (ARITH-STATE-1), totals
are at most 2^30 (INFO-MODEL-2), so that the products are at most 2^62; bits are masked before they
are shifted out of 32. Fewer than 8 bits are held, and 32 are added at most. `pending` and the
counts of bits grow by at most 32 a symbol.
"""

from typing import Final

from librt.strings import BytesWriter, read_i64_be
from mypy_extensions import i64, u8

QUARTER: Final = 0x4000_0000
HALF: Final = 0x8000_0000
THREE_QUARTERS: Final = 0xC000_0000
TOP: Final = 0xFFFF_FFFF
"""32 ones; n ones are these shifted down by 32 - n. mypyc would shift a 1 up in 32 bits only."""

REST: Final = 0x7FFF_FFFF
"""All bits but the first."""

AHEAD: Final = 30
"""How many bits a decoder has read beyond what an encoder writes if it ends here."""

WINDOW: Final = 8
"""So many bytes are looked at at once."""


class Encoder:
    """Narrows an interval, and writes the bits that are settled; private and mutable.

    Bits are packed, the first the highest. `out`: whole bytes; `held`: the `holding` bits, fewer
    than 8, that are none yet; `length`: of all bits, once they are finished.
    Clauses: ARITH-ENCODE-1, ARITH-SHIFT-2.
    """

    def __init__(self) -> None:
        self.low: i64 = 0
        self.high: i64 = TOP
        self.pending: i64 = 0
        self.held: i64 = 0
        self.holding: i64 = 0
        self.out = BytesWriter()
        self.length: i64 = 0

    def narrow(self, below: i64, upto: i64, total: i64) -> None:
        """Take the part of the interval from `below` up to `upto` out of `total`, and shift."""
        low: i64 = self.low
        width: i64 = self.high - low + 1
        self.settle(low + width * below // total, low + width * upto // total - 1)

    def decide(self, yes: bool, no: i64) -> None:
        """The same of two parts: the first `no` of the interval, or the rest; it has something."""
        if yes:
            self.settle(self.low + no, self.high)
        else:
            self.settle(self.low, self.low + no - 1)

    def settle(self, low: i64, high: i64) -> None:
        """Write the bits that are the same in the whole interval, and widen it. ARITH-SHIFT-2."""
        shared: i64 = 32 - int(low ^ high).bit_length()
        if shared > 0:
            unlike: i64 = 32 - shared
            self.send(low >> unlike, shared)
            mask: i64 = TOP >> shared
            low = (low & mask) << shared
            high = ((high & mask) << shared) + (TOP >> unlike)
        if low >= QUARTER and high < THREE_QUARTERS:
            central: i64 = 31 - int((high | ~low) & REST).bit_length()
            self.pending += central
            low = (low << central) & REST
            high = (high << central) & REST | HALF | TOP >> 32 - central
        self.low = low
        self.high = high

    def send(self, bits: i64, count: i64) -> None:
        """Write so many bits, after the first those that are pending. Clause: ARITH-SHIFT-2."""
        if self.pending > 0:
            rest: i64 = count - 1
            first: i64 = bits >> rest
            self.hold(first, 1)
            while self.pending > 0:
                self.pending -= 1
                self.hold(1 - first, 1)
            bits -= first << rest
            count = rest
        self.hold(bits, count)

    def hold(self, bits: i64, count: i64) -> None:
        """Write so many bits, at most 32."""
        self.held = self.held << count | bits
        self.holding += count
        if self.holding >= 32:
            self.flush()

    def flush(self) -> None:
        """Write the whole bytes of what is held."""
        held: i64 = self.held
        holding: i64 = self.holding
        while holding >= 8:
            holding -= 8
            self.out.append(u8(held >> holding & 255))
        self.held = held & TOP >> 32 - holding
        self.holding = holding

    def finish(self) -> bytes:
        """The last bits after all others; all of them, the last byte filled with zeros.

        Clauses: ARITH-END-1, ARITH-BITS-2.
        """
        last: i64 = 0 if self.low < QUARTER else 1
        self.pending += 1
        self.send(last, 1)
        self.flush()
        self.length = 8 * len(self.out) + self.holding
        if self.holding > 0:
            self.out.append(u8(self.held << 8 - self.holding))
        return self.out.getvalue()


class Decoder:
    """Finds which part of an interval some bits point into; private and mutable.

    `bits`: packed, the first the highest, and after the last come zeros. `at`: how many were read,
    which is AHEAD of what an encoder has written by now if it ends here.
    Clauses: ARITH-DECODE-1 … ARITH-DECODE-4.
    """

    def __init__(self, bits: bytes) -> None:
        self.low: i64 = 0
        self.high: i64 = TOP
        self.bits = bits + bytes(WINDOW)
        self.end: i64 = 8 * len(bits)
        self.at: i64 = 0
        self.value: i64 = self.take(32)

    def take(self, count: i64) -> i64:
        """Read so many bits, at most 32."""
        at: i64 = self.at
        self.at = at + count
        if at >= self.end:
            return 0
        window: i64 = read_i64_be(self.bits, at >> 3)
        return (window >> 64 - (at & 7) - count) & TOP >> 32 - count

    def target(self, total: i64) -> i64:
        """A number below the total: in the part of the symbol that was meant. ARITH-DECODE-2."""
        width: i64 = self.high - self.low + 1
        return ((self.value - self.low + 1) * total - 1) // width

    def narrow(self, below: i64, upto: i64, total: i64) -> None:
        """Take the part of the interval that was meant, and shift."""
        low: i64 = self.low
        width: i64 = self.high - low + 1
        self.settle(low + width * below // total, low + width * upto // total - 1)

    def decide(self, no: i64) -> bool:
        """Which of two parts was meant, the first `no` of the interval or the rest; take it.

        `target` says the same: with the interval's width w, v from its lower end, and some of a
        total for no, (v + 1) · total - 1 >= w · some if and only if v >= w · some // total.
        """
        if self.value >= self.low + no:
            self.settle(self.low + no, self.high)
            return True
        self.settle(self.low, self.low + no - 1)
        return False

    def settle(self, low: i64, high: i64) -> None:
        """Shift out the bits that are the same in the whole interval, and read as many.

        Nothing is asked: to guess wrong costs more than to shift by nothing.
        """
        shared: i64 = 32 - int(low ^ high).bit_length()
        mask: i64 = TOP >> shared
        low = (low & mask) << shared
        high = ((high & mask) << shared) + (TOP >> 32 - shared)
        value: i64 = (self.value & mask) << shared
        central: i64 = 31 - int((high | ~low) & REST).bit_length()
        self.low = (low << central) & REST
        self.high = (high << central) & REST | HALF | TOP >> 32 - central
        self.value = (value & HALF) + ((value << central) & REST) + self.take(shared + central)

    def canonical(self) -> bool:
        """Whether an encoder ends here with the bits that were read. Clause: ARITH-DECODE-4."""
        return self.value // QUARTER == (1 if self.low < QUARTER else 2)
