"""What a message costs: its exact probability, its information content, entropy."""

from collections.abc import Sequence
from fractions import Fraction
from math import fsum, log2, prod

from clers.conventions.result import Accepted, Rejected
from clers.information.model import Model, slots


def probability(model: Model, symbols: Sequence[int]) -> Accepted[Fraction] | Rejected:
    """The exact probability of a message under a model. Clauses: INFO-CONTENT-1, INFO-CONTENT-3."""
    found = slots(model, symbols)
    if isinstance(found, Rejected):
        return found
    numerator = prod(slot.frequency for slot in found.value)
    return Accepted(Fraction(numerator, prod(slot.total for slot in found.value)))


def content(model: Model, symbols: Sequence[int]) -> Accepted[float] | Rejected:
    """The information content of a message in bits, for reports. Clause: INFO-CONTENT-2."""
    found = slots(model, symbols)
    if isinstance(found, Rejected):
        return found
    return Accepted(fsum(log2(slot.total) - log2(slot.frequency) for slot in found.value))


def bits(chance: Fraction) -> float:
    """-log2 of an exact probability, however small, for reports. Clause: INFO-CONTENT-2."""
    return log2(chance.denominator) - log2(chance.numerator)


def entropy(frequencies: Sequence[int]) -> float:
    """The entropy of a table in bits a symbol; 0 of an empty one.

    Clauses: INFO-ENTROPY-1 … INFO-ENTROPY-4 (-2, -3 and -4 follow from -1).
    """
    total = sum(frequencies)
    return fsum(f / total * (log2(total) - log2(f)) for f in frequencies if f > 0)
