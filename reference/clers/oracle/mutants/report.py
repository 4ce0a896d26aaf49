"""What mutants came to, as one value. Clauses: ORCL-MUTANT-5, ORCL-MUTANT-6."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Final

from clers.oracle.mutants.mutant import Mutant
from clers.oracle.mutants.trial import Fate, Tried

ENOUGH: Final = Fraction(98, 100)
"""The part of the mutants that the vectors must kill. Clause: ORCL-MUTANT-5."""


@dataclass(frozen=True, slots=True)
class Row:
    """A mutant and what became of it; `explained` is why it survives, where anybody knows.

    Clause: ORCL-MUTANT-5.
    """

    name: str
    clause: str
    module: str
    mistake: str
    fate: Fate
    asked: int
    by: str
    status: str
    why: str
    explained: str


@dataclass(frozen=True, slots=True)
class Report:
    """The mutants that were tried, and the suite that they met. Clause: ORCL-MUTANT-5.

    `complete`: none was left out by an interrupt.
    """

    suite: str
    cases: int
    mutants: int
    killed: int
    complete: bool
    rows: tuple[Row, ...]

    @property
    def score(self) -> Fraction:
        """The part of those tried that was killed; 0 of none."""
        return Fraction(self.killed, max(1, len(self.rows)))

    @property
    def good(self) -> bool:
        """Are enough killed, and is each survivor explained? Clause: ORCL-MUTANT-5."""
        open_ends = [row for row in self.rows if row.fate is not Fate.KILLED and not row.explained]
        return self.complete and self.score >= ENOUGH and not open_ends


def row(mutant: Mutant, found: Tried, explained: Mapping[str, str]) -> Row:
    """A mutant with its fate."""
    survived = found.fate is Fate.SURVIVED
    return Row(
        mutant.name,
        str(mutant.clause),
        mutant.module,
        mutant.mistake,
        found.fate,
        found.asked,
        found.by,
        found.status,
        found.why,
        explained.get(mutant.name, "") if survived else "",
    )


def report(suite: str, cases: int, mutants: Sequence[Mutant], rows: Iterable[Row]) -> Report:
    """The report of those rows that there are, of so many mutants that were to be tried."""
    there = tuple(rows)
    killed = sum(found.fate is Fate.KILLED for found in there)
    complete = len(there) == len(mutants)
    return Report(suite, cases, len(mutants), killed, complete, there)
