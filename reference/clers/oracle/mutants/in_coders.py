"""Mistakes in coders, in bits, and in the models that coders ask."""

from typing import Final

from clers.conventions.clause import Clause
from clers.oracle.mutants.mutant import Mutant

CODER: Final = "clers.arithmetic.coder"
INTERVAL: Final = "clers.kernels.interval"
RANGE: Final = "clers.arithmetic.range_coder"
RANS: Final = "clers.arithmetic.rans"
BITS: Final = "clers.arithmetic.bits"

MUTANTS: Final = (
    Mutant(
        "lower-half-too-wide",
        Clause.ARITH_SHIFT_1,
        INTERVAL,
        """\
        unlike: int = low ^ high
        shared: i64 = 32 - unlike.bit_length()
        if shared > 0:
""",
        """\
        unlike: int = low ^ (high - 1 if high == 2 * QUARTER else high)
        shared: i64 = 32 - unlike.bit_length()
        if shared > 0:
""",
        "An interval that ends in the first number of the higher half is shifted as lower.",
    ),
    Mutant(
        "underflow-lost",
        Clause.ARITH_SHIFT_1,
        INTERVAL,
        "        if central > 0:\n",
        "        if central > 32:\n",
        "A central half is not shifted.",
    ),
    Mutant(
        "central-half-too-wide",
        Clause.ARITH_SHIFT_1,
        INTERVAL,
        "31 - shared - other.bit_length()",
        "31 - shared - other.bit_length() + (QUARTER <= low < 2 * QUARTER and high == 3 * QUARTER)",
        "An interval that ends in the first number of the last quarter is shifted as central.",
    ),
    Mutant(
        "pending-not-reset",
        Clause.ARITH_SHIFT_2,
        INTERVAL,
        """\
        while self.pending > 0:
            if self.holding >= 31:
                self.flush()
            self.pending -= 1
""",
        """\
        for _ in range(self.pending):
            if self.holding >= 31:
                self.flush()
""",
        "Pending bits are sent again.",
    ),
    Mutant(
        "pending-bits-alike",
        Clause.ARITH_SHIFT_2,
        INTERVAL,
        "| 1 - first",
        "| first",
        "Pending bits are not the opposite of the bit before them.",
    ),
    Mutant(
        "last-bit-missing",
        Clause.ARITH_END_1,
        INTERVAL,
        "        self.pending += 1\n        self.send_pending(last, 1)\n",
        "        self.send_pending(last, 1)\n",
        "The last bit is missing.",
    ),
    Mutant(
        "bit-too-many-at-end",
        Clause.ARITH_END_1,
        INTERVAL,
        "        self.pending += 1\n        self.send_pending(last, 1)\n",
        "        self.pending += 2\n        self.send_pending(last, 1)\n",
        "One bit more than needed ends a message.",
    ),
    Mutant(
        "end-at-quarter",
        Clause.ARITH_END_1,
        INTERVAL,
        "0 if self.low < QUARTER else 1",
        "0 if self.low <= QUARTER else 1",
        "A message whose interval begins at the first quarter ends in the wrong quarter.",
    ),
    Mutant(
        "narrowed-end-kept",
        Clause.ARITH_NARROW_1,
        INTERVAL,
        """\
        self.settle(low + width * below // total, low + width * upto // total - 1)

    def decide(self, yes""",
        """\
        self.settle(low + width // total * below, low + width // total * upto - 1)

    def decide(self, yes""",
        "The encoder divides before it multiplies.",
    ),
    Mutant(
        "slot-rounded",
        Clause.ARITH_DECODE_2,
        INTERVAL,
        "((self.offset + 1) * total - 1) // width",
        "self.offset * total // width",
        "The decoder looks its symbol up without the mends of rounding.",
    ),
    Mutant(
        "decoder-not-strict",
        Clause.ARITH_STRICT_4,
        CODER,
        "    if not canonical:",
        "    if not canonical and length < 2:",
        "Bits that no encoder ends a message with are accepted.",
    ),
    Mutant(
        "trailing-bits-accepted",
        Clause.ARITH_STRICT_3,
        CODER,
        "    if length < bits.length:",
        "    if length < bits.length - 8:",
        "Up to eight bits too many are accepted.",
    ),
    Mutant(
        "truncated-bits-accepted",
        Clause.ARITH_STRICT_2,
        CODER,
        "_read(model, bits, count, bits.length), lambda",
        "_read(model, bits, count, PRECISION * max(count, 0) + 2), lambda",
        "Bits that are missing are read as zeros.",
    ),
    Mutant(
        "negative-symbol",
        Clause.INFO_MODEL_5,
        CODER,
        "        if not 0 <= symbol < len(table) - 1 or",
        """\
        symbol %= max(len(table) - 1, symbol + 1)
        if not 0 <= symbol < len(table) - 1 or""",
        "A negative symbol is counted from the end of the table.",
    ),
    Mutant(
        "impossible-symbol",
        Clause.INFO_MODEL_5,
        "clers.kernels.automaton",
        """\
        if below == upto:
            return i
""",
        """\
        if below == upto:
            i += 1
            continue
""",
        "A symbol of frequency 0 is passed over.",
    ),
    Mutant(
        "carry-lost",
        Clause.ARITH_RANGE_5,
        RANGE,
        "carry = digit >> 8",
        "carry = 0",
        "The carry of the range coder is lost.",
    ),
    Mutant(
        "carry-stops",
        Clause.ARITH_RANGE_5,
        RANGE,
        "bytes([255 + carry & 255]) * waiting",
        'b"\\xff" * waiting',
        "A carry does not go through bytes 255.",
    ),
    Mutant(
        "renormalised-late",
        Clause.ARITH_RANGE_3,
        RANGE,
        "while size <= BOTTOM:\n            digits",
        "while size < BOTTOM:\n            digits",
        "The range coder does not shift a range of just 2^48.",
    ),
    Mutant(
        "remainder-of-range-unused",
        Clause.ARITH_RANGE_2,
        RANGE,
        """\
        size = size - unit * below if upto == total else unit * (upto - below)
        while size <= BOTTOM:
            digits""",
        """\
        size = unit * (upto - below)
        while size <= BOTTOM:
            digits""",
        "The last symbol does not take what is left of the range.",
    ),
    Mutant(
        "flushed-below",
        Clause.ARITH_RANGE_4,
        RANGE,
        "    value = -(-low // ENDING)\n",
        "    value = low // ENDING\n",
        "The last digits are rounded down, out of the range.",
    ),
    Mutant(
        "range-flush-byte",
        Clause.ARITH_RANGE_4,
        RANGE,
        "_carried([*digits, value >> 8, value & 255])",
        "_carried([*digits, value >> 8, value & 255, 0])",
        "The range coder flushes a byte more.",
    ),
    Mutant(
        "pushed-forwards",
        Clause.ARITH_RANS_3,
        RANS,
        "for slot in reversed(found.value):",
        "for slot in found.value:",
        "The encoder of rANS pushes the first symbol first.",
    ),
    Mutant(
        "state-too-large",
        Clause.ARITH_RANS_2,
        RANS,
        "while state >= frequency << 26:",
        "while state > frequency << 26:",
        "The encoder of rANS lets a state of just the bound grow.",
    ),
    Mutant(
        "bytes-as-sent",
        Clause.ARITH_RANS_3,
        RANS,
        "sent[::-1]",
        "sent",
        "The bytes of rANS stand in the order in which they were sent.",
    ),
    Mutant(
        "last-state-unchecked",
        Clause.ARITH_RANS_5,
        RANS,
        "8 * at, state == BOTTOM",
        "8 * at, state >= BOTTOM",
        "The decoder of rANS does not ask where it ends.",
    ),
    Mutant(
        "trailing-bytes-of-coder",
        Clause.ARITH_BYTES_2,
        "clers.arithmetic.bytewise",
        "if found.length < bits.length:",
        "if found.length > bits.length:",
        "Bytes after the message are accepted.",
    ),
    Mutant(
        "bits-filled-in-front",
        Clause.ARITH_BITS_2,
        BITS,
        'digits.ljust(8 * size, b"0")',
        'digits.rjust(8 * size, b"0")',
        "Zeros fill the first byte, not the last.",
    ),
    Mutant(
        "filling-unchecked",
        Clause.ARITH_BITS_3,
        BITS,
        "if length % 8 and data[-1] & (0xFF >> length % 8):",
        "if length % 8 and data[-1] & (0x7F >> length % 8):",
        "The first of the filling bits is not looked at.",
    ),
    Mutant(
        "halved-at-limit",
        Clause.INFO_ADAPT_2,
        "clers.information.adaptive",
        "if raised[-1] > self.limit:",
        "if raised[-1] >= self.limit:",
        "Frequencies are halved when their total reaches the limit.",
    ),
    Mutant(
        "halved-down",
        Clause.INFO_ADAPT_2,
        "clers.information.adaptive",
        "cumulative(f - f // 2 for",
        "cumulative(f // 2 or f for",
        "Halved frequencies are rounded down.",
    ),
    Mutant(
        "raised-from-symbol",
        Clause.INFO_ADAPT_1,
        "clers.information.adaptive",
        "table[: symbol + 1] + tuple([c + step for c in table[symbol + 1 :]])",
        "table[: symbol + 2] + tuple([c + step for c in table[symbol + 2 :]])",
        "The symbol after the one that came learns.",
    ),
    Mutant(
        "empty-table",
        Clause.INFO_STATIC_3,
        "clers.information.static",
        "if not 1 <= total <= MAXIMUM_TOTAL:",
        "if not 0 <= total <= MAXIMUM_TOTAL:",
        "A table of zeros is accepted.",
    ),
    Mutant(
        "limit-too-low",
        Clause.INFO_ADAPT_3,
        "clers.information.adaptive",
        "enough = max(sum(frequencies), increment + len(frequencies))",
        "enough = sum(frequencies)",
        "A limit is accepted over which halving does not lead.",
    ),
)
