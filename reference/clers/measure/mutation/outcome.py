"""What became of mutants, as values; all that a campaign reports."""

from dataclasses import dataclass
from enum import StrEnum
from typing import Final

from clers.measure.mutation.mutant import Mutant

ON_IMPORT: Final = -1
"""What stands among the numbers of tests for lines that importing executes."""


class Fate(StrEnum):
    """What the tests say of a mutant. Clause: TOOL-MUTATION-3."""

    KILLED = "killed"
    TIMED_OUT = "timed-out"
    SURVIVED = "survived"
    UNREACHED = "unreached"


@dataclass(frozen=True, slots=True)
class Trial:
    """The fate of one mutant, and the test that decided it, if one did."""

    fate: Fate
    by: str = ""


@dataclass(frozen=True, slots=True)
class Subject:
    """A module to be mutated: its dotted name, its file, its text."""

    module: str
    path: str
    source: str


@dataclass(frozen=True, slots=True)
class Judged:
    """A mutant with its fate, as it stands in the report. Clause: TOOL-MUTATION-5."""

    module: str
    mutant: Mutant
    difference: str
    fate: Fate
    by: str


@dataclass(frozen=True, slots=True)
class Baseline:
    """What the tests do on the unchanged source.

    `tests` maps each test that passes to its seconds, in order; `failed` has the others. `lines`
    has for each file and line the numbers of the tests that execute it.
    `loaded` are the modules that were imported.
    """

    tests: dict[str, float]
    failed: tuple[str, ...]
    lines: dict[str, dict[int, tuple[int, ...]]]
    loaded: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Report:
    """A campaign. Clause: TOOL-MUTATION-5.

    `mutants` is the number of all mutants of the modules, `sampled` that of those drawn; each
    drawn one that was tried, or that no test reaches, is in `judged`. `complete`: all were.
    `score` is the part of `judged` that was killed or timed out. `left_out` are the tests that
    do not pass on the unchanged source.
    """

    modules: tuple[str, ...]
    tests: tuple[str, ...]
    sample: int | None
    seed: int
    mutants: int
    sampled: int
    complete: bool
    killed: int
    timed_out: int
    survived: int
    unreached: int
    score: float
    left_out: tuple[str, ...]
    judged: tuple[Judged, ...]
