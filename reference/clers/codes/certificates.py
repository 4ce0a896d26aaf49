"""Certificates: numbers from which anybody can check what a code costs at worst. All exact.

A potential for each context turns a bound on each symbol alone into one on the whole word: what
one symbol is charged above its due, the potential gives back, and over the word the sum telescopes.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Final

from clers.edgebreaker.stream import SYMBOLS
from clers.information.automaton import Automaton

DIGITS: Final = 40
"""Logarithms are off by less than 2 to the minus this. Clause: CODE-CERTIFICATE-3."""

_ONE: Final = 1 << 96
"""Mantissas are whole multiples of 2^-96, rounded up."""


@dataclass(frozen=True, slots=True)
class Certificate:
    """Positive numbers: for each symbol, for a C, for an S (an E its inverse), for each context.

    Clause: CODE-CERTIFICATE-1.
    """

    symbol: Fraction
    creation: Fraction
    split: Fraction
    potential: tuple[Fraction, ...]


@dataclass(frozen=True, slots=True)
class Breach:
    """A transition whose inequality fails."""

    context: int
    symbol: str


def weight(of: Certificate, symbol: str) -> Fraction:
    """What multiplies for a symbol. Clause: CODE-CERTIFICATE-1."""
    return {"C": of.creation, "S": of.split, "E": 1 / of.split}.get(symbol, Fraction(1))


def breaches(of: Certificate, automaton: Automaton) -> Iterator[Breach]:
    """The transitions for which the certificate says too much; none in a sound one.

    Clause: CODE-CERTIFICATE-1.
    """
    rows = zip(automaton.frequencies, automaton.successors, strict=True)
    for context, (row, successors) in enumerate(rows):
        for symbol, frequency, after in zip(SYMBOLS, row, successors, strict=True):
            if frequency:
                paid = frequency * of.symbol * of.potential[context]
                if paid < sum(row) * weight(of, symbol) * of.potential[after]:
                    yield Breach(context, symbol)


def rate(of: Certificate) -> Fraction:
    """At least the bits per triangle of a sphere: log Λ − ½ log x. Clause: CODE-CERTIFICATE-2."""
    return log2_above(of.symbol) + log2_above(1 / of.creation) / 2


def constant(of: Certificate, automaton: Automaton, start: int) -> Fraction:
    """At least what is left of the bits of a sphere whose first C is implied.

    `start` is the context after that C. Clause: CODE-CERTIFICATE-2.
    """
    ends = {
        row[SYMBOLS.index("E")]
        for row, frequencies in zip(automaton.successors, automaton.frequencies, strict=True)
        if frequencies[SYMBOLS.index("E")]
    }
    least = min(of.potential[end] for end in ends)
    squares = (of.creation / of.symbol) ** 2
    return log2_above(squares * of.split * of.potential[start] / least)


def log2_above(x: Fraction) -> Fraction:
    """A number from log2 x to 2^-40 more than it, for x > 0. Clause: CODE-CERTIFICATE-3."""
    exponent = x.numerator.bit_length() - x.denominator.bit_length()
    if x < Fraction(2) ** exponent:
        exponent -= 1
    scaled = x / Fraction(2) ** exponent * _ONE
    mantissa = -(-scaled.numerator // scaled.denominator)
    digits = 0
    for _ in range(DIGITS):
        mantissa = -(-mantissa * mantissa // _ONE)
        carry = mantissa >= 2 * _ONE
        digits = 2 * digits + carry
        if carry:
            mantissa = (mantissa + 1) // 2
    return exponent + Fraction(digits + 1, 1 << DIGITS)
