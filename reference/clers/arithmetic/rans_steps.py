"""One push of rANS and one pop, on a state and the bytes beside it: the definition."""

from typing import Final, NamedTuple

from clers.information.model import MAXIMUM_TOTAL, Slot

BOTTOM: Final = 1 << 48
"""The least state, and the first. Clause: ARITH-RANS-2."""

M: Final = MAXIMUM_TOTAL
"""The total that every table is stretched to. Clause: ARITH-RANS-1."""


class Stretched(NamedTuple):
    """A slot of the total M: where it begins, and how much it has. Clause: ARITH-RANS-1."""

    below: int
    frequency: int


def stretched(slot: Slot) -> Stretched:
    """A slot with its total made M. Clause: ARITH-RANS-1."""
    below = M * slot.below // slot.total
    return Stretched(below, M * slot.upto // slot.total - below)


class Pushed(NamedTuple):
    """A state, and the bytes that a decoder reads after it: next first."""

    state: int
    ahead: bytes


def push(before: Pushed, slot: Stretched) -> Pushed:
    """A symbol more, in front. Clause: ARITH-RANS-2."""
    state, ahead = before
    while state >= (BOTTOM << 8) // M * slot.frequency:
        state, ahead = state // 256, bytes([state % 256]) + ahead
    quotient, rest = divmod(state, slot.frequency)
    return Pushed(M * quotient + slot.below + rest, ahead)


def pop(after: Pushed, slot: Stretched) -> Pushed:
    """The symbol in front taken off, zeros following the bytes. Clause: ARITH-RANS-4."""
    state, ahead = after
    quotient, place = divmod(state, M)
    state = slot.frequency * quotient + place - slot.below
    while state < BOTTOM:
        state, ahead = 256 * state + (ahead[0] if ahead else 0), ahead[1:]
    return Pushed(state, ahead)
