"""The arithmetic coder as the tutorial first tells it: one number in one interval, exactly.

This is the definition of what an arithmetic coder is. It is quadratic and meant for laws and for
short messages; `coder` is the algorithm.
"""

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import ceil
from typing import Final

from clers.arithmetic.bits import Bits, pack
from clers.conventions.result import Accepted, Rejected
from clers.information.model import MAXIMUM_TOTAL, Model, Slot, has_ended, over_maximum, slots


@dataclass(frozen=True, slots=True)
class Interval:
    """The numbers x with low ≤ x < low + width. Clause: ARITH-EXACT-1."""

    low: Fraction
    width: Fraction

    @property
    def high(self) -> Fraction:
        """The end, which is outside."""
        return self.low + self.width

    def part(self, slot: Slot) -> "Interval":
        """The part that belongs to a slot of a table. Clauses: ARITH-EXACT-1, ARITH-EXACT-4."""
        unit = self.width / slot.total
        return Interval(self.low + unit * slot.below, unit * slot.frequency)


UNIT: Final = Interval(Fraction(0), Fraction(1))


def intervals(model: Model, symbols: Sequence[int]) -> Accepted[tuple[Interval, ...]] | Rejected:
    """The interval before the first symbol and after each. Clause: ARITH-EXACT-1."""
    found = slots(model, symbols)
    if isinstance(found, Rejected):
        return found
    trace = [UNIT]
    for slot in found.value:
        trace.append(trace[-1].part(slot))
    return Accepted(tuple(trace))


def interval(model: Model, symbols: Sequence[int]) -> Accepted[Interval] | Rejected:
    """The interval of a message. Clause: ARITH-EXACT-1."""
    trace = intervals(model, symbols)
    return trace if isinstance(trace, Rejected) else Accepted(trace.value[-1])


def encode(model: Model, symbols: Sequence[int]) -> Accepted[Bits] | Rejected:
    """The shortest bits that name a message. Clause: ARITH-EXACT-2."""
    found = interval(model, symbols)
    return found if isinstance(found, Rejected) else Accepted(shortest(found.value))


def shortest(target: Interval) -> Bits:
    """The shortest, then least, bits whose dyadic interval lies inside.

    Clauses: ARITH-EXACT-2, ARITH-EXACT-5.
    """
    # A dyadic interval no wider than the target: length with 2^-length ≤ width.
    length = (ceil(1 / target.width) - 1).bit_length()
    while True:
        number = ceil(target.low * 2**length)
        if Fraction(number + 1, 2**length) <= target.high:
            return of_number(number, length)
        length += 1


def of_number(number: int, length: int) -> Bits:
    """The binary digits of 0 ≤ number < 2^length, `length` of them."""
    return pack(number >> place & 1 for place in range(length - 1, -1, -1))


def number_of(bits: Bits) -> Fraction:
    """The number 0.b1b2b3… that bits name. Clause: ARITH-EXACT-2."""
    return Fraction(int(bits.digits() or "0", 2), 2**bits.length)


def decode(model: Model, bits: Bits, count: int) -> Accepted[tuple[int, ...]] | Rejected:
    """The `count` symbols (fewer if the model ends) whose intervals hold the number.

    Clauses: ARITH-EXACT-3, INFO-MODEL-3, INFO-MODEL-6.
    """
    number = number_of(bits)
    rest = UNIT
    symbols: list[int] = []
    while len(symbols) < count and not has_ended(model):
        table = model.cumulative
        if table[-1] > MAXIMUM_TOTAL:
            return over_maximum(len(symbols), table[-1])
        symbol = bisect_right(table, (number - rest.low) / rest.width * table[-1]) - 1
        rest = rest.part(Slot(table[symbol], table[symbol + 1], table[-1]))
        symbols.append(symbol)
        model = model.after(symbol)
    return Accepted(tuple(symbols))
