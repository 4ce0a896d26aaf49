"""Laws of the 32-bit interval: what narrowing and shifting keep."""

from itertools import pairwise
from typing import Final

from clers.arithmetic.given import INTERVAL, NARROWING, Narrowing
from clers.arithmetic.steps import State, narrow, offset, places, shifted
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Rejected
from clers.conventions.verdict import Fails, Verdict
from clers.conventions.where import WHOLE, AtSymbol
from clers.information.given import MESSAGE, Message
from clers.information.model import Slot, cumulative, slots
from clers.kernels.interval import Decoder, Encoder

Q: Final = 2**30


def _is_settled(state: State) -> bool:
    """ARITH-STATE-2, word for word."""
    return state.low < 2 * Q <= state.high and not (state.low >= Q and state.high < 3 * Q)


def _states_are_settled(given: Message) -> Verdict:
    """Clauses: ARITH-STATE-1, ARITH-STATE-2."""
    found = slots(given.model, given.symbols)
    if isinstance(found, Rejected):
        return Fails("slots", found.line(), WHOLE)
    for index, place in enumerate(places(found.value)):
        state = place.state
        if index == 0 and state != State(0, 2**32 - 1):
            return Fails("all of 32 bits", repr(state), AtSymbol(0))
        good = 0 <= state.low <= state.high < 2**32 and state.width >= Q + 2
        if not (good and _is_settled(state)):
            return Fails("a settled state of width 2^30 + 2 or more", repr(state), AtSymbol(index))
    return same(len(given.symbols), len(places(found.value)) - 1)


def _narrowing_is_a_partition(given: Narrowing) -> Verdict:
    """Clauses: ARITH-NARROW-1, ARITH-NARROW-2."""
    table = cumulative(given.frequencies)
    slots_ = [Slot(below, upto, table[-1]) for below, upto in pairwise(table) if below < upto]
    parts = [narrow(given.state, slot) for slot in slots_]
    width, total = given.state.width, table[-1]
    return every(
        same(True, all(part.low <= part.high for part in parts)),
        same(given.state.low, parts[0].low),
        same([part.high + 1 for part in parts[:-1]], [part.low for part in parts[1:]]),
        same(given.state.high, parts[-1].high),
        # The floor: the least integer end from which the exact end is less than one away.
        same(
            True,
            all(
                0 <= width * slot.below - total * (part.low - given.state.low) < total
                for slot, part in zip(slots_, parts, strict=True)
            ),
        ),
    )


def _shifting_settles(given: State) -> Verdict:
    """Clause: ARITH-SHIFT-1."""
    state, shifts = given, 0
    while (away := offset(state)) is not None:
        if shifts == 32:
            return Fails("32 shifts at most", "another", WHOLE)
        if _is_settled(state):
            return Fails("settled", f"shift of {away}", WHOLE)
        lower, higher = state.high < 2 * Q, state.low >= 2 * Q
        expected = 0 if lower else 2 * Q if higher else Q
        after = shifted(state, away)
        inside = 0 <= after.low <= after.high < 2**32
        verdict = every(
            same((expected, True), (away, inside)),
            same((2 * state.width, 2 * (state.low - away)), (after.width, after.low)),
        )
        if isinstance(verdict, Fails):
            return verdict
        state, shifts = after, shifts + 1
    return same(True, _is_settled(state))


def _shifts_at_once(given: State) -> Verdict:
    """Clauses: ARITH-SHIFT-1, ARITH-SHIFT-2."""
    state, shifts = given, 0
    while (away := offset(state)) is not None:
        state, shifts = shifted(state, away), shifts + 1
    to, of = Encoder(), Decoder(b"")
    read = of.at
    to.settle(given.low, given.high)
    of.settle(given.low, given.high)
    sent = 8 * len(to.out) + to.holding + to.pending
    return every(
        same((state, shifts), (State(to.low, to.high), sent)),
        same((state, shifts), (State(of.low, of.high), of.at - read)),
    )


LAWS_OF_STEPS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "states-are-settled",
        Clause.ARITH_STATE_2,
        "before each symbol and at the end the state is settled and 2^30 + 2 wide or more",
        MESSAGE,
        _states_are_settled,
    ),
    Law(
        "narrowing-is-a-partition",
        Clause.ARITH_NARROW_2,
        "the narrowed states are not empty, follow each other, and fill the state",
        NARROWING,
        _narrowing_is_a_partition,
    ),
    Law(
        "shifting-settles",
        Clause.ARITH_SHIFT_1,
        "each shift keeps the bounds and doubles the width; after 32 at most none applies",
        INTERVAL,
        _shifting_settles,
    ),
    Law(
        "shifts-at-once",
        Clause.ARITH_SHIFT_1,
        "the kernels of the coder shift at once as far as one shift after another does",
        INTERVAL,
        _shifts_at_once,
    ),
)
