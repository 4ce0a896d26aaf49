"""Laws of the steps of the range coder and of rANS, and of each as a sum of its steps."""

from itertools import accumulate, pairwise
from typing import Final

from clers.arithmetic import range_coder, range_steps, rans, rans_steps
from clers.arithmetic.bits import Bits
from clers.arithmetic.exact import of_number
from clers.arithmetic.given import PUSHING, Pushing
from clers.arithmetic.rans_steps import Pushed
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Verdict
from clers.conventions.where import WHOLE
from clers.information.given import MESSAGE, Message
from clers.information.model import Slot, cumulative, slots


def _range_states_are_settled(given: Message) -> Verdict:
    """Clauses: ARITH-RANGE-1, ARITH-RANGE-3."""
    found = slots(given.model, given.symbols)
    if isinstance(found, Rejected):
        return Fails("slots", found.line(), WHOLE)
    trace = range_steps.states(found.value)
    steps = [after.shifts - before.shifts for before, after in pairwise(trace)]
    return every(
        same(range_steps.Range(0, 2**56, 0, 0), trace[0]),
        same(len(given.symbols) + 1, len(trace)),
        same(True, all(2**48 < state.size <= 2**56 for state in trace)),
        same(True, all(0 <= state.low <= state.low + state.size <= 2**57 for state in trace)),
        same(True, max(steps, default=0) <= 4),
    )


def _range_narrowing_is_a_partition(given: Pushing) -> Verdict:
    """Clause: ARITH-RANGE-2."""
    table = cumulative(given.frequencies)
    found = [Slot(a, b, table[-1]) for a, b in pairwise(table) if a < b]
    whole = range_steps.Range(given.state - 2**48, given.state, 7, 1)
    parts = [range_steps.narrow(whole, slot) for slot in found]
    unit = given.state // table[-1]
    return every(
        same(True, all(part.size >= 1 for part in parts)),
        same([whole.low + unit * slot.below for slot in found], [part.low for part in parts]),
        same(
            [part.low + part.size for part in parts],
            [part.low for part in parts[1:]] + [whole.low + whole.size],
        ),
        same({(7, 1)}, {(part.sent, part.shifts) for part in parts}),
    )


def _range_bytes_are_the_sum(given: Message) -> Verdict:
    """Clauses: ARITH-RANGE-3, ARITH-RANGE-4, ARITH-RANGE-5."""
    found = slots(given.model, given.symbols)
    if isinstance(found, Rejected):
        return Fails("slots", found.line(), WHOLE)
    last = range_steps.states(found.value)[-1]
    # The least multiple of 2^40 from `low` on, after the digits: base 2, and no bytes.
    value = next(v for v in range(last.low >> 40, (last.low >> 40) + 2) if v << 40 >= last.low)
    bits = of_number((last.sent << 16) + value, 8 * last.shifts + 16)
    return every(
        same(bits, range_steps.ending(last)),
        same(Accepted(bits), range_coder.encode(given.model, given.symbols)),
    )


def _popping_undoes_pushing(given: Pushing) -> Verdict:
    """Clauses: ARITH-RANS-1, ARITH-RANS-2, ARITH-RANS-4."""
    table = cumulative(given.frequencies)
    verdicts: list[Verdict] = []
    before = Pushed(given.state, given.ahead)
    for a, b in pairwise(table):
        if a == b:
            continue
        slot = rans_steps.stretched(Slot(a, b, table[-1]))
        low, high = 2**30 * a // table[-1], 2**30 * b // table[-1]
        after = rans_steps.push(before, slot)
        verdicts += [
            same((low, high - low), (slot.below, slot.frequency)),
            same(True, slot.frequency >= 1 and 2**48 <= after.state < 2**56),
            same(True, low <= after.state % 2**30 < high),
            same(before, rans_steps.pop(after, slot)),
        ]
    return every(*verdicts)


def _rans_bytes_are_pushed(given: Message) -> Verdict:
    """Clauses: ARITH-RANS-3, ARITH-RANS-4."""
    found = slots(given.model, given.symbols)
    if isinstance(found, Rejected):
        return Fails("slots", found.line(), WHOLE)
    parts = [rans_steps.stretched(slot) for slot in found.value]
    last = Pushed(2**48, b"")
    for part in reversed(parts):
        last = rans_steps.push(last, part)
    data = last.state.to_bytes(7, "big") + last.ahead
    first = list(accumulate(parts, rans_steps.pop, initial=last))[-1]
    return every(
        same(Accepted(Bits(data, 8 * len(data))), rans.encode(given.model, given.symbols)),
        same(Pushed(2**48, b""), first),
    )


LAWS_OF_BYTE_STEPS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "range-states-are-settled",
        Clause.ARITH_RANGE_1,
        "before each symbol the range is over 2^48 and no number is over 2^57; 4 shifts at most",
        MESSAGE,
        _range_states_are_settled,
    ),
    Law(
        "range-narrowing-is-a-partition",
        Clause.ARITH_RANGE_2,
        "the narrowed states are not empty, follow each other, and fill the state",
        PUSHING,
        _range_narrowing_is_a_partition,
    ),
    Law(
        "range-bytes-are-the-carried-sum",
        Clause.ARITH_RANGE_5,
        "held and waiting bytes print the sum of all digits, shifts + 2 bytes",
        MESSAGE,
        _range_bytes_are_the_sum,
    ),
    Law(
        "popping-undoes-pushing",
        Clause.ARITH_RANS_4,
        "a pushed symbol lies in its stretched slot, and popping it leaves state and bytes",
        PUSHING,
        _popping_undoes_pushing,
    ),
    Law(
        "rans-bytes-are-pushed",
        Clause.ARITH_RANS_3,
        "the code is the last state and the bytes sent; popping all symbols leads to the first",
        MESSAGE,
        _rans_bytes_are_pushed,
    ),
)
