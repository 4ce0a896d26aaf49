"""The range coder and rANS step by step: `python proofs_notes/smt/bytewise.py`.

Numbers are those of the clauses: totals up to 2^30, states of 56 bits. Every number that a step
computes is one of 64 bits without sign, as `uint64_t` has it.
Clauses: ARITH-RANGE-1 to ARITH-RANGE-7, ARITH-RANS-1 to ARITH-RANS-5. The note: bytewise-coders.md.
"""

import sys

from asking import Control, Lemma, main, unsigned64
from z3 import And, If, Ints

low, size, T, c, e, r, code, v, d, held, rest = Ints("low size T c e r code v d held rest")
M = 1 << 30
BOTTOM, WHOLE = 1 << 48, 1 << 56

TABLE = And(1 <= T, T <= M, 0 <= c, c < e, e <= T)
RANGE = And(0 <= low, 0 < size, low + size <= 1 << 57)
SETTLED = And(RANGE, BOTTOM < size, size <= WHOLE)
UNIT = r == size / T
NARROWED = If(e == T, size - r * c, r * (e - c))
TARGET = If(code / r < T - 1, code / r, T - 1)
IN_SLOT = And(r * c <= code, If(e == T, code < size, code < r * e))
ONE = And(v * (1 << 40) >= low, v * (1 << 40) < low + (1 << 40))

x, y, F, C, q, s = Ints("x y F C q s")
STATE = And(BOTTOM <= x, x < WHOLE)
PART = And(1 <= F, 0 <= C, C + F <= M)
PUSHED = M * q + C + s
SPLIT = And(y == F * q + s, 0 <= s, s < F, 0 <= q)

LEMMAS = (
    Lemma(
        "range-unit", "the unit of a settled state is at least 2^18",
        (SETTLED, TABLE, UNIT), r >= 1 << 18,
    ),
    Lemma(
        "range-narrows", "a slot's part is not empty and lies in the state",
        (SETTLED, TABLE, UNIT), And(NARROWED >= 1, r * c + NARROWED <= size),
    ),
    Lemma(
        "range-covers", "the next slot begins where a slot ends, and the last ends with the state",
        (SETTLED, TABLE, UNIT), r * c + NARROWED == If(e == T, size, r * e),
    ),
    Lemma(
        "range-four-shifts", "four shifts settle what narrowing leaves",
        (SETTLED, TABLE, UNIT), NARROWED * (1 << 32) > BOTTOM,
    ),
    Lemma(
        "range-digit", "a digit is from 0 to 511",
        (RANGE, size <= BOTTOM), And(0 <= low / BOTTOM, low / BOTTOM <= 511),
    ),
    Lemma(
        "range-shift-stays", "after a shift low < 2^56, and low + range ≤ 2^57",
        (RANGE, size <= BOTTOM),
        And(256 * (low % BOTTOM) < WHOLE, 256 * (low % BOTTOM) + 256 * size <= 1 << 57),
    ),
    Lemma(
        "range-place-stays", "a shift does not move the place: sum and low together, 256 times",
        (RANGE, size <= BOTTOM, d == low / BOTTOM, 0 <= v),
        (256 * v + d) * WHOLE + 256 * (low % BOTTOM) == 256 * (v * WHOLE + low),
    ),
    Lemma(
        "range-search", "the search finds the slot that the code lies in",
        (SETTLED, TABLE, UNIT, 0 <= code, code < size), And(c <= TARGET, TARGET < e) == IN_SLOT,
    ),
    Lemma(
        "range-code-stays", "the code stays below the range when both narrow",
        (SETTLED, TABLE, UNIT, 0 <= code, code < size, IN_SLOT),
        And(0 <= code - r * c, code - r * c < NARROWED),
    ),
    Lemma(
        "range-code-shifts", "and when both shift, whatever byte comes",
        (0 <= code, code < size, size <= BOTTOM, 0 <= d, d <= 255),
        And(0 <= 256 * code + d, 256 * code + d < 256 * size),
    ),
    Lemma(
        "range-end", "the two last digits name a part of the state",
        (SETTLED, ONE), And(low <= v * (1 << 40), (v + 1) * (1 << 40) <= low + size),
    ),
    Lemma(
        "range-end-is-seen", "the bytes are the encoder's exactly if (low + code) / 2^40 is v",
        (SETTLED, ONE, 0 <= code, code < size),
        ((low + code) / (1 << 40) == v)
        == And(v * (1 << 40) <= low + code, low + code < (v + 1) * (1 << 40)),
    ),
    Lemma(
        "range-carry", "a carry added to the held byte leaves the number as it is",
        (0 <= held, held < 255, 0 <= d, d <= 511, d != 255, 0 <= rest),
        (256 * (rest + held) + d)
        == 256 * (rest + held + d / 256) + d % 256,
    ),
    Lemma(
        "range-carry-fits", "and the held byte takes the carry",
        (0 <= held, held < 255, 0 <= d, d <= 511), held + d / 256 <= 255,
    ),
    Lemma(
        "range-fits", "all that a step of the range coder computes has 64 bits",
        (SETTLED, TABLE, UNIT, 0 <= code, code < size, 0 <= d, d <= 255),
        unsigned64(r * c, r * e, low + r * c, size - r * c, low + code, low + (1 << 40)),
    ),
    Lemma(
        "rans-stretched", "a stretched slot has at least 1, and slots follow one another",
        (TABLE,), And(M * c / T + 1 <= M * e / T, M * e / T <= M, M * T / T == M),
    ),
    Lemma(
        "rans-search", "the search among slots is the one among stretched slots",
        (TABLE, 0 <= y, y < M), (c <= ((y + 1) * T - 1) / M) == (M * c / T <= y),
    ),
    Lemma(
        "rans-pushed", "pushing onto y below 2^26 F and at least 2^18 F gives a state",
        (PART, SPLIT, (1 << 18) * F <= y, y < (1 << 26) * F),
        And(BOTTOM <= PUSHED, PUSHED < WHOLE),
    ),
    Lemma(
        "rans-pushed-less", "and onto no other y",
        (PART, SPLIT, BOTTOM <= PUSHED, PUSHED < WHOLE),
        And((1 << 18) * F <= y, y < (1 << 26) * F),
    ),
    Lemma(
        "rans-pop", "popping finds the part pushed and what it was pushed with",
        (PART, 0 <= s, s < F, 0 <= q),
        And(PUSHED % M == C + s, PUSHED / M == q),
    ),
    Lemma(
        "rans-pop-back", "and so what it was pushed onto, which is split in one way",
        (PART, SPLIT), And(F * q + (C + s) - C == y, C <= C + s, C + s < C + F),
    ),
    Lemma(
        "rans-send", "before a byte is sent the state is at least 2^26 F, after it at least 2^18 F",
        (PART, (1 << 26) * F <= x), x / 256 >= (1 << 18) * F,
    ),
    Lemma(
        "rans-sends-nothing", "a state below 2^26 F may be pushed onto without a byte sent",
        (PART, STATE, x < (1 << 26) * F), (1 << 18) * F <= x,
    ),
    Lemma(
        "rans-sent-is-read", "a byte that was sent brings a number below 2^48 back",
        (STATE,), And(x / 256 < BOTTOM, 256 * (x / 256) + x % 256 == x),
    ),
    Lemma(
        "rans-four-bytes", "a push sends at most four bytes",
        (STATE, PART), x / (1 << 32) < (1 << 26) * F,
    ),
    Lemma(
        "rans-fits", "all that a push and a pop compute has 64 bits",
        (STATE, PART, TABLE, 0 <= y, y < M),
        unsigned64((1 << 26) * F, M * (x / M) + y, (y + 1) * T - 1, M * c, 256 * BOTTOM + 255),
    ),
)  # fmt: skip

