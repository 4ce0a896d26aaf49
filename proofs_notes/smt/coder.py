"""The integer coder of chapter 2, for every precision at once: `python proofs_notes/smt/coder.py`.

Q is any integer from 1 on; the clauses have Q = 2^30. The state is low … high within 0 … 4Q - 1, a
slot is a, b, T. What doubles with each pending bit, 2^k, is any integer P from 1 on.
Clauses: ARITH-STATE-2, ARITH-NARROW-2, ARITH-SHIFT-1, ARITH-CARRY-1, ARITH-END-1, ARITH-DECODE-2,
ARITH-STRICT-1. The notes: arithmetic-coder.md.
"""

import sys

from asking import Control, Lemma, main
from z3 import And, Implies, Ints, Not, Or

Q, low, high, w, T, a, b, v, t, bit = Ints("Q low high w T a b v t bit")
H, TOP = 2 * Q, 4 * Q - 1

SETTLED = And(Q >= 1, 0 <= low, low < H, H <= high, high <= TOP, Not(And(low >= Q, high < 3 * Q)))
STATE = And(Q >= 1, 0 <= low, low <= high, high <= TOP)
SLOT = And(0 <= a, a < b, b <= T)
WIDTH = w == high - low + 1

# What each case of ARITH-SHIFT-1 asks for, in turn, and takes away.
LOWER = high < H
HIGHER = And(Not(LOWER), low >= H)
CENTRAL = And(Not(LOWER), Not(HIGHER), low >= Q, high < 3 * Q)
CASES = {"lower": (LOWER, 0), "higher": (HIGHER, H), "central": (CENTRAL, Q)}
away = Ints("away")[0]
SHIFTED = Or(*(And(case, away == number) for case, number in CASES.values()))
low2, high2, v2 = 2 * (low - away), 2 * (high - away) + 1, 2 * (v - away) + bit

# Carrying: base, the number B of the bits sent, and P = 2^k for k pending bits.
base, B, P, x, D = Ints("base B P x D")
CARRY = And(Q >= 1, P >= 1, base == 4 * Q * P * B + 2 * Q * (P - 1))
AT_END = And(SETTLED, Or(And(low < Q, x == Q), And(low >= Q, x == 2 * Q)))

