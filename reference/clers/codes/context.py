"""The context code: the word from its end, each symbol by what is known of the loop it is put on.

Read backwards, as Spirale Reversi reads it, a word shows its loops as they are: nothing has to be
guessed, and the number of triangles at each vertex of a loop is known. Five contexts foretell each
decision, and are mixed by how well they did.
"""

from collections.abc import Generator
from typing import Final

from clers.arithmetic import coder
from clers.arithmetic.bits import Bits
from clers.codes.code import NOTHING, Code, Shape
from clers.codes.logistic import HALF, LAST, NEW, OFTEN, RATE, SQUASH, STRETCH, UNIT, WEIGHT
from clers.codes.loops import MOST, ORDER, C, E, Loops, S
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol

DECISIONS: Final = {"C": (1,), "R": (0, 1), "L": (0, 0, 1), "E": (0, 0, 0, 1), "S": (0, 0, 0, 0)}
"""Is it C? R? L? E? Clause: CODE-CONTEXT-1."""

NONE: Final = 5
"""Stands for a symbol before the first. Clause: CODE-CONTEXT-4."""

HISTORY: Final = 6**12
"""Twelve symbols as digits of a number of base six. Clause: CODE-CONTEXT-4."""

END: Final = -1
"""Stands for a probability after the last decision."""


def foretold(count: int, shape: Shape) -> Generator[int, int, None]:
    """Yield how probable the next decision is to be yes, out of 65536; take what it is.

    Yields END after `count` symbols. Linear. The hot loop of this code: plain lists and integers.
    Clauses: CODE-CONTEXT-1 … CODE-CONTEXT-7.
    """
    loops = Loops(shape.closings)
    gates, after, before, counts = loops.gates, loops.after, loops.before, loops.count
    slots: dict[int, list[int]] = {}
    weights = [(WEIGHT,) * 5 for _ in range(4)]
    past = HISTORY - 1  # twelve times NONE
    for _ in range(count):
        if not gates:
            for p in (0, 0, 0, UNIT):
                yield p
            loops.undo(E)
            past = (6 * past + E) % HISTORY
            continue
        e = gates[-1]
        end, x = after[e], before[e]
        y, xx = after[end], before[x]
        small = 0 if y == x or x == end else 1 if y == xx else 2
        # Clamped without calls of `min`; all that follows is written for speed.
        a, b, c, z = counts[e], counts[end], counts[x], counts[xx]
        a = a if a < MOST else MOST
        b = b if b < MOST else MOST
        c = c if c < MOST else MOST
        z = z if z < MOST else MOST
        k0 = 5 * (48 * a + 3 * b + small)
        k1 = 5 * (16 * past + a) + 1
        k2 = 5 * (past % 1296) + 2
        k3 = 5 * (256 * a + loops.valences) + 3
        k4 = 5 * (6 * (256 * c + 16 * a + z) + past % 6) + 4
        f0 = slots.get(k0) or slots.setdefault(k0, [NEW] * 4)
        f1 = slots.get(k1) or slots.setdefault(k1, [NEW] * 4)
        f2 = slots.get(k2) or slots.setdefault(k2, [NEW] * 4)
        f3 = slots.get(k3) or slots.setdefault(k3, [NEW] * 4)
        f4 = slots.get(k4) or slots.setdefault(k4, [NEW] * 4)
        symbol = S
        for d in range(4):
            if d == C and small == 0:
                bit = yield 0
            elif d == E and not loops.can_split():
                bit = yield UNIT
            else:
                w0, w1, w2, w3, w4 = weights[d]
                v0, v1, v2, v3, v4 = f0[d], f1[d], f2[d], f3[d], f4[d]
                s0, s1, s2 = STRETCH[v0 >> 12], STRETCH[v1 >> 12], STRETCH[v2 >> 12]
                s3, s4 = STRETCH[v3 >> 12], STRETCH[v4 >> 12]
                total = w0 * s0 + w1 * s1 + w2 * s2 + w3 * s3 + w4 * s4 >> 16
                p = SQUASH[total + LAST if -LAST < total < LAST else 2 * LAST * (total > 0)]
                bit = yield p
                error = (UNIT if bit else 0) - p
                weights[d] = (
                    w0 + (s0 * error + HALF >> 15),
                    w1 + (s1 * error + HALF >> 15),
                    w2 + (s2 * error + HALF >> 15),
                    w3 + (s3 * error + HALF >> 15),
                    w4 + (s4 * error + HALF >> 15),
                )
                to = 65535 if bit else 0
                n0, n1, n2, n3, n4 = v0 & 255, v1 & 255, v2 & 255, v3 & 255, v4 & 255
                f0[d] = v0 + ((to - (v0 >> 8)) * RATE[n0] >> 16 << 8) + (n0 < OFTEN)
                f1[d] = v1 + ((to - (v1 >> 8)) * RATE[n1] >> 16 << 8) + (n1 < OFTEN)
                f2[d] = v2 + ((to - (v2 >> 8)) * RATE[n2] >> 16 << 8) + (n2 < OFTEN)
                f3[d] = v3 + ((to - (v3 >> 8)) * RATE[n3] >> 16 << 8) + (n3 < OFTEN)
                f4[d] = v4 + ((to - (v4 >> 8)) * RATE[n4] >> 16 << 8) + (n4 < OFTEN)
            if bit:
                symbol = d
                break
        loops.undo(symbol)
        past = (6 * past + symbol) % HISTORY
    while True:
        yield END


