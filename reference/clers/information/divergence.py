"""Two tables: how far apart they are, and what it costs to code by the wrong one."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import zip_longest
from math import fsum, inf, log2

from clers.information.measure import entropy


def distance(one: Sequence[int], other: Sequence[int]) -> Fraction:
    """Half the sum of the differences of probabilities; tables of positive total.

    Clause: INFO-ENTROPY-5.
    """
    first, second = sum(one), sum(other)
    pairs = zip_longest(one, other, fillvalue=0)
    return sum((abs(Fraction(f, first) - Fraction(g, second)) for f, g in pairs), Fraction(0)) / 2


def modulus(size: int, apart: Fraction) -> float:
    """How much the entropies of tables of `size` symbols at this distance can differ.

    Clause: INFO-ENTROPY-5.
    """
    if size <= 1:
        return 0.0
    change, rest = apart.numerator, (1 - apart).numerator
    return float(apart) * log2(size - 1) + entropy((change, rest))


def cross_entropy(table: Sequence[int], under: Sequence[int]) -> float:
    """Bits a symbol of `table` under another one; infinite if that lacks a symbol.

    Clause: INFO-CROSS-1.
    """
    total, other = sum(table), sum(under)
    pairs = [(f, g) for f, g in zip_longest(table, under, fillvalue=0) if f > 0]
    if any(g == 0 for _, g in pairs):
        return inf
    return fsum(f / total * (log2(other) - log2(g)) for f, g in pairs)


def redundancy(table: Sequence[int], under: Sequence[int]) -> float:
    """Bits a symbol lost by coding by the other table. Clauses: INFO-CROSS-2, INFO-CROSS-3."""
    return cross_entropy(table, under) - entropy(table)