CONTROLS = (
    Control(
        "range-without-rest", "units alone cover the state",
        (SETTLED, TABLE, UNIT), r * T == size,
    ),
    Control(
        "range-three-shifts", "three shifts settle what narrowing leaves",
        (SETTLED, TABLE, UNIT), NARROWED * (1 << 24) > BOTTOM,
    ),
    Control(
        "range-digit-is-byte", "a digit is below 256, so that nothing is carried",
        (RANGE, size <= BOTTOM), low / BOTTOM <= 255,
    ),
    Control(
        "range-unlimited", "the search needs no limit T - 1",
        (SETTLED, TABLE, UNIT, 0 <= code, code < size, IN_SLOT), And(c <= code / r, code / r < e),
    ),
    Control(
        "range-one-digit-more", "two last digits name a part of unsettled states too",
        (RANGE, ONE), (v + 1) * (1 << 40) <= low + size,
    ),
    Control(
        "held-255", "a held byte of 255 takes a carry",
        (0 <= held, held <= 255, 0 <= d, d <= 511), held + d / 256 <= 255,
    ),
    Control(
        "rans-unstretched", "a total of 3·2^28, which does not divide 2^48, leads to states too",
        (1 <= F, 0 <= C, C + F <= 3 << 28, SPLIT, BOTTOM // (3 << 28) * F <= y),
        (3 << 28) * q + C + s >= BOTTOM,
    ),
    Control(
        "rans-part-outside", "a part beyond M comes back",
        (1 <= F, 0 <= C, 0 <= s, s < F, 0 <= q), PUSHED % M == C + s,
    ),
    Control(
        "rans-sends-too-late", "bytes may be sent from 2^27 F on",
        (PART, SPLIT, (1 << 18) * F <= y, y < (1 << 27) * F), PUSHED < WHOLE,
    ),
    Control(
        "rans-three-bytes", "a push sends at most three bytes",
        (STATE, PART), x / (1 << 24) < (1 << 26) * F,
    ),
    Control(
        "range-fits-32", "32 bits are enough",
        (SETTLED, TABLE, UNIT), r * c < 1 << 32,
    ),
)  # fmt: skip

if __name__ == "__main__":
    sys.exit(main((*LEMMAS, *CONTROLS)))
