"""The domains of enumeration, runs and codes of numbers."""

from dataclasses import dataclass
from typing import Final

from clers.conventions.law import Given
from clers.information.runs import Run


@dataclass(frozen=True, slots=True)
class Ranked:
    """A number of symbols, and a word of them that is short enough to list what comes before."""

    size: int
    symbols: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Unranked:
    """Counts of a few symbols, and digits that somebody takes for the code of a word."""

    counts: tuple[int, ...]
    digits: str


@dataclass(frozen=True, slots=True)
class RunsRequest:
    """What is said to be the runs of so many symbols."""

    parts: tuple[Run, ...]
    count: int


@dataclass(frozen=True, slots=True)
class Written:
    """A parameter, numbers, and digits of any origin."""

    parameter: int
    numbers: tuple[int, ...]
    digits: str


RANKED: Final = Given("short-word", "a word of at most 9 symbols below a size", Ranked)
ANY_RANK: Final = Given("any-rank", "small counts, some negative, and any digits", Unranked)
ANY_RUNS: Final = Given("any-runs", "pairs of symbol and length, and a count", RunsRequest)
WRITTEN: Final = Given("numbers-in-digits", "a parameter, numbers, any digits", Written)
