"""The nearest lattice number in binary64: `python proofs_notes/smt/lattice.py`.

The first lemmas are about all finite numbers of binary64, bit by bit, with IEEE's rounding to
nearest, ties to even. Rounding down tells the truth about a half: it is monotone and keeps 1/2.
Clauses: GEOM-LATTICE-2, GEOM-LATTICE-5 to GEOM-LATTICE-7. The note: geometry.md.
"""

import sys

from asking import Control, Lemma, main
from z3 import (
    FP,
    RNE,
    RTN,
    RTP,
    And,
    Float64,
    FPVal,
    If,
    Int,
    Not,
    Q,
    Real,
    ToInt,
    ToReal,
    fpAdd,
    fpEQ,
    fpGEQ,
    fpIsInf,
    fpIsNaN,
    fpLT,
    fpRoundToIntegral,
    fpSub,
)

y = FP("y", Float64())
FINITE = And(Not(fpIsNaN(y)), Not(fpIsInf(y)))
f = fpRoundToIntegral(RTN(), y)
HALF = FPVal(0.5, Float64())
SAID = fpGEQ(fpSub(RNE(), y, f), HALF)
SO = fpGEQ(fpSub(RTN(), y, f), HALF)

x = Real("x")
k = Int("k")
NEAREST = ToInt(x + Q(1, 2))

LEMMAS = (
    Lemma(
        "half-is-seen", "y - ⌊y⌋ ≥ 1/2 in binary64 exactly if it is so",
        (FINITE,), SAID == SO,
    ),
    Lemma(
        "floor-is-below", "⌊y⌋ is a number of binary64, and y - ⌊y⌋ is not negative",
        (FINITE,), And(Not(fpIsInf(f)), fpGEQ(y, f)),
    ),
    Lemma(
        "half-up-is-nearest", "⌊x⌋ + 1 if x - ⌊x⌋ ≥ 1/2, and otherwise ⌊x⌋, is ⌊x + 1/2⌋",
        (), If(x - ToReal(ToInt(x)) >= Q(1, 2), ToInt(x) + 1, ToInt(x)) == NEAREST,
    ),
    Lemma(
        "nearest-is-near", "⌊x + 1/2⌋ is at most 1/2 away from x",
        (), And(x - ToReal(NEAREST) <= Q(1, 2), ToReal(NEAREST) - x <= Q(1, 2)),
    ),
    Lemma(
        "whole-is-kept", "a whole number is its own nearest",
        (x == ToReal(k),), NEAREST == k,
    ),
)  # fmt: skip

CONTROLS = (
    Control(
        "adding-half-first", "y below 1/2 stays below 1 when 1/2 is added: ⌊y + 1/2⌋ will do",
        (fpLT(y, HALF), fpGEQ(y, FPVal(0.0, Float64()))),
        fpLT(fpAdd(RNE(), y, HALF), FPVal(1.0, Float64())),
    ),
    Control(
        "difference-is-exact", "y - ⌊y⌋ is a number of binary64",
        (FINITE,), fpEQ(fpSub(RTN(), y, f), fpSub(RTP(), y, f)),
    ),
    Control(
        "nearest-is-nearer", "⌊x + 1/2⌋ is less than 1/2 away from x",
        (), And(x - ToReal(NEAREST) < Q(1, 2), ToReal(NEAREST) - x < Q(1, 2)),
    ),
)  # fmt: skip

if __name__ == "__main__":
    sys.exit(main((*LEMMAS, *CONTROLS)))
