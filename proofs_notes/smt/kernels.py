"""No number of an inner loop leaves 64 bits, or its place: `python proofs_notes/smt/kernels.py`.

Compiled loops compute with integers of 64 bits, which wrap without a word. Here is shown, from the
clauses, that each number they compute is within. Floors are those of the clauses; `>>` of a number
of 64 bits is the floor of a division by a power of two.
Clauses: ARITH-NARROW-1, ARITH-DECODE-2, INFO-ENUM-6, CODE-CONTEXT-4 to CODE-CONTEXT-8,
CPLX-CORNER-3, GEOM-PREDICT-2, GEOM-RESIDUAL-1, GEOM-CODE-1, FILE-LIMIT-1. The note: kernels.md.
"""

import sys

from asking import Control, Lemma, main, signed64, within
from z3 import ULT, And, BitVec, If, Ints, LShR, Not

Q = 1 << 30
UNIT = 1 << 16

low, high, w, T, a, b, v, P, zeros, ones = Ints("low high w T a b v P zeros ones")
SETTLED = And(
    within(0, 4 * Q - 1, low, high), low < 2 * Q, 2 * Q <= high, Not(And(low >= Q, high < 3 * Q)),
    w == high - low + 1,
)  # fmt: skip
ANY = And(within(0, 4 * Q - 1, low, high), low <= high, w == high - low + 1)
SLOT = And(0 <= a, a < b, b <= T, T <= Q)
upper, corner, upwards = Ints("upper corner upwards")
EDGE = (1 << 32) * upper + 2 * corner + upwards
NO = w * (UNIT - P) / UNIT
URN = w * zeros / (zeros + ones)

p, k, R, y, t, W, n, error = Ints("p k R y t W n error")
TOWARDS = If(y == 1, UNIT - 1, 0)
LEARNT = p + (TOWARDS - p) * R / UNIT
SLOTTED = And(within(0, UNIT - 1, p), within(0, 255, k), within(0, 1, y), 1 <= R, 3 * R <= 2 * UNIT)
STEP = (t * error + (1 << 14)) / (1 << 15)
REACHED = (1 << 14) + 4096 * n
LOGIT = within(-2047, 2047, t)
ERROR = within(-UNIT, UNIT, error)
DECISIONS = 1 << 28
W0, W1, W2, W3, W4 = WEIGHTS = Ints("W0 W1 W2 W3 W4")
GREATEST = (1 << 14) + 4096 * DECISIONS
past, symbol, count, number, mixed = Ints("past symbol count number mixed")
KEY = 16 * past + count
PAST = And(0 <= past, past < 6**12, within(0, 15, count))
word = BitVec("word", 64)

N, qa, qb, qo, index, r, z, foretold = Ints("N qa qb qo index r z foretold")
BOX = And(0 <= N, N < 1 << 30)
PREDICTED = foretold == If(qa + qb - qo < 0, 0, If(qa + qb - qo > N, N, qa + qb - qo))
FOLDED = If(r >= 0, 2 * r, -2 * r - 1)

