"""The interval of the arithmetic coder, narrowed and shifted, with its bits written or read.

Shifts are done at once that the clauses do one by one: first all those of a half, as many as the
ends have leading bits in common; then those of the central half, as many as there are ones in the
lower end and zeros in the higher one after the first bit. A shift of the central half leaves the
first bits unlike, so that none of a half comes after it. Clauses: ARITH-SHIFT-1, -2.

Why nothing wraps: `low` and `high` lie from 0 to 2^32 - 1 after every step (ARITH-STATE-1), totals
are at most 2^30 (INFO-MODEL-2), so that the products are at most 2^62; bits are masked before they
are shifted out of 32. Fewer than 31 bits are held before a symbol, and 32 are added at most.
`pending` and the counts of bits grow by at most 32 a symbol.
"""

from typing import Final

from librt.strings import BytesWriter, read_i64_be
from mypy_extensions import i64, u8

QUARTER: Final = 0x4000_0000
TOP: Final = 0xFFFF_FFFF
"""32 ones; n ones are these shifted down by 32 - n. Lesser literals are shifted in 32 bits."""

AHEAD: Final = 30
"""How many bits a decoder has read beyond what an encoder writes if it ends here."""

WINDOW: Final = 8
"""So many bytes are looked at at once."""


class Encoder:
    """Narrows an interval, and writes the bits that are settled; private and mutable.

    Bits are packed, the first the highest. `out`: whole bytes; `held`: the `holding` bits, fewer
    than 31, that are not among them yet; `length`: of all bits, once they are finished.
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
        unlike: int = low ^ high
        shared: i64 = 32 - unlike.bit_length()
        if shared > 0:
            bits: i64 = low >> 32 - shared
            if self.pending > 0:
                self.send_pending(bits, shared)
            else:
                self.held = self.held << shared | bits
                self.holding += shared
            if self.holding >= 31:
                self.flush()
        other: int = (high | ~low) & TOP >> shared + 1
        central: i64 = 31 - shared - other.bit_length()
        if central > 0:
            self.pending += central
            shared += central
        if shared > 0:
            width: i64 = high - low + 1 << shared
            low = (low & TOP >> shared + 1) << shared
            high = low + width - 1
        self.low = low
        self.high = high

    def send_pending(self, bits: i64, count: i64) -> None:
        """Write so many bits, and after the first its opposite as often as bits are pending."""
        rest: i64 = count - 1
        first: i64 = bits >> rest
        self.held = self.held << 1 | first
        self.holding += 1
        while self.pending > 0:
            if self.holding >= 31:
                self.flush()
            self.pending -= 1
            self.held = self.held << 1 | 1 - first
            self.holding += 1
        if self.holding >= 31:
            self.flush()
        self.held = self.held << rest | bits - (first << rest)
        self.holding += rest

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
        self.send_pending(last, 1)
        self.flush()
        self.length = 8 * len(self.out) + self.holding
        if self.holding > 0:
            self.out.append(u8(self.held << 8 - self.holding))
        return self.out.getvalue()


class Decoder:
    """Finds which part of an interval some bits point into; private and mutable.

    `bits`: packed, the first the highest, and after the last come zeros. `at`: how many were read,
    which is AHEAD of what an encoder has written by now if it ends here. `offset`: how far the
    number that they point at lies above `low`; a shift doubles it, whichever half it takes away.
    Clauses: ARITH-DECODE-1 … ARITH-DECODE-4.
    """

    def __init__(self, bits: bytes) -> None:
        self.low: i64 = 0
        self.high: i64 = TOP
        self.bits = bits + bytes(WINDOW)
        self.end: i64 = 8 * len(bits)
        self.at: i64 = 32
        self.offset: i64 = read_i64_be(self.bits, 0) >> 32 & TOP

    def target(self, total: i64) -> i64:
        """A number below the total: in the part of the symbol that was meant. ARITH-DECODE-2."""
        width: i64 = self.high - self.low + 1
        return ((self.offset + 1) * total - 1) // width

    def narrow(self, below: i64, upto: i64, total: i64) -> None:
        """Take the part of the interval that was meant, and shift."""
        low: i64 = self.low
        width: i64 = self.high - low + 1
        first: i64 = width * below // total
        self.offset -= first
        self.settle(low + first, low + width * upto // total - 1)

    def decide(self, no: i64) -> bool:
        """Which of two parts was meant, the first `no` of the interval or the rest; take it.

        `target` says the same: with the interval's width w, v from its lower end, and some of a
        total for no, (v + 1) · total - 1 >= w · some if and only if v >= w · some // total.
        """
        if self.offset >= no:
            self.offset -= no
            self.settle(self.low + no, self.high)
            return True
        self.settle(self.low, self.low + no - 1)
        return False

    def settle(self, low: i64, high: i64) -> None:
        """Shift out the bits that are the same in the whole interval, and read as many."""
        unlike: int = low ^ high
        shared: i64 = 32 - unlike.bit_length()
        other: int = (high | ~low) & TOP >> shared + 1
        count: i64 = 31 - other.bit_length()
        if shared > count:
            count = shared
        if count > 0:
            width: i64 = high - low + 1 << count
            low = (low & TOP >> count + 1) << count
            high = low + width - 1
            at: i64 = self.at
            offset: i64 = self.offset << count
            if at < self.end:
                window: i64 = read_i64_be(self.bits, at >> 3) >> 64 - (at & 7) - count
                offset += window & TOP >> 32 - count
            self.offset = offset
            self.at = at + count
        self.low = low
        self.high = high

    def canonical(self) -> bool:
        """Whether an encoder ends here with the bits that were read. Clause: ARITH-DECODE-4."""
        return (self.low + self.offset) // QUARTER == (1 if self.low < QUARTER else 2)
