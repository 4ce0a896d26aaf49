"""The 32-bit interval and its two steps, one by one: narrowing, and shifting out a digit.

`coder` does the same in one loop; here each step is a function that laws can look at.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

from clers.arithmetic.bits import Bits
from clers.arithmetic.exact import of_number
from clers.information.model import Slot

PRECISION: Final = 32
QUARTER: Final = 1 << (PRECISION - 2)
HALF: Final = 2 * QUARTER
TOP: Final = 4 * QUARTER - 1


@dataclass(frozen=True, slots=True)
class State:
    """The closed interval of integers low … high in 0 … TOP. Clause: ARITH-STATE-1."""

    low: int = 0
    high: int = TOP

    @property
    def width(self) -> int:
        """How many integers it holds."""
        return self.high - self.low + 1


def narrow(state: State, slot: Slot) -> State:
    """The part of the interval that belongs to a slot. Clauses: ARITH-NARROW-1, ARITH-NARROW-2."""
    below = state.width * slot.below // slot.total
    upto = state.width * slot.upto // slot.total
    return State(state.low + below, state.low + upto - 1)


def offset(state: State) -> int | None:
    """What a shift takes away before it doubles; None if the state is settled.

    Clauses: ARITH-SHIFT-1, ARITH-STATE-2.
    """
    if state.high < HALF:
        return 0
    if state.low >= HALF:
        return HALF
    if state.low >= QUARTER and state.high < 3 * QUARTER:
        return QUARTER
    return None


def shifted(state: State, away: int) -> State:
    """Take the offset away and double, the new last digit of `high` being 1.

    Clause: ARITH-SHIFT-1.
    """
    return State(2 * (state.low - away), 2 * (state.high - away) + 1)


@dataclass(frozen=True, slots=True)
class Place:
    """Where a state lies among all numbers: (base + state) / 2^(32 + shifts), with no digit sent.

    Clause: ARITH-CARRY-1.
    """

    state: State = State()
    base: int = 0
    shifts: int = 0


def places(slots: Iterable[Slot]) -> tuple[Place, ...]:
    """The place at the start and after each slot, every one settled. Clause: ARITH-CARRY-1."""
    trace = [Place()]
    for slot in slots:
        here = trace[-1]
        state, base, shifts = narrow(here.state, slot), here.base, here.shifts
        while (away := offset(state)) is not None:
            state, base, shifts = shifted(state, away), 2 * (base + away), shifts + 1
        trace.append(Place(state, base, shifts))
    return tuple(trace)


def ending(place: Place) -> Bits:
    """The bits of a message that ends here, as digits of one number. Clause: ARITH-CARRY-1."""
    quarter = QUARTER if place.state.low < QUARTER else HALF
    return of_number((place.base + quarter) // QUARTER, place.shifts + 2)
