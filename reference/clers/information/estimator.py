"""The add-half model, and how much worse than the best static table it can be."""

from fractions import Fraction

from clers.conventions.result import Accepted, Rejected
from clers.information.adaptive import Adaptive, adaptive
from clers.information.model import MAXIMUM_TOTAL


def add_half(size: int) -> Accepted[Adaptive] | Rejected:
    """The adaptive model that begins with half a count for each symbol. Clause: INFO-LEARN-1."""
    return adaptive((1,) * size, 2, MAXIMUM_TOTAL)


def worst_ratio(size: int, count: int) -> Fraction:
    """The most by which `count` symbols are less probable than by their own frequencies.

    Clauses: INFO-LEARN-2, INFO-LEARN-3.
    """
    ratio = Fraction(1)
    for j in range(count):
        ratio *= Fraction(size + 2 * j, 1 + 2 * j)
    return ratio


def best_static(counts: tuple[int, ...]) -> Fraction:
    """The probability of a message under its own frequencies, the greatest under static tables.

    Clause: INFO-LEARN-2.
    """
    total = sum(counts)
    chance = Fraction(1)
    for count in counts:
        chance *= Fraction(count, max(total, 1)) ** count
    return chance
