"""Distances, moduli and cross-entropies of small tables, worked out by hand."""

from fractions import Fraction
from math import inf, log2

import pytest

from clers.information.divergence import cross_entropy, distance, modulus, redundancy


def test_distance() -> None:
    """INFO-ENTROPY-5: 1/2, 1/2 and 1/4, 1/4, 1/2 differ by 1/4 + 1/4 + 1/2, halved."""
    assert distance((1, 1), (1, 1, 2)) == Fraction(1, 2)
    assert distance((1, 1, 2), (2, 2)) == Fraction(1, 2)
    assert distance((1,), (0, 1)) == 1
    assert distance((2, 4), (1, 2)) == 0


def test_modulus() -> None:
    """INFO-ENTROPY-5: with t = 1/4 and 5 symbols, 1/4·2 bits and h(1/4) = 2 - 3/4·log2 3."""
    assert modulus(5, Fraction(1, 4)) == pytest.approx(0.5 + 2 - 0.75 * log2(3))
    assert modulus(2, Fraction(1, 2)) == pytest.approx(1)
    assert modulus(2, Fraction(1)) == 0
    assert modulus(9, Fraction(1)) == pytest.approx(3)
    assert modulus(9, Fraction(0)) == 0
    assert modulus(1, Fraction(0)) == modulus(0, Fraction(0)) == 0


def test_cross_entropy() -> None:
    """INFO-CROSS-1, INFO-CROSS-2: even coins by a table 1/4, 3/4 cost (2 + 2 - log2 3)/2."""
    assert cross_entropy((5, 5), (1, 3)) == pytest.approx(2 - log2(3) / 2)
    assert redundancy((5, 5), (1, 3)) == pytest.approx(1 - log2(3) / 2)
    assert cross_entropy((1, 1), (1,)) == inf
    assert cross_entropy((1, 1), (1, 0)) == inf
    assert cross_entropy((1, 0), (1, 1)) == pytest.approx(1)
    assert cross_entropy((1, 0), (3, 0)) == 0
    assert cross_entropy((1,), (1, 3)) == pytest.approx(2)
    assert redundancy((1, 1), (0, 1)) == inf
