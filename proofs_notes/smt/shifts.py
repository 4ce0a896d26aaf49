"""All shifts of a symbol at once are those one by one: `python proofs_notes/smt/shifts.py`.

The kernel counts the leading bits that both ends of a state share, and then the ones below the
first other bit of the lower end that are zeros in the higher one; it shifts by both counts at once.
Here is shown that one shift of ARITH-SHIFT-1 and then all at once is all at once, with one more
counted: by induction the shifts one after another lead to the same state, and the value as far
above its lower end, but for the bits that are read, which are added below.
Clauses: ARITH-SHIFT-1, ARITH-SHIFT-2, ARITH-DECODE-3. The note: kernels.md.
"""

import sys

from asking import Control, Lemma, main
from z3 import UGE, ULE, ULT, And, BitVec, BitVecRef, BitVecVal, BoolRef, If, LShR, Not

WIDE = 64
low, high, v = (BitVec(name, WIDE) for name in ("low", "high", "v"))
Q = 1 << 30
HALF, TOP = 2 * Q, 4 * Q - 1
STATE = And(ULE(low, v), ULE(v, high), ULE(high, TOP))


def bit_length(number: BitVecRef) -> BitVecRef:
    """How many bits a number below 2^32 has without leading zeros."""
    found = BitVecVal(0, WIDE)
    for place in range(32):
        found = If(LShR(number, place) & 1 == 1, BitVecVal(place + 1, WIDE), found)
    return found


def at_once(low: BitVecRef, high: BitVecRef, v: BitVecRef) -> tuple[BitVecRef, ...]:
    """What the kernel makes of a state and a value: both counts, both ends, value less low end."""
    shared = 32 - bit_length(low ^ high)
    other = (high | ~low) & LShR(BitVecVal(TOP, WIDE), shared + 1)
    left = 31 - shared - bit_length(other)
    central = If(left < 0, BitVecVal(0, WIDE), left)
    count = shared + central
    mask = LShR(BitVecVal(TOP, WIDE), count + 1)
    below = (low & mask) << count
    return shared, central, below, below + (high - low + 1 << count) - 1, (v - low) << count


def same(one: tuple[BitVecRef, ...], other: tuple[BitVecRef, ...]) -> BoolRef:
    """All of one as all of the other."""
    return And(*(a == b for a, b in zip(one, other, strict=True)))


SHARED, CENTRAL, *ENDS = at_once(low, high, v)
LOWER, HIGHER = ULT(high, HALF), UGE(low, HALF)
MIDDLE = And(Not(LOWER), Not(HIGHER), UGE(low, Q), ULT(high, 3 * Q))


def after(away: int) -> tuple[BitVecRef, ...]:
    """One shift, then all at once."""
    return at_once(2 * (low - away), 2 * (high - away) + 1, 2 * (v - away))


LEMMAS = (
    Lemma(
        "lower-at-once", "a shift of the lower half and then all at once is all at once",
        (STATE, LOWER), same(after(0), (SHARED - 1, CENTRAL, *ENDS)),
    ),
    Lemma(
        "higher-at-once", "so is one of the higher half",
        (STATE, HIGHER), same(after(HALF), (SHARED - 1, CENTRAL, *ENDS)),
    ),
    Lemma(
        "central-at-once", "so is one of the central half, and no half's comes with it",
        (STATE, MIDDLE), And(SHARED == 0, same(after(Q), (SHARED, CENTRAL - 1, *ENDS))),
    ),
    Lemma(
        "settled-at-once", "nothing is done to a settled state",
        (STATE, Not(LOWER), Not(HIGHER), Not(MIDDLE)),
        same(at_once(low, high, v), (BitVecVal(0, WIDE), BitVecVal(0, WIDE), low, high, v - low)),
    ),
    Lemma(
        "at-most-32-at-once", "both counts together are at most 32",
        (STATE,), ULE(SHARED + CENTRAL, 32),
    ),
)  # fmt: skip

CONTROLS = (
    Control(
        "one-central-at-once", "one central shift at most",
        (STATE,), ULE(CENTRAL, 1),
    ),
    Control(
        "at-most-31-at-once", "31 shifts are always enough",
        (STATE,), ULE(SHARED + CENTRAL, 31),
    ),
)  # fmt: skip

if __name__ == "__main__":
    sys.exit(main((*LEMMAS, *CONTROLS)))
