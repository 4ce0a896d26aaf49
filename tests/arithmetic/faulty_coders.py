"""Coders with one fault each, as an implementer might write them: the laws must see every one."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Final

from clers.arithmetic.bits import Bits, pack
from clers.arithmetic.coder import REFERENCE, Coder, Reading
from clers.arithmetic.steps import HALF, QUARTER, State, narrow, offset, shifted
from clers.conventions.result import Accepted, Rejected
from clers.information.model import Model, slots


def _sent(model: Model, symbols: Sequence[int], opposite: bool, ending: bool) -> Accepted[Bits]:
    """An encoder bit by bit; it may repeat the next bit (as printed), or forget the ending."""
    found = slots(model, symbols)
    state, pending, out = State(), 0, list[int]()
    for slot in found.value if isinstance(found, Accepted) else ():
        state = narrow(state, slot)
        while (away := offset(state)) is not None:
            if away == QUARTER:
                pending += 1
            else:
                bit = int(away == HALF)
                out += [bit] + [bit ^ opposite] * pending
                pending = 0
            state = shifted(state, away)
    if ending:
        bit = int(state.low >= QUARTER)
        out += [bit] + [bit ^ opposite] * (pending + 1)
    return Accepted(pack(out))


def _repeats(model: Model, symbols: Sequence[int]) -> Accepted[Bits] | Rejected:
    return _sent(model, symbols, opposite=False, ending=True)


def _no_ending(model: Model, symbols: Sequence[int]) -> Accepted[Bits] | Rejected:
    return _sent(model, symbols, opposite=True, ending=False)


def _skips_the_unknown(model: Model, symbols: Sequence[int]) -> Accepted[Bits] | Rejected:
    return _sent(model, symbols, opposite=True, ending=True)


def _edited(
    model: Model, symbols: Sequence[int], less: int, more: int
) -> Accepted[Bits] | Rejected:
    coded = REFERENCE.encode(model, symbols)
    if isinstance(coded, Rejected):
        return coded
    return Accepted(pack(coded.value.values()[: coded.value.length - less] + b"\1" * more))


def _forgets_a_bit(model: Model, symbols: Sequence[int]) -> Accepted[Bits] | Rejected:
    return _edited(model, symbols, 1, 0)


def _forgets_three_bits(model: Model, symbols: Sequence[int]) -> Accepted[Bits] | Rejected:
    return _edited(model, symbols, 3, 0)


def _adds_a_byte(model: Model, symbols: Sequence[int]) -> Accepted[Bits] | Rejected:
    return _edited(model, symbols, 0, 8)


def _accepts_what_it_reads(
    model: Model, bits: Bits, count: int
) -> Accepted[tuple[int, ...]] | Rejected:
    read = REFERENCE.read(model, bits, count)
    return read if isinstance(read, Rejected) else Accepted(read.value.symbols)


def _reads_ones_after(model: Model, bits: Bits, count: int) -> Accepted[Reading] | Rejected:
    return REFERENCE.read(model, bits.followed_by(pack([1] * 40)), count)


def _one_symbol_short(model: Model, bits: Bits, count: int) -> Accepted[Reading] | Rejected:
    return REFERENCE.read(model, bits, count - 1)


FAULTY: Final[Mapping[str, tuple[Coder, frozenset[str]]]] = {
    "repeats-pending-bits": (
        replace(REFERENCE, encode=_repeats),
        frozenset({"coder-round-trip", "coder-bits-are-the-carried-sum"}),
    ),
    "sends-no-ending": (
        replace(REFERENCE, encode=_no_ending),
        frozenset({"coder-round-trip", "coder-is-free-of-prefixes", "coder-length-bounded-below"}),
    ),
    "skips-unknown-symbols": (
        replace(REFERENCE, encode=_skips_the_unknown),
        frozenset({"coder-rejects-as-models-do"}),
    ),
    "forgets-the-last-bit": (
        replace(REFERENCE, encode=_forgets_a_bit),
        frozenset({"coder-round-trip", "coder-followed-by-anything"}),
    ),
    "forgets-three-bits": (
        replace(REFERENCE, encode=_forgets_three_bits),
        frozenset({"coder-length-bounded-below", "coder-is-free-of-prefixes"}),
    ),
    "adds-a-byte": (
        replace(REFERENCE, encode=_adds_a_byte),
        frozenset({"coder-length-bounded-above", "coder-bits-are-the-carried-sum"}),
    ),
    "accepts-whatever-it-reads": (
        replace(REFERENCE, decode=_accepts_what_it_reads),
        frozenset({"coder-accepts-one-code-each"}),
    ),
    "reads-ones-past-the-end": (
        replace(REFERENCE, read=_reads_ones_after),
        frozenset({"coder-reads-anything"}),
    ),
    "reads-one-symbol-less": (
        replace(REFERENCE, read=_one_symbol_short),
        frozenset({"coder-reads-anything", "coder-followed-by-anything"}),
    ),
}
"""By the name of the fault: the coder, and the laws that are sure to fail."""
