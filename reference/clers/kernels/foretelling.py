"""What the context code foretells: each decision by five contexts, mixed by how well they did.

Why nothing wraps: probabilities and what slots hold are below 2^24; a weight changes by at most
4096 a decision, so that with 2^28 decisions it stays below 2^41, and the sum of five products with
logits below 2^55. What is known of twelve symbols and a count is below 16 · 6^12 < 2^36, so that an
entry is below 2^63, and the product that spreads it too.
"""

from typing import Final

from librt.strings import BytesWriter
from librt.vecs import extend, vec
from mypy_extensions import i64, u8

from clers.kernels.flat import repeated, zeros
from clers.kernels.interval import AHEAD, Decoder, Encoder
from clers.kernels.loops import MOST, Loops

UNIT: Final = 65536
"""The whole of a probability. Clause: CODE-CONTEXT-5."""

LAST: Final = 2047
"""The greatest logit. Clause: CODE-CONTEXT-6."""

OFTEN: Final = 255
"""A slot counts up to this. Clause: CODE-CONTEXT-5."""

HALF: Final = 16384
"""Half a unit of what a weight learns. Clause: CODE-CONTEXT-7."""

WEIGHT: Final = 16384
"""Every weight in the beginning. Clause: CODE-CONTEXT-7."""

NEW: Final = 8388608
"""A slot is 256·p + k in one number; this is one that was not met. Clause: CODE-CONTEXT-5."""

HISTORY: Final = 2176782336
"""Twelve symbols as digits of a number of base six. Clause: CODE-CONTEXT-4."""

DECISIONS: Final = 4
CONTEXTS: Final = 5

FIRST: Final = 768 + 1296 + 4096 + 24576
"""Values of the four contexts that have a place each, before those of twelve symbols."""

NUMBER: Final = 27
"""An entry is context · 2^27 + the number of its four slots: words have at most 2^26 symbols."""

SPREAD: Final = 94906267
"""An odd number below 2^27 without pattern: the middle bits of a product with it are mixed."""

ROOM: Final = 1024
"""Entries that there is room for in the beginning: a power of two."""


class Foretelling:
    """Loops, slots and weights; private and mutable, never seen from outside.

    `stretch`, `squash`, `rate`: the tables of CODE-CONTEXT-5 and -6. Slots lie in `slots`, four
    after one another for each context that was met, or may be; those of the context of twelve
    symbols, which are too many to have a place each, where its entry says. `entries`: each at the
    place that `spread` gives or the first free one after it; 0 is free, and so is half of them.
    Clauses: CODE-CONTEXT-1 … CODE-CONTEXT-7.
    """

    def __init__(self, loops: Loops, stretch: vec[i64], squash: vec[i64], rate: vec[i64]) -> None:
        self.loops = loops
        self.stretch = stretch
        self.squash = squash
        self.rate = rate
        room: i64 = loops.expected
        self.slots = vec[i64](capacity=DECISIONS * (FIRST + ROOM + room))
        self.slots = extend(self.slots, repeated(NEW, DECISIONS * FIRST))
        self.new = repeated(NEW, DECISIONS * ROOM)
        self.used: i64 = FIRST  # contexts that have slots
        self.entries = zeros(ROOM)
        self.weights = vec[i64]([WEIGHT] * (CONTEXTS * DECISIONS))
        self.logits = zeros(CONTEXTS)
        self.at = zeros(CONTEXTS)
        self.past: i64 = HISTORY - 1
        self.small: i64 = 0
        self.decisions: i64 = 0  # that were made

    def look(self) -> None:
        """Find the slots for the next symbol. Clause: CODE-CONTEXT-4."""
        loops = self.loops
        count = loops.count
        e: i64 = loops.gate()
        end: i64 = loops.after[e]
        x: i64 = loops.before[e]
        y: i64 = loops.after[end]
        xx: i64 = loops.before[x]
        self.small = 0 if y == x or x == end else 1 if y == xx else 2
        a: i64 = count[e]
        b: i64 = count[end]
        c: i64 = count[x]
        z: i64 = count[xx]
        if a > MOST:
            a = MOST
        if b > MOST:
            b = MOST
        if c > MOST:
            c = MOST
        if z > MOST:
            z = MOST
        past: i64 = self.past
        at = self.at
        at[0] = 4 * (48 * a + 3 * b + self.small)
        at[2] = 4 * (768 + past % 1296)
        at[3] = 4 * (2064 + 256 * a + loops.valences)
        at[4] = 4 * (6160 + 6 * (256 * c + 16 * a + z) + past % 6)
        at[1] = 4 * self.of_twelve(16 * past + a)

    def of_twelve(self, key: i64) -> i64:
        """Which slots the context of twelve symbols has; new ones if it was not met."""
        entries = self.entries
        mask: i64 = len(entries) - 1
        h: i64 = spread(key) & mask
        entry: i64 = entries[h]
        while entry != 0:
            if entry >> NUMBER == key:
                return entry & ((1 << NUMBER) - 1)
            h = (h + 1) & mask
            entry = entries[h]
        number: i64 = self.used
        self.used = number + 1
        entries[h] = (key << NUMBER) + number
        if 2 * (number - FIRST) > mask:
            self.make_room()
        if DECISIONS * (number + 1) > len(self.slots):
            self.slots = extend(self.slots, self.new)
        return number

    def make_room(self) -> None:
        """Room for as many entries again."""
        old = self.entries
        size: i64 = 2 * len(old)
        new = zeros(size)
        i: i64 = 0
        while i < len(old):
            entry: i64 = old[i]
            if entry != 0:
                h: i64 = spread(entry >> NUMBER) & (size - 1)
                while new[h] != 0:
                    h = (h + 1) & (size - 1)
                new[h] = entry
            i += 1
        self.entries = new

    def probability(self, decision: i64) -> i64:
        """How probable a yes is, out of 65536. Clauses: CODE-CONTEXT-6, CODE-CONTEXT-7."""
        slots = self.slots
        stretch = self.stretch
        weights = self.weights
        logits = self.logits
        at = self.at
        total: i64 = 0
        k: i64 = 0
        base: i64 = CONTEXTS * decision
        while k < CONTEXTS:
            logit: i64 = stretch[slots[at[k] + decision] >> 12]
            logits[k] = logit
            total += weights[base + k] * logit
            k += 1
        total >>= 16
        if total > LAST:
            total = LAST
        elif total < -LAST:
            total = -LAST
        return self.squash[total + LAST]

    def learn(self, decision: i64, yes: bool, p: i64) -> None:
        """Learn what the decision was. Clauses: CODE-CONTEXT-5, CODE-CONTEXT-7."""
        slots = self.slots
        rate = self.rate
        weights = self.weights
        logits = self.logits
        at = self.at
        error: i64 = -p
        to: i64 = 0
        if yes:
            error = UNIT - p
            to = UNIT - 1
        base: i64 = CONTEXTS * decision
        k: i64 = 0
        while k < CONTEXTS:
            weights[base + k] += (logits[k] * error + HALF) >> 15
            place: i64 = at[k] + decision
            slot: i64 = slots[place]
            often: i64 = slot & 255
            slot += ((to - (slot >> 8)) * rate[often] >> 16) << 8
            slots[place] = slot + 1 if often < OFTEN else slot
            k += 1

    def certain(self, decision: i64) -> i64:
        """UNIT or 0 where nothing else can be, or -1. Clause: CODE-CONTEXT-3."""
        if self.loops.height == 0:
            return UNIT if decision == 3 else 0
        if decision == 0 and self.small == 0:
            return 0
        if decision == 3 and not self.loops.can_split():
            return UNIT
        return -1

    def undo(self, symbol: i64) -> None:
        """Go on to the next symbol."""
        self.loops.undo(symbol)
        self.past = (6 * self.past + symbol) % HISTORY


