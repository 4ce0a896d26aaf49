"""Messages that lead exactly to the ends of halves and quarters, where < and ≤ part."""

from typing import Final

import pytest

from clers.arithmetic.coder import REFERENCE
from clers.arithmetic.exact import of_number
from clers.arithmetic.laws import laws_of
from clers.arithmetic.laws_steps import LAWS_OF_STEPS
from clers.arithmetic.steps import HALF, QUARTER, TOP, State, narrow, offset
from clers.conventions.result import Accepted
from clers.conventions.verdict import Holds
from clers.information.combined import Turns, followed, times
from clers.information.given import Message
from clers.information.model import MAXIMUM_TOTAL, Slot
from clers.information.static import Static

FIRST: Final = (Slot(3, 16, 20), Slot(6, 16, 20), Slot(4, 14, 20))
"""They leave settled states: over three quarters or more; without the lowest; without the highest.

None is centred, so that every end is within reach of some table.
"""

EXTREME: Final = Static((0, 1, MAXIMUM_TOTAL - 1, MAXIMUM_TOTAL))
"""Its first and last symbol choose the outermost few integers, where one too many would show."""

CASES: Final = [
    (first, middle + less, side)
    for first, middles in zip(
        FIRST,
        ((QUARTER, HALF, 3 * QUARTER), (HALF, 3 * QUARTER), (QUARTER, HALF)),
        strict=True,
    )
    for middle in middles
    for less in (-2, -1, 0, 1)
    for side in (0, 1)
]


def cut(width: int, size: int) -> tuple[int, int]:
    """A cumulative frequency and a total at which narrowing gives just `size` integers."""
    for total in range(MAXIMUM_TOTAL, 2, -1):
        upto = -(-size * total // width)
        if width * upto // total == size and 0 < upto < total:
            return upto, total
    raise AssertionError


@pytest.mark.parametrize(("first", "end", "side"), CASES)
def test_exact_ends(first: Slot, end: int, side: int) -> None:
    """ARITH-SHIFT-1, ARITH-SHIFT-2, ARITH-DECODE-2: the new `high`, or the new `low`, is the end.

    All laws of messages hold there; the steps of ARITH-CARRY-1 are the other opinion.
    """
    state = narrow(State(), first)
    assert offset(state) is None  # so the second symbol meets it
    upto, total = cut(state.width, end - state.low + (1 - side))
    slot = (Slot(0, upto, total), Slot(upto, total, total))[side]
    reached = narrow(state, slot)
    assert end == (reached.high, reached.low)[side]
    start, then = Static((0, *first)), Static((0, upto, total))
    model = followed(times(Turns((start, then)), 2), EXTREME)
    for last in (0, 1, 2):
        hold_for(Message(model, (1, side, last, last, last)))


def hold_for(message: Message) -> None:
    """Every law of messages holds for this one."""
    judged = {law.name: law.check(message) for law in laws_of(REFERENCE) if law.domain == "message"}
    assert len(judged) == 4
    assert set(judged.values()) == {Holds()}


def test_ending_at_a_quarter() -> None:
    """ARITH-END-1, ARITH-CARRY-1: [1/4, 1) ends with low just at 2^30."""
    hold_for(Message(Static((0, 1, 4)), (1,)))


def test_the_search_at_the_first_integer_of_a_part() -> None:
    """ARITH-DECODE-2: of 2^32 integers the last third begins at ⌊2^33/3⌋ = aaaaaaaa."""
    thirds = Static((0, 1, 2, 3))
    for value, symbol in ((0xAAAAAAAA, 2), (0xAAAAAAA9, 1), (0x55555555, 1), (0x55555554, 0)):
        read = REFERENCE.read(thirds, of_number(value, 32), 1)
        assert isinstance(read, Accepted)
        assert read.value.symbols == (symbol,)


ENDS: Final = tuple(
    sorted(
        {end + less for end in (0, 1, QUARTER, HALF, 3 * QUARTER, TOP) for less in (-2, -1, 0, 1)}
    )
)


@pytest.mark.parametrize("low", [end for end in ENDS if 0 <= end <= TOP])
def test_any_state_is_shifted_at_once(low: int) -> None:
    """ARITH-SHIFT-1: from no shift to 32 of them, where both ends are one number."""
    law = next(law for law in LAWS_OF_STEPS if law.name == "shifts-at-once")
    for high in (end for end in ENDS if low <= end <= TOP):
        assert law.check(State(low, high)) == Holds(), high