LEMMAS = (
    Lemma(
        "settled-is-wide", "a settled state has at least Q + 2 integers",
        (SETTLED, WIDTH), w >= Q + 2,
    ),
    Lemma(
        "shifts-stay", "a shift leads to a state again",
        (STATE, SHIFTED), And(0 <= low2, low2 <= high2, high2 <= TOP),
    ),
    Lemma(
        "shifts-double", "a shift doubles the width",
        (STATE, SHIFTED), high2 - low2 + 1 == 2 * (high - low + 1),
    ),
    Lemma(
        "unshiftable-is-settled", "a state without a case is settled, and no other is",
        (STATE,), SETTLED == Not(Or(LOWER, HIGHER, CENTRAL)),
    ),
    Lemma(
        "value-stays", "a shift keeps the value in the state",
        (STATE, SHIFTED, low <= v, v <= high, 0 <= bit, bit <= 1), And(low2 <= v2, v2 <= high2),
    ),
    Lemma(
        "ends-rise", "in a state of width T or more, slots' ends are at least 1 apart",
        (1 <= T, T <= w, SLOT), w * a / T + 1 <= w * b / T,
    ),
    Lemma(
        "first-end", "the first slot begins where the state does",
        (1 <= T, 0 <= w), w * 0 / T == 0,
    ),
    Lemma("last-end", "the last slot ends where the state does", (1 <= T, 0 <= w), w * T / T == w),
    Lemma(
        "total-may-be-wide", "a total of Q + 2 is not too much for any settled state",
        (SETTLED, WIDTH, T <= Q + 2, 1 <= T, SLOT), w * a / T + 1 <= w * b / T,
    ),
    Lemma(
        "search-finds", "the search's number lies in a slot exactly if the value does",
        (1 <= T, 1 <= w, 0 <= t, t < w, 0 <= a, a <= T),
        (w * a / T <= t) == (a <= ((t + 1) * T - 1) / w),
    ),
    Lemma(
        "search-is-below-total", "the search's number is one of 0 … T - 1",
        (1 <= T, 1 <= w, 0 <= t, t < w),
        And(0 <= ((t + 1) * T - 1) / w, ((t + 1) * T - 1) / w < T),
    ),
    Lemma(
        "carry-central", "a central half keeps base = 4Q·2^k·B + 2Q(2^k - 1), one more pending",
        (CARRY,), 2 * (base + Q) == 4 * Q * (2 * P) * B + 2 * Q * (2 * P - 1),
    ),
    Lemma(
        "carry-lower", "sending 0 and the pending ones keeps it, with none pending",
        (CARRY,), 2 * base == 4 * Q * (2 * P * B + (P - 1)),
    ),
    Lemma(
        "carry-higher", "sending 1 and the pending zeros keeps it, with none pending",
        (CARRY,), 2 * (base + 2 * Q) == 4 * Q * (2 * P * B + P),
    ),
    Lemma(
        "ending-is-carried", "the ending's bits are the digits of (base + q) / Q",
        (CARRY, Or(And(low < Q, x == Q, D == 4 * P * B + 2 * P - 1),
                   And(low >= Q, x == 2 * Q, D == 4 * P * B + 2 * P))),
        D * Q == base + x,
    ),
    Lemma(
        "ending-lies-inside", "the quarter that the ending names lies in the settled state",
        (AT_END,), And(low <= x, x + Q - 1 <= high),
    ),
    Lemma(
        "ending-is-seen", "the value is in the ending's quarter exactly if v / Q says so",
        (AT_END, low <= v, v <= high), And(x <= v, v < x + Q) == (v / Q == x / Q),
    ),
    Lemma(
        "length-factor", "narrowing misses the exact part by less than one: below",
        (1 <= T, T <= w, SLOT), (w * b / T - w * a / T) * T >= w * (b - a) - (T - 1),
    ),
    Lemma(
        "length-factor-above", "narrowing misses the exact part by less than one: above",
        (1 <= T, T <= w, SLOT), (w * b / T - w * a / T) * T <= w * (b - a) + (T - 1),
    ),
    Lemma(
        "two-parts", "of two parts the search finds the one that a comparison of the value finds",
        (1 <= T, 1 <= w, 0 <= t, t < w, 0 <= a, a <= T),
        ((t + 1) * T - 1 >= w * a) == (t >= w * a / T),
    ),
)  # fmt: skip

CONTROLS = (
    Control(
        "narrow-state", "slots' ends rise in states narrower than T too",
        (1 <= T, 1 <= w, SLOT), w * a / T + 1 <= w * b / T,
    ),
    Control(
        "total-too-wide", "a total of Q + 3 is not too much",
        (SETTLED, WIDTH, T == Q + 3, SLOT), w * a / T + 1 <= w * b / T,
    ),
    Control(
        "wider-still", "a settled state has at least Q + 3 integers",
        (SETTLED, WIDTH), w >= Q + 3,
    ),
    Control(
        "search-without-one", "the search finds the slot with t·T / w too",
        (1 <= T, T <= w, 0 <= t, t < w, 0 <= a, a <= T), (w * a / T <= t) == (a <= t * T / w),
    ),
    Control(
        "central-unasked", "the central half may be taken without low ≥ Q",
        (STATE, Not(LOWER), high < 3 * Q), 2 * (low - Q) >= 0,
    ),
    Control(
        "ending-always-low", "the second quarter lies in every settled state",
        (SETTLED,), And(low <= Q, 2 * Q - 1 <= high),
    ),
    Control(
        "floors-are-exact", "narrowing gives the exact part",
        (1 <= T, T <= w, SLOT), (w * b / T - w * a / T) * T == w * (b - a),
    ),
    Control(
        "pending-forgotten", "the central half keeps the number with nothing pending",
        (CARRY,), Implies(P == 1, 2 * (base + Q) == 4 * Q * (2 * B)),
    ),
)  # fmt: skip

if __name__ == "__main__":
    sys.exit(main((*LEMMAS, *CONTROLS)))