LEMMAS = (
    Lemma(
        "narrowing-fits", "narrowing and searching compute numbers of 64 bits with sign",
        (SETTLED, SLOT, low <= v, v <= high),
        signed64(w * a, w * b, (v - low + 1) * T - 1, low + w * b / T),
    ),
    Lemma(
        "shifting-fits", "so does shifting, from any state",
        (ANY, low <= v, v <= high), signed64(2 * high + 1, 2 * v + 1),
    ),
    Lemma(
        "both-parts", "a decision of CODE-CONTEXT-8 leaves something for no and for yes",
        (SETTLED, 22 <= P, P <= 65514), And(1 <= NO, NO <= w - 1),
    ),
    Lemma(
        "both-lots", "an urn with both kinds leaves something for each",
        (SETTLED, 1 <= zeros, 1 <= ones, zeros + ones <= Q), And(1 <= URN, URN <= w - 1),
    ),
    Lemma(
        "edges-pack", "an edge in one number: its upper end, its corner and its direction",
        (within(0, 2 * Q - 1, upper, corner), within(0, 1, upwards)),
        And(
            signed64(EDGE), EDGE / (1 << 32) == upper,
            EDGE % (1 << 32) / 2 == corner, EDGE % 2 == upwards,
        ),
    ),
    Lemma(
        "slot-stays", "a slot's probability stays one of 0 … 65535",
        (SLOTTED,), within(0, UNIT - 1, LEARNT),
    ),
    Lemma(
        "slot-packs", "256·p + k in one number is taken apart again",
        (within(0, UNIT - 1, p), within(0, 255, k)),
        And((256 * p + k) / 256 == p, (256 * p + k) % 256 == k, 256 * p + k < 1 << 24),
    ),
    Lemma(
        "slot-fits", "learning a slot computes numbers of 64 bits",
        (SLOTTED,), signed64((TOWARDS - p) * R, 256 * (TOWARDS - p) * R),
    ),
    Lemma(
        "weight-step", "a decision changes a weight by at most 4096",
        (LOGIT, ERROR), within(-4096, 4096, STEP),
    ),
    Lemma(
        "weight-bound", "so after n decisions it is at most 2^14 + 4096 n from 0",
        (LOGIT, ERROR, 0 <= n, within(-4096, 4096, STEP), -REACHED <= W, W <= REACHED),
        And(-REACHED - 4096 <= W + STEP, W + STEP <= REACHED + 4096),
    ),
    Lemma(
        "mixing-product", "a weight of 2^28 decisions times a logit is below 2^52",
        (within(-GREATEST, GREATEST, W), LOGIT), within(-(1 << 52), 1 << 52, W * t),
    ),
    Lemma(
        "mixing-fits", "five of them are of 64 bits, added up in any order",
        tuple(within(-(1 << 52), 1 << 52, product) for product in WEIGHTS),
        signed64(W0, W0 + W1, W0 + W1 + W2, W0 + W1 + W2 + W3, W0 + W1 + W2 + W3 + W4),
    ),
    Lemma(
        "past-stays", "twelve symbols stay a number below 6^12",
        (PAST, within(0, 5, symbol)), within(0, 6**12 - 1, (6 * past + symbol) % 6**12),
    ),
    Lemma(
        "key-bound", "what is known of twelve symbols and a count is below 2^36",
        (PAST,), And(0 <= KEY, KEY < 1 << 36),
    ),
    Lemma(
        "spread-stays", "its exclusive or with its own upper digits is below 2^36",
        (ULT(word, 1 << 36),), ULT(word ^ LShR(word, 18), 1 << 36),
    ),
    Lemma(
        "spread-fits", "and that times 94906267 has 64 bits with sign",
        (0 <= mixed, mixed < 1 << 36), signed64(mixed * 94906267),
    ),
    Lemma(
        "mark-fits", "what of this is above the lower 56 digits fits seven bits",
        (0 <= mixed, mixed < 1 << 36), within(0, 127, mixed * 94906267 / (1 << 24) / (1 << 32)),
    ),
    Lemma(
        "slots-fit", "the number of a slot has 32 bits with sign",
        (0 <= number, number < 1 << 26), within(0, (1 << 31) - 1, 4 * (30736 + number) + 3),
    ),
    Lemma(
        "prediction-fits", "q_a + q_b - q_o has 32 bits with sign, and the residual has",
        (BOX, within(0, N, qa, qb, qo, index), PREDICTED),
        And(within(-(1 << 31), (1 << 31) - 1, qa + qb - qo), within(-N, N, index - foretold)),
    ),
    Lemma(
        "fold-bound", "a folded residual is at most 2N, so its class is one of the model's",
        (BOX, within(-N, N, r)), within(0, 2 * N, FOLDED),
    ),
    Lemma(
        "fold-back", "folding is undone by the last digit, and every number is a fold",
        (z == FOLDED,), And(z >= 0, r == If(z % 2 == 0, z / 2, -(z + 1) / 2)),
    ),
    Lemma(
        "lattice-index", "an index computed from lattice numbers below 2^53 has 64 bits with sign",
        (within(-(1 << 53) + 1, (1 << 53) - 1, qa, qb), within(0, (1 << 30) - 1, qb - qa)),
        signed64(qb - qa, qa + (qb - qa)),
    ),
)  # fmt: skip

CONTROLS = (
    Control(
        "narrowing-fits-32", "32 bits are enough for narrowing",
        (SETTLED, SLOT), w * b < 1 << 32,
    ),
    Control(
        "narrowing-fits-any-total", "any total fits",
        (SETTLED, 0 <= a, a < b, b <= T), signed64(w * b),
    ),
    Control(
        "both-parts-extreme", "a decision may have P up to 65536",
        (SETTLED, 22 <= P, P <= UNIT), And(1 <= NO, NO <= w - 1),
    ),
    Control(
        "both-lots-great", "an urn may hold any number",
        (SETTLED, 1 <= zeros, 1 <= ones), And(1 <= URN, URN <= w - 1),
    ),
    Control(
        "slot-rate", "a slot stays in its place at any rate",
        (within(0, UNIT - 1, p), within(0, 1, y), 1 <= R), within(0, UNIT - 1, LEARNT),
    ),
    Control(
        "weight-step-less", "a decision changes a weight by at most 4093",
        (LOGIT, ERROR), within(-4093, 4093, STEP),
    ),
    Control(
        "mixing-fits-32", "five products have 32 bits",
        tuple(within(-(1 << 52), 1 << 52, product) for product in WEIGHTS),
        within(-(1 << 31), (1 << 31) - 1, W0 + W1 + W2 + W3 + W4),
    ),
    Control(
        "mark-fits-6", "what is above the lower 56 digits fits six bits",
        (0 <= mixed, mixed < 1 << 36), within(0, 63, mixed * 94906267 / (1 << 24) / (1 << 32)),
    ),
    Control(
        "spread-stays-34", "the exclusive or is below 2^34",
        (ULT(word, 1 << 36),), ULT(word ^ LShR(word, 18), 1 << 34),
    ),
    Control(
        "prediction-unmoved", "without moving it into the box the residual has at most N",
        (BOX, within(0, N, qa, qb, qo, index)), within(-N, N, index - (qa + qb - qo)),
    ),
    Control(
        "fold-tighter", "a folded residual is below 2N",
        (BOX, within(-N, N, r), N >= 1), FOLDED < 2 * N,
    ),
)  # fmt: skip

if __name__ == "__main__":
    sys.exit(main((*LEMMAS, *CONTROLS)))
