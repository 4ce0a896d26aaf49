"""Section 3(b) of the tutorial as printed: Algorithms 1 and 2 over exact fractions."""

from collections.abc import Sequence
from fractions import Fraction
from typing import Final

Interval = tuple[Fraction, Fraction]

HALF: Final = Fraction(1, 2)
MANY: Final = 64
"""So many scalings of one symbol show that the loop never ends."""


def slot(probabilities: Sequence[Fraction], symbol: int) -> Interval:
    """Algorithm 2, line 5: `I ← [Σ p_k, Σ p_k)`; the interval before is forgotten."""
    low = sum(probabilities[:symbol], Fraction(0))
    return low, low + probabilities[symbol]


def encode(probabilities: Sequence[Fraction], message: Sequence[int]) -> tuple[str, list[Interval]]:
    """Algorithm 2, lines 3 to 16: the bits, and the intervals; at most MANY scalings a symbol."""
    bits, pending, passed = "", 0, list[Interval]()
    for symbol in message:
        low, high = slot(probabilities, symbol)
        passed.append((low, high))
        for _ in range(MANY):
            if low <= HALF < high and high - low >= HALF:  # `while ½ ∉ I or |I| < ½`
                break
            away = Fraction(0)
            if high <= HALF:
                bits, pending = bits + "0" + "1" * pending, 0
            elif low >= HALF and high <= 1:
                bits, pending, away = bits + "1" + "0" * pending, 0, HALF
            elif low >= HALF / 2 and high <= 3 * HALF / 2:
                pending, away = pending + 1, HALF / 2
            low, high = 2 * (low - away), 2 * (high - away)
            passed.append((low, high))
    return bits, passed


def decode_one(probabilities: Sequence[Fraction], m: Fraction) -> tuple[int, Interval]:
    """Algorithm 1, lines 5 to 11: the symbol (counted from 1) and the interval."""
    count, i = probabilities[0], 1
    for i in range(2, len(probabilities) + 1):
        if m < count:
            break
        count += probabilities[i - 1]
    return i, (count - probabilities[i - 2], count)