def spread(key: i64) -> i64:
    """Where to look for a context first, in its lower bits. Below 2^63."""
    return (key ^ (key >> 18)) * SPREAD >> 20


def encoded(symbols: bytes, by: Foretelling, to: Encoder) -> i64:
    """Write symbols, the last one first; the place of the first that cannot be, or -1. Linear.

    Symbols are numbered as they are asked for. Clauses: CODE-CONTEXT-1, CODE-CONTEXT-3.
    """
    i: i64 = len(symbols) - 1
    while i >= 0:
        symbol: i64 = symbols[i]
        if by.loops.height > 0:
            by.look()
        d: i64 = 0
        while d < DECISIONS:
            yes: bool = symbol == d
            sure: i64 = by.certain(d)
            p: i64 = by.probability(d) if sure < 0 else sure
            if (p if yes else UNIT - p) == 0:
                return i
            if sure < 0:
                to.decide(yes, (to.high - to.low + 1) * (UNIT - p) >> 16)
                by.learn(d, yes, p)
            if yes:
                break
            d += 1
        by.undo(symbol)
        i -= 1
    return -1


def decoded(count: i64, longest: i64, by: Foretelling, of: Decoder) -> bytes:
    """The next `count` symbols, the last one first; fewer if they need more than `longest` bits.

    Linear. Clauses: CODE-CONTEXT-1, CODE-CONTEXT-3, ARITH-STRICT-2.
    """
    out = BytesWriter()
    i: i64 = 0
    while i < count:
        if by.loops.height > 0:
            by.look()
        d: i64 = 0
        while d < DECISIONS:
            sure: i64 = by.certain(d)
            p: i64 = by.probability(d) if sure < 0 else sure
            no: i64 = (of.high - of.low + 1) * (UNIT - p) >> 16
            yes: bool = of.decide(no) if sure < 0 else sure == UNIT
            if of.at - AHEAD > longest:
                return out.getvalue()
            by.decisions += 1
            if sure < 0:
                by.learn(d, yes, p)
            if yes:
                break
            d += 1
        out.append(u8(d))
        by.undo(d)
        i += 1
    return out.getvalue()
