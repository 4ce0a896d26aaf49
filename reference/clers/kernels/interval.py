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


class Encoder:
    """Narrows an interval, and writes the bits that are settled; private and mutable.

    Clauses: ARITH-ENCODE-1, ARITH-SHIFT-2, ARITH-BITS-2.
    """

    def __init__(self) -> None:
        self.low: i64 = 0
        self.high: i64 = TOP
        self.pending: i64 = 0
        self.out = BytesWriter()
        self.filling: i64 = 1  # a one, then the bits of the byte that is not full
        self.length: i64 = 0

    def narrow(self, below: i64, upto: i64, total: i64) -> None:
        """Take the part of the interval from `below` up to `upto` out of `total`, and shift."""
        width: i64 = self.high - self.low + 1
        high: i64 = self.low + width * upto // total - 1
        low: i64 = self.low + width * below // total
        while True:
            if high < HALF:
                self.send(0)
            elif low >= HALF:
                self.send(1)
                low -= HALF
                high -= HALF
            elif low >= QUARTER and high < THREE_QUARTERS:
                self.pending += 1
                low -= QUARTER
                high -= QUARTER
            else:
                break
            low *= 2
            high += high + 1
        self.low = low
        self.high = high

    def send(self, bit: i64) -> None:
        """Write a bit, and as often as bits are pending its opposite. Clause: ARITH-SHIFT-2."""
        self.write(bit)
        while self.pending > 0:
            self.write(1 - bit)
            self.pending -= 1

    def write(self, bit: i64) -> None:
        """Write one bit, the most significant of a byte first. Clause: ARITH-BITS-2."""
        filling: i64 = self.filling * 2 + bit
        self.length += 1
        if filling >= 256:
            self.out.append(filling - 256)
            filling = 1
        self.filling = filling

    def finish(self) -> bytes:
        """The last bits, and all bytes, the last one filled with zeros. Clause: ARITH-END-1."""
        self.pending += 1
        self.send(0 if self.low < QUARTER else 1)
        while self.filling != 1:
            self.write(0)
            self.length -= 1
        return self.out.getvalue()


class Decoder:
    """Finds which part of an interval some bits point into; private and mutable.

    `length`: the bits that an encoder has written by now, and two more. After the bits come zeros.
    Clauses: ARITH-DECODE-1 … ARITH-DECODE-4.
    """

    def __init__(self, data: bytes) -> None:
        self.low: i64 = 0
        self.high: i64 = TOP
        self.data = data
        self.end: i64 = 8 * len(data)
        self.at: i64 = 0
        self.length: i64 = 2
        self.value: i64 = 0
        k: i64 = 0
        while k < 32:
            self.value = 2 * self.value + self.next()
            k += 1

    def next(self) -> i64:
        """The next bit, 0 after the last."""
        at: i64 = self.at
        self.at = at + 1
        if at >= self.end:
            return 0
        byte: i64 = self.data[at >> 3]
        return byte >> (7 - (at & 7)) & 1

    def target(self, total: i64) -> i64:
        """A number below the total: in the part of the symbol that was meant. ARITH-DECODE-2."""
        width: i64 = self.high - self.low + 1
        return ((self.value - self.low + 1) * total - 1) // width

    def narrow(self, below: i64, upto: i64, total: i64) -> None:
        """Take the part of the interval that was meant, and shift."""
        width: i64 = self.high - self.low + 1
        high: i64 = self.low + width * upto // total - 1
        low: i64 = self.low + width * below // total
        value: i64 = self.value
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
            low *= 2
            high += high + 1
            value += value + self.next()
            self.length += 1
        self.low = low
        self.high = high
        self.value = value

    def canonical(self) -> bool:
        """Whether an encoder ends here with the bits that were read. Clause: ARITH-DECODE-4."""
        return self.value // QUARTER == (1 if self.low < QUARTER else 2)
