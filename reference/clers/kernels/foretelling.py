"""What the context code foretells: each decision by five contexts, mixed by how well they did.

Why nothing wraps: probabilities and what slots hold are below 2^24; a weight changes by at most
4096 a decision, so that with 2^28 decisions it stays below 2^41, and the sum of five products with
logits below 2^55. What is known of twelve symbols and a count is below 16 · 6^12 < 2^36, so that
the product that spreads it is below 2^63, and what is left of it below 2^39.
"""

from typing import Final

from librt.strings import BytesWriter
from librt.vecs import append, extend, vec
from mypy_extensions import i32, i64, u8

from clers.kernels.flat import flags, narrow_zeros, repeated
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

SPREAD: Final = 94906267
"""An odd number below 2^27 without pattern: the middle bits of a product with it are mixed."""

ROOM: Final = 1024
"""Contexts of twelve symbols that there is always room for: a power of two."""

SEEN: Final = 128
"""In the mark of a place that is taken; a place with the mark 0 is free."""


class Foretelling:
    """Loops, slots and weights; private and mutable, never seen from outside.

    `stretch`, `squash`, `rate`: the tables of CODE-CONTEXT-5 and -6. `expected`: about so many
    symbols; it changes nothing but when memory is taken.

    `slots`: four after one another for each context that was met, or may be. The contexts of twelve
    symbols are too many to have a place each. They are numbered as they are met: `words` has what
    is known of each, and `numbers` its number, where `spread` says or in the first free place after
    it. There `marks` has seven bits more of what `spread` says: most places are passed, or found to
    be free, without a look at the greater arrays. A quarter of the places is free.

    Of the five contexts of the next symbol, in the order of CODE-CONTEXT-4, `at_a` to `at_e` are
    the first slots, and `logit_a` to `logit_e` what they say of the decision at hand.
    Clauses: CODE-CONTEXT-1 … CODE-CONTEXT-7.
    """

    def __init__(
        self, loops: Loops, stretch: vec[i64], squash: vec[i64], rate: vec[i64], expected: i64
    ) -> None:
        self.loops = loops
        self.stretch = stretch
        self.squash = squash
        self.rate = rate
        self.slots = unmet(FIRST + ROOM + expected)
        size: i64 = ROOM
        while 3 * size < 4 * expected:
            size += size
        self.marks = flags(size)
        self.numbers = narrow_zeros(size)
        self.words = vec[i64](capacity=ROOM + expected)
        self.weights = repeated(WEIGHT, CONTEXTS * DECISIONS)
        self.at_a: i64 = 0
        self.at_b: i64 = 0
        self.at_c: i64 = 0
        self.at_d: i64 = 0
        self.at_e: i64 = 0
        self.logit_a: i64 = 0
        self.logit_b: i64 = 0
        self.logit_c: i64 = 0
        self.logit_d: i64 = 0
        self.logit_e: i64 = 0
        self.past: i64 = HISTORY - 1
        self.small: i64 = 0
        self.decisions: i64 = 0  # that were made

    def look(self) -> None:
        """Find the slots for the next symbol. Clause: CODE-CONTEXT-4."""
        loops = self.loops
        after = loops.after
        before = loops.before
        count = loops.count
        e: i64 = loops.gate
        end: i64 = after[e]
        x: i64 = before[e]
        y: i64 = after[end]
        xx: i64 = before[x]
        small: i64 = 0 if y == x or x == end else 1 if y == xx else 2
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
        self.small = small
        self.at_a = DECISIONS * (48 * a + 3 * b + small)
        self.at_b = DECISIONS * (FIRST + self.of_twelve(16 * past + a))
        self.at_c = DECISIONS * (768 + past % 1296)
        self.at_d = DECISIONS * (2064 + 256 * a + loops.valences)
        self.at_e = DECISIONS * (6160 + 6 * (256 * c + 16 * a + z) + past % 6)

    def of_twelve(self, word: i64) -> i64:
        """The number of a context of twelve symbols; a new one if it was not met."""
        marks = self.marks
        mask: i64 = len(marks) - 1
        mixed: i64 = spread(word)
        mark: i64 = SEEN + (mixed >> 32)
        h: i64 = mixed & mask
        there: i64 = i64(marks[h])
        while there != 0:
            if there == mark:
                met: i64 = i64(self.numbers[h])
                if self.words[met] == word:
                    return met
            h = (h + 1) & mask
            there = i64(marks[h])
        number: i64 = len(self.words)
        marks[h] = u8(mark)
        self.numbers[h] = i32(number)
        self.words = append(self.words, word)
        if 4 * number > 3 * mask:
            self.make_room()
        if DECISIONS * (FIRST + number + 1) > len(self.slots):
            self.slots = extend(self.slots, unmet(ROOM))
        return number

    def make_room(self) -> None:
        """Places for as many contexts of twelve symbols again."""
        words = self.words
        mask: i64 = 2 * len(self.marks) - 1
        marks = flags(mask + 1)
        numbers = narrow_zeros(mask + 1)
        number: i64 = 0
        while number < len(words):
            mixed: i64 = spread(words[number])
            h: i64 = mixed & mask
            while marks[h] != 0:
                h = (h + 1) & mask
            marks[h] = u8(SEEN + (mixed >> 32))
            numbers[h] = i32(number)
            number += 1
        self.marks = marks
        self.numbers = numbers

    def probability(self, decision: i64) -> i64:
        """How probable a yes is, out of 65536. Clauses: CODE-CONTEXT-6, CODE-CONTEXT-7."""
        slots = self.slots
        stretch = self.stretch
        weights = self.weights
        a: i64 = stretch[i64(slots[self.at_a + decision]) >> 12]
        b: i64 = stretch[i64(slots[self.at_b + decision]) >> 12]
        c: i64 = stretch[i64(slots[self.at_c + decision]) >> 12]
        d: i64 = stretch[i64(slots[self.at_d + decision]) >> 12]
        e: i64 = stretch[i64(slots[self.at_e + decision]) >> 12]
        self.logit_a = a
        self.logit_b = b
        self.logit_c = c
        self.logit_d = d
        self.logit_e = e
        k: i64 = CONTEXTS * decision
        total: i64 = a * weights[k] + b * weights[k + 1] + c * weights[k + 2]
        total = (total + d * weights[k + 3] + e * weights[k + 4]) >> 16
        if total > LAST:
            total = LAST
        elif total < -LAST:
            total = -LAST
        return self.squash[total + LAST]

    def learn(self, decision: i64, yes: bool, p: i64) -> None:
        """Learn what the decision was. Clauses: CODE-CONTEXT-5, CODE-CONTEXT-7."""
        weights = self.weights
        error: i64 = -p
        to: i64 = 0
        if yes:
            error = UNIT - p
            to = UNIT - 1
        k: i64 = CONTEXTS * decision
        weights[k] += (self.logit_a * error + HALF) >> 15
        weights[k + 1] += (self.logit_b * error + HALF) >> 15
        weights[k + 2] += (self.logit_c * error + HALF) >> 15
        weights[k + 3] += (self.logit_d * error + HALF) >> 15
        weights[k + 4] += (self.logit_e * error + HALF) >> 15
        slots = self.slots
        rate = self.rate
        place: i64 = self.at_a + decision
        slots[place] = i32(moved(i64(slots[place]), to, rate))
        place = self.at_b + decision
        slots[place] = i32(moved(i64(slots[place]), to, rate))
        place = self.at_c + decision
        slots[place] = i32(moved(i64(slots[place]), to, rate))
        place = self.at_d + decision
        slots[place] = i32(moved(i64(slots[place]), to, rate))
        place = self.at_e + decision
        slots[place] = i32(moved(i64(slots[place]), to, rate))

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


def unmet(contexts: i64) -> vec[i32]:
    """The slots of so many contexts that were not met."""
    return vec[i32]([i32(NEW)] * (DECISIONS * contexts))


def moved(slot: i64, to: i64, rate: vec[i64]) -> i64:
    """A slot after a decision that was `to`, 0 or nearly UNIT. Clause: CODE-CONTEXT-5."""
    often: i64 = slot & 255
    slot += ((to - (slot >> 8)) * rate[often] >> 16) << 8
    return slot + 1 if often < OFTEN else slot


def spread(word: i64) -> i64:
    """Where to look for twelve symbols first, in the lower 32 bits; and seven bits more."""
    return (word ^ (word >> 18)) * SPREAD >> 24


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