class Foretelling:
    """The decisions that are foretold, as a model that is used up as it is asked.

    A coder asks a model only forwards; each `after` spoils the one before. The law
    `context-definition` compares with a model that does not.
    """

    __slots__ = ("cumulative", "told")

    def __init__(self, count: int, shape: Shape) -> None:
        told = foretold(count, shape)
        self.cumulative = table(next(told))
        self.told = told.send

    def after(self, symbol: int) -> "Foretelling":
        """Itself, one decision later."""
        p = self.told(symbol)
        self.cumulative = (0, UNIT - p, UNIT) if p != END else (0,)  # `table`, written out
        return self


def table(p: int) -> tuple[int, ...]:
    """No, then yes. Clause: CODE-CONTEXT-1."""
    return (0,) if p == END else (0, UNIT - p, UNIT)


def encode(symbols: str, shape: Shape) -> Accepted[Bits] | Rejected:
    """The bits of the symbols, the last one first.

    Linear. Clauses: CODE-CONTEXT-1, CODE-CONTEXT-3.
    """
    stranger = next((i for i, x in enumerate(symbols) if x not in DECISIONS), None)
    if stranger is not None:
        return Rejected(Reason.NOT_IN_ALPHABET, Clause.CODE_CONTEXT_1, AtSymbol(stranger))
    decisions = [bit for symbol in reversed(symbols) for bit in DECISIONS[symbol]]
    found = coder.encode(Foretelling(len(symbols), shape), decisions)
    match found:
        case Rejected(reason, _, AtSymbol(index)):
            where = AtSymbol(_symbol_of(symbols, index))
            detail = "no loop of a surface lets this symbol be undone"
            return Rejected(reason, Clause.CODE_CONTEXT_3, where, detail)
        case _:
            return found


def _symbol_of(symbols: str, decision: int) -> int:
    """The symbol that a decision is about. Clause: CODE-CONTEXT-3."""
    index = len(symbols)
    while decision >= 0:
        index -= 1
        decision -= len(DECISIONS[symbols[index]])
    return index


def decode(bits: Bits, count: int, shape: Shape) -> Accepted[str] | Rejected:
    """The `count` symbols of these bits, and no others.

    Linear. Clauses: CODE-CONTEXT-1, CODE-CONTEXT-8.
    """
    decoded = coder.decode(Foretelling(count, shape), bits, 4 * count)
    if isinstance(decoded, Rejected):
        return decoded
    symbols: list[str] = []
    noes = 0
    for bit in decoded.value:
        noes += 1 - bit
        if bit or noes == 4:
            symbols.append(ORDER[noes])
            noes = 0
    return Accepted("".join(reversed(symbols)))


def most_symbols(bits: int) -> int:
    """No decision has more than 65514 of 65536, so it costs 1/2070 bit. Clause: CODE-NAME-3."""
    return 2070 * bits + 2


CODE: Final = Code(encode, decode, most_symbols, NOTHING)
