"""The range coder step by step, with the sum of all digits as one long number: the definition."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

from clers.arithmetic.bits import Bits
from clers.information.model import Slot

WHOLE: Final = 1 << 56
BOTTOM: Final = 1 << 48
ENDING: Final = 1 << 40


@dataclass(frozen=True, slots=True)
class Range:
    """The integers from `low` on, `size` of them; `sent` is the sum of `shifts` digits.

    Clauses: ARITH-RANGE-1, ARITH-RANGE-4.
    """

    low: int = 0
    size: int = WHOLE
    sent: int = 0
    shifts: int = 0


def narrow(state: Range, slot: Slot) -> Range:
    """The part that belongs to a slot; the last takes what is left. Clause: ARITH-RANGE-2."""
    unit = state.size // slot.total
    before = unit * slot.below
    size = state.size - before if slot.upto == slot.total else unit * slot.frequency
    return Range(state.low + before, size, state.sent, state.shifts)


def shifted(state: Range) -> Range:
    """One digit sent. Clause: ARITH-RANGE-3."""
    digit, rest = divmod(state.low, BOTTOM)
    return Range(256 * rest, 256 * state.size, 256 * state.sent + digit, state.shifts + 1)


def states(slots: Iterable[Slot]) -> tuple[Range, ...]:
    """The state at the start and after each slot, settled.

    Clauses: ARITH-RANGE-1, ARITH-RANGE-3.
    """
    trace = [Range()]
    for slot in slots:
        state = narrow(trace[-1], slot)
        while state.size <= BOTTOM:
            state = shifted(state)
        trace.append(state)
    return tuple(trace)


def ending(state: Range) -> Bits:
    """The bytes of a message that ends here. Clause: ARITH-RANGE-4."""
    value = -(-state.low // ENDING)
    size = state.shifts + 2
    return Bits((65536 * state.sent + value).to_bytes(size, "big"), 8 * size)
