"""The domains that the laws of chapter 1 range over."""

from dataclasses import dataclass
from typing import Final

from clers.conventions.law import Given
from clers.information.adaptive import Adaptive
from clers.information.automaton import Automaton
from clers.information.model import Model


@dataclass(frozen=True, slots=True)
class Message:
    """A model and symbols."""

    model: Model
    symbols: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Table:
    """Frequencies."""

    frequencies: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Grouped:
    """Frequencies, and for each symbol the group that it is in."""

    frequencies: tuple[int, ...]
    groups: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Learning:
    """An adaptive model and what it is told."""

    start: Adaptive
    history: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class AdaptiveRequest:
    """What an adaptive model is asked to be."""

    frequencies: tuple[int, ...]
    increment: int
    limit: int


@dataclass(frozen=True, slots=True)
class AutomatonRequest:
    """What an automaton is asked to be, and the context it is to start in."""

    automaton: Automaton
    number: int


@dataclass(frozen=True, slots=True)
class Small:
    """A model of few symbols and a length, so that all messages can be tried."""

    model: Model
    count: int


@dataclass(frozen=True, slots=True)
class Several:
    """Messages of several models."""

    parts: tuple[Message, ...]


@dataclass(frozen=True, slots=True)
class Number:
    """A number of so many bits."""

    value: int
    bits: int


MESSAGE: Final = Given("message", "a model and a message that it allows", Message)
ANY_MESSAGE: Final = Given("any-message", "a model, perhaps too large, and any symbols", Message)
TABLE: Final = Given("table", "frequencies that make a good table", Table)
ANY_TABLE: Final = Given("any-table", "any integers", Table)
GROUPED: Final = Given("grouped-table", "a good table, its symbols in groups", Grouped)
LEARNING: Final = Given("adaptive-history", "an adaptive model and allowed symbols", Learning)
ANY_ADAPTIVE: Final = Given("any-adaptive", "any table, increment, limit", AdaptiveRequest)
ANY_AUTOMATON: Final = Given("any-automaton", "any tables and successors", AutomatonRequest)
SMALL: Final = Given("small-model", "a model of few symbols, and a small length", Small)
SEVERAL: Final = Given("several-messages", "messages of models that do not end", Several)
NUMBER: Final = Given("number-of-bits", "0 ≤ value < 2^bits", Number)
