"""The strategies draw what the laws need to be worth something."""

from collections.abc import Callable
from itertools import pairwise
from random import Random
from typing import Final

import pytest
from hypothesis import Phase, find, settings

from clers.arithmetic import coder
from clers.arithmetic.given import Attempt
from clers.arithmetic.steps import QUARTER, narrow, offset, places, shifted
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.generate.messages import DOMAINS
from clers.information.given import Learning, Message
from clers.information.laws_measure import along
from clers.information.model import MAXIMUM_TOTAL, Slot, has_ended, slots


def most_pending(given: Message) -> int:
    """The longest run of central halves."""
    longest = run = 0
    for place, slot in zip(places(_slots(given)), _slots(given), strict=False):
        state = narrow(place.state, slot)
        while (away := offset(state)) is not None:
            run = run + 1 if away == QUARTER else 0
            longest = max(longest, run)
            state = shifted(state, away)
    return longest


def totals(given: Message) -> list[int]:
    return [model.cumulative[-1] for model in along(given.model, given.symbols)]


MESSAGES: Final[dict[str, Callable[[Message], bool]]] = {
    "empty": lambda given: not given.symbols,
    "long": lambda given: len(given.symbols) > 100,
    "many-pending": lambda given: most_pending(given) > 64,
    "largest-total": lambda given: max(totals(given)) == MAXIMUM_TOTAL and len(given.symbols) > 9,
    "one-symbol": lambda given: len(given.model.cumulative) == 2 and len(given.symbols) > 9,
    "ends": lambda given: has_ended(along(given.model, given.symbols)[-1]) and totals(given)[0] > 0,
    "ends-at-once": lambda given: has_ended(given.model),
    "costs-dozens-a-symbol": lambda given: any(
        slot.total > 2**20 * slot.frequency for slot in _slots(given)
    ),
    "nearly-certain": lambda given: any(
        0 < slot.total - slot.frequency < slot.total / 2**20 for slot in _slots(given)
    ),
}


def _slots(given: Message) -> tuple[Slot, ...]:
    found = slots(given.model, given.symbols)
    return found.value if isinstance(found, Accepted) else ()


@pytest.mark.parametrize("name", MESSAGES)
def test_messages(name: str) -> None:
    """ARITH-SHIFT-2, INFO-MODEL-2, INFO-MODEL-3: the corners are drawn."""
    find(
        DOMAINS["message"],
        lambda drawn: isinstance(drawn, Message) and MESSAGES[name](drawn),
        settings=settings(max_examples=2000, database=None, phases=[Phase.generate]),
        random=Random(0),
    )


def outcome(given: object) -> str:
    """What a strict decoder says of an attempt, and whether it had anything to do."""
    if not isinstance(given, Attempt):
        return "another type"
    got = coder.decode(given.model, given.bits, given.count)
    if isinstance(got, Rejected):
        return got.reason
    return "accepted" if len(got.value) > 5 and given.bits.length > 5 else "trivial"


@pytest.mark.parametrize(
    "wanted", ["accepted", Reason.TRUNCATED_BITS, Reason.TRAILING_BITS, Reason.NOT_CANONICAL]
)
def test_attempts(wanted: str) -> None:
    """ARITH-STRICT-1 … ARITH-STRICT-4: every answer is drawn."""
    find(
        DOMAINS["any-bits"],
        lambda drawn: outcome(drawn) == wanted,
        settings=settings(max_examples=500, database=None, phases=[Phase.generate]),
        random=Random(0),
    )


def test_histories_are_long_enough_to_halve() -> None:
    """INFO-ADAPT-2."""
    find(
        DOMAINS["adaptive-history"],
        lambda drawn: (
            isinstance(drawn, Learning)
            and any(
                after.cumulative[-1] < before.cumulative[-1]
                for before, after in pairwise(along(drawn.start, drawn.history))
            )
        ),
        settings=settings(max_examples=300, database=None, phases=[Phase.generate]),
        random=Random(0),
    )
