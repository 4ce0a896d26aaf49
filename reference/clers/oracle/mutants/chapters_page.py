"""The page of the mutants of each chapter, in Markdown. Clause: ORCL-MUTANT-9."""

import platform
from collections import Counter
from collections.abc import Iterator, Sequence
from datetime import UTC, datetime
from typing import Final

from clers import __version__
from clers.oracle.mutants.by_chapter import Result, Row
from clers.oracle.mutants.unnoticed import Kind

HEAD: Final = (
    "| chapter | mutants | drawn | by its tests | else by cases | left "
    "| score at first | score | but equivalent |"
)


def page(
    results: Sequence[Result],
    sample: int,
    seed: int,
    *,
    cases: bool = True,
    kept: bool = False,
    commit: str = "",
) -> Iterator[str]:
    """The lines of the page: how it was made, a table of counts, what was noticed late or never.

    `kept`: were results of earlier runs at hand? `commit` is the last one that changed a package
    of a chapter, if that is known.
    """
    yield "# Mistakes that a tool makes, by chapter"
    yield ""
    yield (
        "One change of the reference at a time, drawn from all that the tool can make: do the "
        "tests and laws of the chapter notice it, or else the cases of the suite? What is changed, "
        "and how that is judged, is said in [evidence](../spec/09-evidence.md) and "
        "[tools](../spec/10-tools.md). This page was printed by"
    )
    yield ""
    asked = ("" if cases else " --no-cases") + (" --keep FOLDER" if kept else "")
    yield f"    python -m clers.cli.mutation_by_chapter --sample {sample} --seed {seed}{asked}"
    yield ""
    today = datetime.now(UTC)
    yield (
        f"clers {__version__}; {today.day} {today:%B %Y}; Python {platform.python_version()}, "
        f"{platform.system()} {platform.machine()}; kernels interpreted"
        + (f"; the packages as commit {commit} left them." if commit else ".")
    )
    yield ""
    yield HEAD
    yield "| --- " + "| ---: " * 8 + "|"
    for result in results:
        yield row_of(result.chapter.name, [result])
    if len(results) > 1:
        yield row_of("all", results)
    yield ""
    yield (
        "The score is the part of those drawn that tests or cases notice. In the last column those "
        "that are equivalent, as far as anybody can see, do not count. The score at first is "
        "without those that an earlier run had left (`--keep`), and that are noticed since: what "
        "does so is below. Where a package changes it has other mutants, and so another draw."
    )
    late = [row for result in results for row in result.late]
    if late:
        yield ""
        yield "## What was noticed late"
    for row in late:
        yield from shown(row, f"now by `{row.by}`")
    left = [row for result in results for row in result.left]
    if left:
        yield ""
        yield "## What nothing noticed"
    for row in left:
        yield from shown(row, reason(row))


def row_of(name: str, results: Sequence[Result]) -> str:
    """A row of the table: one chapter, or all together."""
    tried = sum(len(result.rows) for result in results)
    left = [row for result in results for row in result.left]
    kinds = Counter(None if row.why is None else row.why.kind for row in left)
    cells = (
        name,
        sum(result.mutants for result in results),
        tried,
        sum(result.by_tests for result in results),
        sum(result.by_cases for result in results),
        len(left),
        percent(tried - len(left) - sum(len(result.late) for result in results), tried),
        percent(tried - len(left), tried),
        percent(tried - len(left), tried - kinds[Kind.EQUIVALENT]),
    )
    return "| " + " | ".join(map(str, cells)) + " |"


def percent(part: int, whole: int) -> str:
    """A part in percent; nothing of nothing is all."""
    return f"{100 * part / whole:.1f} %" if whole else "100.0 %"


def reason(row: Row) -> str:
    """Why nothing noticed a change, if somebody has read it."""
    return "**not read yet**" if row.why is None else f"**{row.why.kind}**; {row.why.because}"


def shown(row: Row, what: str) -> Iterator[str]:
    """A change, and what became of it."""
    yield ""
    yield f"`{row.module}`: {what}"
    yield ""
    yield "```diff"
    yield row.difference
    yield "```"
