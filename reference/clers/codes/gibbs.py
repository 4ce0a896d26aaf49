"""Tables that cost the least in the worst case: those of a Gibbs measure, in whole numbers.

Give each symbol a weight and each context what follows from it, the eigenvector of the weighted
steps: then all words with the same counts cost the same, but for their ends. The weights are right
where half of the symbols are C, and S as frequent as E, as on spheres.

Only + − × ÷ and the square root are used, so that every machine finds the same numbers.
"""

from dataclasses import dataclass
from math import sqrt
from typing import Final

from clers.codes.factor_contexts import NOWHERE
from clers.edgebreaker.stream import SYMBOLS

ROUNDS: Final = 400
"""Rounds of correcting the weights; some eighty are enough."""

Successors = tuple[tuple[int, ...], ...]


@dataclass(frozen=True, slots=True)
class Gibbs:
    """The weights of C and of S (E has its inverse, L and R 1), and the eigenvector and -value."""

    creation: float
    split: float
    symbol: float
    potential: tuple[float, ...]


def weights(creation: float, split: float) -> tuple[float, ...]:
    """The weight of each symbol, in the order C, L, E, R, S."""
    return creation, 1.0, 1 / split, 1.0, split


def gibbs(successors: Successors) -> Gibbs:
    """The Gibbs measure of spheres on some contexts. Clause: CODE-MINIMAX-2."""
    size = len(successors)
    steps = [(q, s, r) for q, row in enumerate(successors) for s, r in enumerate(row) if r >= 0]
    creation, split, symbol = 4.0, 1.0, 8.0
    ahead, behind = [1.0] * size, [1.0] * size
    for turn in range(ROUNDS):
        of = weights(creation, split)
        for _ in range(3):
            new_ahead, new_behind = [0.0] * size, [0.0] * size
            for q, s, r in steps:
                new_ahead[q] += of[s] * ahead[r]
                new_behind[r] += of[s] * behind[q]
            ahead = [x / max(new_ahead) for x in new_ahead]
            behind = [x / max(new_behind) for x in new_behind]
        share = [0.0] * len(SYMBOLS)
        for q, s, r in steps:
            share[s] += behind[q] * of[s] * ahead[r]
        symbol = sum(share) / sum(x * y for x, y in zip(ahead, behind, strict=True))
        if turn % 2:
            creation *= sum(share) / (2 * share[0])
        else:
            split *= sqrt(share[2] / share[4])
    return Gibbs(creation, split, symbol, tuple(ahead))


def tables(successors: Successors, of: Gibbs, total: int) -> tuple[tuple[int, ...], ...]:
    """Frequencies with sum `total` in each context, close to the measure's. CODE-MINIMAX-2."""
    weight = weights(of.creation, of.split)
    rows: list[tuple[int, ...]] = []
    for q, row in enumerate(successors):
        ideal = [
            0.0 if r == NOWHERE else weight[s] * of.potential[r] / (of.symbol * of.potential[q])
            for s, r in enumerate(row)
        ]
        rows.append(_rounded([total * p for p in ideal], total))
    return tuple(rows)


def _rounded(ideal: list[float], total: int) -> tuple[int, ...]:
    """Whole numbers below; then one more, again and again, for the symbol that lacks most."""
    found = [int(x) for x in ideal]
    while sum(found) < total:
        s = max((s for s, x in enumerate(ideal) if x), key=lambda s: ideal[s] / max(found[s], 0.5))
        found[s] += 1
    return tuple(found)
