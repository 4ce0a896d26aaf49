"""The domains of prefix codes, enumerations and numbers."""

from dataclasses import dataclass
from typing import Final

from clers.conventions.law import Given
from clers.information.prefix import PrefixCode


@dataclass(frozen=True, slots=True)
class Words:
    """What the words of a code are asked to be."""

    words: tuple[str | None, ...]


@dataclass(frozen=True, slots=True)
class LengthsRequest:
    """What the lengths of a code are asked to be."""

    lengths: tuple[int | None, ...]


@dataclass(frozen=True, slots=True)
class Coded:
    """A prefix code, a message that it allows, and digits that somebody takes for its code."""

    code: PrefixCode
    symbols: tuple[int, ...]
    digits: str


@dataclass(frozen=True, slots=True)
class Pair:
    """Two tables."""

    one: tuple[int, ...]
    other: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class GroupedPair:
    """Two tables, and for each symbol the group that it is in."""

    one: tuple[int, ...]
    other: tuple[int, ...]
    groups: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Few:
    """Frequencies of a few symbols, small enough for exact powers and exhaustive search."""

    frequencies: tuple[int, ...]


ANY_WORDS: Final = Given("any-words", "strings, some missing", Words)
ANY_LENGTHS: Final = Given("any-lengths", "any integers, some missing", LengthsRequest)
CODED: Final = Given("prefix-coded", "a prefix code, a message, and any digits", Coded)
PAIR: Final = Given("two-tables", "two good tables", Pair)
GROUPED_PAIR: Final = Given("two-grouped-tables", "two tables of the same groups", GroupedPair)
FEW: Final = Given("few-frequencies", "a good table of few symbols and a small total", Few)
