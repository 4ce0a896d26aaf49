"""The named numbers, against the literature and against a computation that is not ours."""

from fractions import Fraction
from math import comb, log2

import pytest

from clers.specification.numbers import agrees
from clers.specification.values import VALUES


@pytest.mark.parametrize("name", sorted(VALUES))
def test_positive(name: str) -> None:
    """Clause: CONV-PROSE-3."""
    assert VALUES[name]() > 0


def test_tutte() -> None:
    """The growth of Tutte's 2(4n−3)!/(n!(3n−1)!) rooted triangulations. Clause: CONV-PROSE-3.

    The quotient of neighbours tends to 256/27; from C(4n, n) it is quickly near.
    """
    n = 10**4
    growth = log2(Fraction(comb(4 * n + 4, n + 1), comb(4 * n, n)))
    assert float(VALUES["tutte.bits-per-vertex"]()) == pytest.approx(growth, abs=1e-4)
    assert agrees("3.2451", VALUES["tutte.bits-per-vertex"]())


def test_golden() -> None:
    """Five halves of the logarithm of the golden ratio, by Fibonacci numbers. CONV-PROSE-3."""
    a, b = 1, 1
    for _ in range(60):
        a, b = b, a + b
    assert float(VALUES["golden.bits-per-triangle"]()) == pytest.approx(
        2.5 * log2(b / a), rel=1e-12
    )
    assert agrees("3.4712", VALUES["golden.bits-per-vertex"]())


@pytest.mark.parametrize(
    ("printed", "value", "agree"),
    [
        ("0.5", Fraction(1, 2), True),
        ("0.2", Fraction(1, 4), True),
        ("0.3", Fraction(1, 4), True),
        ("0.33", Fraction(1, 3), True),
        ("0.34", Fraction(1, 3), False),
        ("1/3", Fraction(1, 3), True),
        ("1/3", 0.3333, False),
        ("2/6", Fraction(1, 3), True),
        ("7", 7, True),
        ("7.0", 7, True),
        ("7", 8, False),
        ("-1.5", -1.51, True),
        ("−1.5", -1.51, True),
        ("1.5", -1.51, False),
        ("1000000", 1000000.4, True),
        ("1000001", 1000000.4, False),
    ],
)
def test_rounding(printed: str, value: float | Fraction, agree: bool) -> None:
    """Clause: CONV-PROSE-3."""
    assert agrees(printed, value) is agree
