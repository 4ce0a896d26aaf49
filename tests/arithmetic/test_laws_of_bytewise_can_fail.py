"""Each law of the coders in bytes sees a fault planted in what it judges."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from random import Random
from typing import Final

import pytest
from hypothesis import Phase, find, settings

from clers.arithmetic import laws, range_coder, range_steps, rans, rans_steps
from clers.arithmetic.bits import Bits, pack
from clers.arithmetic.coder import Coder, Reading
from clers.arithmetic.laws_bytewise import laws_of, range_bound, rans_bound
from clers.arithmetic.range_coder import RANGE_CODER
from clers.arithmetic.rans import RANS
from clers.arithmetic.rans_steps import Pushed, Stretched
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails
from clers.generate.messages import DOMAINS
from clers.information.model import Model, Slot, slots

Encode = Callable[[Model, Sequence[int]], Accepted[Bits] | Rejected]


def shown(law: AnyLaw) -> bool:
    """Some example of the law's domain shows the fault."""
    example = find(
        DOMAINS[law.domain],
        lambda drawn: isinstance(law.check(drawn), Fails),
        settings=settings(max_examples=500, database=None, phases=[Phase.generate]),
        random=Random(0),
    )
    return isinstance(law.check(example), Fails)


def edited(encode: Encode, less: int, more: int) -> Encode:
    """An encoder that forgets bytes at the end, or adds some."""

    def wrong(model: Model, symbols: Sequence[int]) -> Accepted[Bits] | Rejected:
        coded = encode(model, symbols)
        if isinstance(coded, Rejected):
            return coded
        data = coded.value.data[: len(coded.value.data) - less] + bytes(more)
        return Accepted(Bits(data, 8 * len(data)))

    return wrong


def deaf(encode: Encode) -> Encode:
    """An encoder that leaves out what it cannot say."""

    def wrong(model: Model, symbols: Sequence[int]) -> Accepted[Bits] | Rejected:
        coded = encode(model, symbols)
        return Accepted(pack([])) if isinstance(coded, Rejected) else coded

    return wrong


def lax(coder: Coder) -> Coder:
    """It accepts whatever it reads."""

    def wrong(model: Model, bits: Bits, count: int) -> Accepted[tuple[int, ...]] | Rejected:
        read = coder.read(model, bits, count)
        return read if isinstance(read, Rejected) else Accepted(read.value.symbols)

    return replace(coder, decode=wrong)


def ones(coder: Coder) -> Coder:
    """It reads ones past the end."""

    def wrong(model: Model, bits: Bits, count: int) -> Accepted[Reading] | Rejected:
        return coder.read(model, bits.followed_by(pack([1] * 80)), count)

    return replace(coder, read=wrong)


def faulty(coder: Coder) -> Mapping[str, Coder]:
    less = 6 if coder is RANS else 2
    return {
        "round-trip": replace(coder, encode=edited(coder.encode, 1, 1)),
        "rejects-as-models-do": replace(coder, encode=deaf(coder.encode)),
        "is-free-of-prefixes": replace(coder, encode=edited(coder.encode, less, 0)),
        "length-is-near-the-content": replace(coder, encode=edited(coder.encode, 0, 2)),
        "reads-anything": ones(coder),
        "accepts-one-code-each": lax(coder),
    }


KINDS: Final = {
    "range-coder": (RANGE_CODER, Clause.ARITH_BYTES_4, range_bound),
    "rans": (RANS, Clause.ARITH_BYTES_5, rans_bound),
}


@pytest.mark.parametrize("kind", KINDS)
def test_each_law_of_a_coder_sees_its_fault(kind: str) -> None:
    """CONV-LAW-1."""
    coder, clause, bound = KINDS[kind]
    faults = faulty(coder)
    for index, law in enumerate(laws_of(kind, coder, clause, bound)):
        fault = faults[law.name.removeprefix(kind + "-")]
        assert shown(laws_of(kind, fault, clause, bound)[index]), law.name


def test_lengths_may_not_be_short() -> None:
    """ARITH-BYTES-4, ARITH-BYTES-5: the lower bounds."""
    short = replace(RANGE_CODER, encode=edited(RANGE_CODER.encode, 2, 0))
    assert shown(laws_of("range-coder", short, Clause.ARITH_BYTES_4, range_bound)[3])
    short = replace(RANS, encode=edited(RANS.encode, 2, 0))
    assert shown(laws_of("rans", short, Clause.ARITH_BYTES_5, rans_bound)[3])


def test_bounds_at_one_symbol() -> None:
    """ARITH-BYTES-4, ARITH-BYTES-5: a certain symbol; a coin; the last of three."""
    for found, content in (((Slot(0, 1, 1),), 0), ((Slot(0, 2, 4), Slot(1, 2, 4)), 3)):
        low = [n for n in range(90) if range_bound(n, found)]
        assert low == list(range(content + 9, content + 17))
        low = [n for n in range(90) if rans_bound(n, found)]
        assert low == list(range(content + 48, content + 57))


LAW: Final = {law.name: law for law in laws.LAWS}


def cut_short(state: range_steps.Range, slot: Slot) -> range_steps.Range:
    """The last symbol gets no more than its share."""
    unit = state.size // slot.total
    size = unit * slot.frequency
    return range_steps.Range(state.low + unit * slot.below, size, state.sent, state.shifts)


def one_byte_less(before: Pushed, slot: Stretched) -> Pushed:
    """It sends only when the state is twice too large."""
    state, ahead = before
    while state >= slot.frequency << 27:
        state, ahead = state // 256, bytes([state % 256]) + ahead
    return Pushed(2**30 * (state // slot.frequency) + slot.below + state % slot.frequency, ahead)


def forwards(model: Model, symbols: Sequence[int]) -> Accepted[Bits] | Rejected:
    found = slots(model, symbols)
    if isinstance(found, Rejected):
        return found
    last = Pushed(2**48, b"")
    for slot in found.value:
        last = rans_steps.push(last, rans_steps.stretched(slot))
    data = last.state.to_bytes(7, "big") + last.ahead
    return Accepted(Bits(data, 8 * len(data)))


def test_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as planted:
        planted.setattr(range_steps, "BOTTOM", 2**40)
        assert shown(LAW["range-states-are-settled"])
    with monkeypatch.context() as planted:
        planted.setattr(range_steps, "narrow", cut_short)
        assert shown(LAW["range-narrowing-is-a-partition"])
    with monkeypatch.context() as planted:
        planted.setattr(range_coder, "encode", edited(range_coder.encode, 1, 1))
        assert shown(LAW["range-bytes-are-the-carried-sum"])
    with monkeypatch.context() as planted:
        planted.setattr(rans_steps, "push", one_byte_less)
        assert shown(LAW["popping-undoes-pushing"])
    with monkeypatch.context() as planted:
        planted.setattr(rans, "encode", forwards)
        assert shown(LAW["rans-bytes-are-pushed"])
