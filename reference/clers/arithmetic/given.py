"""The domains that the laws of chapter 2 range over, beside those of chapter 1."""

from dataclasses import dataclass
from typing import Final

from clers.arithmetic.bits import Bits
from clers.arithmetic.steps import State
from clers.conventions.law import Given
from clers.information.automaton import Context
from clers.information.model import Model


@dataclass(frozen=True, slots=True)
class Joined:
    """A message and bits that follow its code."""

    model: Model
    symbols: tuple[int, ...]
    tail: Bits


@dataclass(frozen=True, slots=True)
class Attempt:
    """Bits that somebody takes for the code of so many symbols."""

    model: Model
    bits: Bits
    count: int


@dataclass(frozen=True, slots=True)
class Narrowing:
    """A state that is to be narrowed by a table."""

    state: State
    frequencies: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Declared:
    """Bytes, and how many bits they are said to hold."""

    data: bytes
    length: int


@dataclass(frozen=True, slots=True)
class Pushing:
    """A number from 2^48 up to 2^56, a table, and bytes."""

    state: int
    frequencies: tuple[int, ...]
    ahead: bytes


@dataclass(frozen=True, slots=True)
class ByAutomaton:
    """An automaton in one of its contexts, any symbols, and any bits to read as many from."""

    start: Context
    symbols: tuple[int, ...]
    bits: Bits


JOINED: Final = Given("message-and-tail", "an allowed message and bits that follow it", Joined)
ATTEMPT: Final = Given("any-bits", "a model, bits of any origin, a number of symbols", Attempt)
NARROWING: Final = Given("settled-state", "a settled state and a good table", Narrowing)
INTERVAL: Final = Given("any-state", "integers 0 ≤ low ≤ high < 2^32", State)
DECLARED: Final = Given("declared-bytes", "bytes and a declared number of bits", Declared)
BITS: Final = Given("bits", "a string of bits", Bits)
PUSHING: Final = Given("state-of-56-bits", "2^48 < state < 2^56, a good table, bytes", Pushing)
BY_AUTOMATON: Final = Given("by-automaton", "an automaton, symbols, bits", ByAutomaton)
