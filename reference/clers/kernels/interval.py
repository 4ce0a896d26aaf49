"""The interval of the arithmetic coder, narrowed and shifted, with its bits written or read.

Why nothing wraps: `low` and `high` lie from 0 to 2^32 - 1 after every step (ARITH-STATE-1), totals
are at most 2^30 (INFO-MODEL-2), so that the products are at most 2^62; while shifting, numbers are
at most doubled. `pending` and the counts of bits grow by one a shift, at most 32 a symbol.
"""

from typing import Final

from librt.strings import BytesWriter
from mypy_extensions import i64

QUARTER: Final = 0x4000_0000
HALF: Final = 0x8000_0000
THREE_QUARTERS: Final = 0xC000_0000
TOP: Final = 0xFFFF_FFFF
AHEAD: Final = 30
"""How many bits a decoder has read beyond what an encoder writes if it ends here."""


class Encoder:
    """Narrows an interval, and writes the bits that are settled; private and mutable.

    `out` has one bit in each byte. Clauses: ARITH-ENCODE-1, ARITH-SHIFT-2.
    """

    def __init__(self) -> None:
        self.low: i64 = 0
        self.high: i64 = TOP
        self.pending: i64 = 0
        self.out = BytesWriter()

    def narrow(self, below: i64, upto: i64, total: i64) -> None:
        """Take the part of the interval from `below` up to `upto` out of `total`, and shift."""
        low: i64 = self.low
        high: i64 = self.high
        width: i64 = high - low + 1
        if upto < total:
            high = low + width * upto // total - 1
        if below > 0:
            low += width * below // total
        self.settle(low, high)

    def decide(self, yes: bool, no: i64) -> None:
        """The same of two parts: the first `no` of the interval, or the rest; it has something."""
        if yes:
            self.settle(self.low + no, self.high)
        else:
            self.settle(self.low, self.low + no - 1)

    def settle(self, low: i64, high: i64) -> None:
        """Write the bits that are the same in the whole interval, and widen it. ARITH-SHIFT-2."""
        while True:
            if high < HALF:
                self.out.append(0)
                if self.pending > 0:
                    self.repeat(1)
            elif low >= HALF:
                self.out.append(1)
                if self.pending > 0:
                    self.repeat(0)
                low -= HALF
                high -= HALF
            elif low >= QUARTER and high < THREE_QUARTERS:
                self.pending += 1
                low -= QUARTER
                high -= QUARTER
            else:
                break
            low += low
            high += high + 1
        self.low = low
        self.high = high

    def repeat(self, bit: i64) -> None:
        """Write a bit as often as bits are pending. Clause: ARITH-SHIFT-2."""
        while self.pending > 0:
            self.pending -= 1
            self.out.append(bit)

    def finish(self) -> bytes:
        """The last bits after all others. Clause: ARITH-END-1."""
        last: i64 = 0 if self.low < QUARTER else 1
        self.out.append(last)
        self.pending += 1
        self.repeat(1 - last)
        return self.out.getvalue()


class Decoder:
    """Finds which part of an interval some bits point into; private and mutable.

    `bits`: one in each byte, after the last come zeros. `at`: how many were read, which is AHEAD of
    what an encoder has written by now if it ends here.
    Clauses: ARITH-DECODE-1 … ARITH-DECODE-4.
    """

    def __init__(self, bits: bytes) -> None:
        self.low: i64 = 0
        self.high: i64 = TOP
        self.bits = bits
        self.at: i64 = 0
        self.value: i64 = 0
        while self.at < 32:
            self.value += self.value + (bits[self.at] if self.at < len(bits) else 0)
            self.at += 1

    def target(self, total: i64) -> i64:
        """A number below the total: in the part of the symbol that was meant. ARITH-DECODE-2."""
        width: i64 = self.high - self.low + 1
        return ((self.value - self.low + 1) * total - 1) // width

    def narrow(self, below: i64, upto: i64, total: i64) -> None:
        """Take the part of the interval that was meant, and shift."""
        low: i64 = self.low
        high: i64 = self.high
        width: i64 = high - low + 1
        if upto < total:
            high = low + width * upto // total - 1
        if below > 0:
            low += width * below // total
        self.settle(low, high)

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
        """Shift out the bits that are the same in the whole interval, and read as many."""
        value: i64 = self.value
        bits = self.bits
        end: i64 = len(bits)
        at: i64 = self.at
        while True:
            if high < HALF:
                pass
            elif low >= HALF:
                low -= HALF
                high -= HALF
                value -= HALF
            elif low >= QUARTER and high < THREE_QUARTERS:
                low -= QUARTER
                high -= QUARTER
                value -= QUARTER
            else:
                break
            low += low
            high += high + 1
            value += value
            if at < end:
                value += bits[at]
            at += 1
        self.at = at
        self.low = low
        self.high = high
        self.value = value

    def canonical(self) -> bool:
        """Whether an encoder ends here with the bits that were read. Clause: ARITH-DECODE-4."""
        return self.value // QUARTER == (1 if self.low < QUARTER else 2)
