"""Mutants of each chapter, beside its tests and then beside the cases. Clause: ORCL-MUTANT-9."""

from collections.abc import Callable, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

from clers.measure.mutation.campaign import Plan, over
from clers.measure.mutation.mutant import Mutant, difference
from clers.measure.mutation.outcome import Fate as ByTests
from clers.measure.mutation.outcome import Subject
from clers.measure.mutation.sample import Drawn, draw, subjects
from clers.oracle.mutants.automatic import Sample, run
from clers.oracle.mutants.reached import Reached
from clers.oracle.mutants.trial import Fate
from clers.oracle.mutants.unnoticed import Why, why

Step = Callable[[str], None]
MEMORY: Final = 4 << 30


@dataclass(frozen=True, slots=True)
class Chapter:
    """A chapter of the specification, the package that is its code, its tests."""

    name: str
    package: str
    tests: tuple[str, ...]


OF_EDGEBREAKER: Final = (
    "tests/edgebreaker/test_edgebreaker_laws.py",
    "tests/edgebreaker/test_grammar.py",
    "tests/edgebreaker/test_walk.py",
)
"""Not the tests of all small surfaces, which take minutes where the kernels are interpreted."""

CHAPTERS: Final = (
    Chapter("1. Information", "clers.information", ("tests/information",)),
    Chapter("2. The arithmetic coder", "clers.arithmetic", ("tests/arithmetic",)),
    Chapter("3. Simplicial complexes", "clers.complexes", ("tests/complexes",)),
    Chapter("4. Operators", "clers.operators", ("tests/operators",)),
    Chapter("5. Edgebreaker", "clers.edgebreaker", OF_EDGEBREAKER),
    Chapter("6. Codes for words", "clers.codes", ("tests/codes",)),
    Chapter("7. Positions", "clers.geometry", ("tests/geometry",)),
    Chapter("8. The container", "clers.container", ("tests/container",)),
    Chapter(
        "kernels",
        "clers.kernels",
        ("tests/kernels/test_tables.py", "tests/arithmetic", "tests/codes", *OF_EDGEBREAKER),
    ),
)
"""Kernels are the loops of chapters 2 to 6. Clause: ORCL-MUTANT-9."""


@dataclass(frozen=True, slots=True)
class Row:
    """A drawn mutant: its change by lines, what noticed it, or why nothing does if that is known.

    `by` is a test, or the id of a case; it is empty if neither tests nor cases noticed the change.
    Clause: ORCL-MUTANT-9.
    """

    module: str
    mutant: Mutant
    difference: str
    by: str
    case: bool = False
    why: Why | None = None


@dataclass(frozen=True, slots=True)
class Result:
    """What became of the mutants of a chapter. Clause: ORCL-MUTANT-9.

    `mutants` is how many there are, `drawn` how many were; `rows` has those that were tried.
    """

    chapter: Chapter
    mutants: int
    drawn: int
    rows: tuple[Row, ...]

    @property
    def by_tests(self) -> int:
        """How many the tests of the chapter noticed."""
        return sum(bool(row.by) and not row.case for row in self.rows)

    @property
    def by_cases(self) -> int:
        """How many of the others the cases noticed."""
        return sum(row.case for row in self.rows)

    @property
    def left(self) -> tuple[Row, ...]:
        """Those that nothing noticed."""
        return tuple(row for row in self.rows if not row.by)


def of(chapter: Chapter) -> tuple[Subject, ...]:
    """The modules of a chapter, but those that judge."""
    found = subjects([chapter.package], ())
    assert not isinstance(found, str), "the package is this one's"
    return found


def tried(
    chapter: Chapter, sample: int, seed: int, before: Sequence[Row], step: Step
) -> Result | str:
    """Draw, and run the tests; or say why they cannot be run. Clause: ORCL-MUTANT-9.

    Mutants that a test noticed before, as `before` has it, count as noticed, and are not tried.
    """
    modules = of(chapter)
    root = chapter.package.split(".")[0]
    total, drawn = draw(modules, root, sample, seed)
    known = {(row.module, row.mutant, row.difference): row for row in before if row.by}
    here = {(d.subject.module, d.mutant, difference(d.subject.source, d.mutant)) for d in drawn}
    kept = [row for key, row in known.items() if key in here]
    done = {(row.module, row.mutant) for row in kept}
    rest = [d for d in drawn if (d.subject.module, d.mutant) not in done]
    if not rest:
        return Result(chapter, total, len(drawn), tuple(sorted(kept, key=_place)))
    plan = Plan(modules, root, chapter.tests, sample, seed, 1, MEMORY)
    report = over(plan, total, rest, step)
    if isinstance(report, str):
        return report
    rows = [
        Row(
            found.module,
            found.mutant,
            found.difference,
            (found.by or "time") if found.fate in (ByTests.KILLED, ByTests.TIMED_OUT) else "",
        )
        for found in report.judged
    ]
    return Result(chapter, total, len(drawn), tuple(sorted([*kept, *rows], key=_place)))


def asked(result: Result, reached: Reached, folder: Path, count: int, step: Step) -> Result:
    """Ask the mutants that the tests let pass the cases of a suite. Clause: ORCL-MUTANT-9."""
    modules = {subject.module: subject for subject in of(result.chapter)}
    able = [row for row in result.left if row.module in reached.modules]
    drawn = tuple(Drawn(modules[row.module], row.mutant) for row in able)
    noticed: dict[tuple[str, Mutant], str] = {}
    with closing(run(Sample(result.mutants, drawn), reached, folder, count, 1)) as fates:
        for row, found in zip(able, fates, strict=True):
            step(f"{row.module}:{row.mutant.place}")
            if found.tried.fate is Fate.KILLED:
                noticed[row.module, row.mutant] = found.tried.by
    rows = tuple(_judged(row, noticed.get((row.module, row.mutant), "")) for row in result.rows)
    return Result(result.chapter, result.mutants, result.drawn, rows)


def _judged(row: Row, case: str) -> Row:
    if row.by:
        return row
    if case:
        return replace(row, by=case, case=True)
    return replace(row, why=why(row.module, row.difference))


def _place(row: Row) -> tuple[str, Mutant]:
    return row.module, row.mutant
