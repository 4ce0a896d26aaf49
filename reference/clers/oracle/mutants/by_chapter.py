"""Mutants of each chapter, beside its tests and then beside the cases. Clause: ORCL-MUTANT-9."""

from collections.abc import Callable, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Final

from clers.measure.mutation.campaign import Plan, over
from clers.measure.mutation.mutant import Mutant, difference
from clers.measure.mutation.outcome import Fate as ByTests
from clers.measure.mutation.outcome import Judged, Subject
from clers.measure.mutation.sample import Drawn, draw, subjects
from clers.oracle.mutants.automatic import Sample, run
from clers.oracle.mutants.reached import Reached
from clers.oracle.mutants.trial import Fate
from clers.oracle.mutants.unnoticed import Kind, Why, why

Step = Callable[[str], None]
MEMORY: Final = 4 << 30


@dataclass(frozen=True, slots=True)
class Chapter:
    """A chapter of the specification, the package that is its code, its tests."""

    name: str
    package: str
    tests: tuple[str, ...]


EXHAUSTIVE: Final = "tests/edgebreaker/test_exhaustive.py"
OF_EDGEBREAKER: Final = (
    "tests/edgebreaker/test_edgebreaker_laws.py",
    "tests/edgebreaker/test_grammar.py",
    "tests/edgebreaker/test_walk.py",
    f"{EXHAUSTIVE}::test_as_many_sphere_words_as_rooted_triangulations[5-3]",
    f"{EXHAUSTIVE}::test_as_many_sphere_words_as_rooted_triangulations[7-68]",
    f"{EXHAUSTIVE}::test_sphere_words_are_those_of_all_triangulations[6]",
)
"""Of those on all small surfaces three: the others take minutes where kernels are interpreted."""

_INPUT: Final = "tests/complexes/test_complexes_laws.py::test_law_holds"
_CONTEXT: Final = "tests/codes/test_context.py"
OF_KERNELS: Final = (
    "tests/kernels/test_tables.py",
    "tests/kernels/test_which_build.py::test_the_same_choice_in_this_process",
    "tests/kernels/test_which_build.py::test_the_digest_by_hand",
    f"{_INPUT}[index-lists-are-face-lists]",
    f"{_INPUT}[kernels-accept-what-clauses-accept]",
    f"{_INPUT}[kernels-refuse-what-clauses-refuse]",
    *OF_EDGEBREAKER,
    "tests/geometry/test_geometry_laws.py::test_law_of_surfaces_holds",
    "tests/arithmetic",
    "tests/codes/test_codes_that_learn.py",
    "tests/codes/test_trees.py",
    "tests/codes/test_enumerative.py",
    "tests/codes/test_handle_data.py",
    "tests/codes/test_closings.py",
    "tests/codes/test_codes.py::test_law[closings-definition]",
    "tests/codes/test_codes.py::test_law[closings-back-definition]",
    f"{_CONTEXT}::test_the_cube_by_hand",
    f"{_CONTEXT}::test_both_readings_of_the_examples",
    f"{_CONTEXT}::test_more_contexts_than_there_is_room_for",
    f"{_CONTEXT}::test_a_run_costs_no_less_than_a_reader_believes",
    f"{_CONTEXT}::test_symbols_that_no_loop_allows",
    f"{_CONTEXT}::test_where_a_recorded_s_can_be",
    f"{_CONTEXT}::test_truncated_and_trailing_bits",
    f"{_CONTEXT}::test_the_records_are_used",
    "tests/codes/test_codes.py::test_law[code-round-trip-context]",
    "tests/codes/test_codes.py::test_law[context-definition]",
)
"""Tests of the chapters whose loops the kernels are; of each kernel those that take least time."""

CHAPTERS: Final = (
    Chapter("1. Information", "clers.information", ("tests/information",)),
    Chapter("2. The arithmetic coder", "clers.arithmetic", ("tests/arithmetic",)),
    Chapter("3. Simplicial complexes", "clers.complexes", ("tests/complexes",)),
    Chapter("4. Operators", "clers.operators", ("tests/operators",)),
    Chapter("5. Edgebreaker", "clers.edgebreaker", OF_EDGEBREAKER),
    Chapter("6. Codes for words", "clers.codes", ("tests/codes",)),
    Chapter("7. Positions", "clers.geometry", ("tests/geometry",)),
    Chapter("8. The container", "clers.container", ("tests/container",)),
    Chapter("kernels", "clers.kernels", OF_KERNELS),
)
"""Kernels are the loops of chapters 2 to 7, and are counted beside them. Clause: ORCL-MUTANT-9."""


@dataclass(frozen=True, slots=True)
class Row:
    """A drawn mutant: its change by lines, what noticed it, or why nothing does if that is known.

    `by` is a test, or the id of a case; it is empty if neither tests nor cases noticed the change.
    `late` says that it was left by an earlier run, whose results were kept.
    Clause: ORCL-MUTANT-9.
    """

    module: str
    mutant: Mutant
    difference: str
    by: str
    case: bool = False
    why: Why | None = None
    late: bool = False


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
    def late(self) -> tuple[Row, ...]:
        """Those that something notices now, and nothing did when they were first tried."""
        return tuple(row for row in self.rows if row.by and row.late)

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

    Mutants that a test noticed before, as `before` has it, count as noticed, and are not tried;
    nor are those that it left and that are known to be equivalent. The others that it left are
    tried again, and are `late` whatever comes of it.
    """
    modules = of(chapter)
    root = chapter.package.split(".")[0]
    total, drawn = draw(modules, root, sample, seed)
    here = {(d.subject.module, d.mutant, difference(d.subject.source, d.mutant)) for d in drawn}
    same = [row for row in before if (row.module, row.mutant, row.difference) in here]
    known = [row if row.by else replace(row, why=why(row.module, row.difference)) for row in same]
    kept = [row for row in known if row.by or (row.why and row.why.kind is Kind.EQUIVALENT)]
    left = {(row.module, row.mutant) for row in known if row not in kept}
    done = {(row.module, row.mutant) for row in kept}
    rest = [d for d in drawn if (d.subject.module, d.mutant) not in done]
    if not rest:
        return Result(chapter, total, len(drawn), tuple(sorted(kept, key=_place)))
    plan = Plan(modules, root, chapter.tests, sample, seed, 1, MEMORY)
    report = over(plan, total, rest, step)
    if isinstance(report, str):
        return report
    rows = [_row(found, late=(found.module, found.mutant) in left) for found in report.judged]
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


def _row(found: Judged, *, late: bool) -> Row:
    """What the tests say of a mutant; and why nothing more may be said, if it is left."""
    noticed = found.fate in (ByTests.KILLED, ByTests.TIMED_OUT)
    by, known = (found.by or "time", None) if noticed else ("", why(found.module, found.difference))
    return Row(found.module, found.mutant, found.difference, by, why=known, late=late)


def _judged(row: Row, case: str) -> Row:
    if row.by:
        return row
    return replace(row, by=case, case=True, why=None) if case else row


def _place(row: Row) -> tuple[str, Mutant]:
    return row.module, row.mutant
