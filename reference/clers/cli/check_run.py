"""A run of `clers check`: carried out, shown, written. Clauses: ORCL-REPORT-2 … ORCL-REPORT-8."""

from collections.abc import Mapping
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import typer

from clers.cli.output import Exit, json, line, note, progress, stop, table
from clers.conformance.cases.case import Case
from clers.conformance.judging.judged import GOOD
from clers.conventions.result import Rejected
from clers.meshfile.atomic import write_bytes
from clers.oracle.reports.grouped import summary
from clers.oracle.reports.report import Report
from clers.oracle.reports.texts import clause_texts
from clers.oracle.runs.baseline import Baseline, Stale, baseline_bytes, stale, written
from clers.oracle.runs.events import Came
from clers.oracle.runs.minutes import Ending, Minutes
from clers.oracle.runs.reports.asked import STREAMED, AskedFor, write
from clers.oracle.runs.reports.document import document
from clers.oracle.runs.reports.jsonl import Lines
from clers.oracle.runs.reports.terminal import blocks, tail
from clers.oracle.runs.run import Plan, run
from clers.oracle.runs.selection import Selected
from clers.oracle.suite.files import Suite

EXIT: Final[Mapping[Ending, Exit]] = {
    Ending.CONFORMS: Exit.CONFORMING,
    Ending.DOES_NOT: Exit.NOT_CONFORMING,
    Ending.UNSOUND: Exit.SELF_CHECK,
}
"""Clauses: ORCL-CHECK-4, ORCL-CHECK-5, TOOL-EXIT-1."""


@dataclass(frozen=True, slots=True)
class Task:
    """All that a run needs to know."""

    plan: Plan
    suite: Suite
    selected: Selected
    canaries: tuple[Case, ...]
    known: Baseline | None
    write_baseline: Path | None
    reports: tuple[AskedFor, ...]
    as_json: bool


def carry_out(task: Task) -> None:
    """Ask, print, write, and end with the run's code. Clauses: ORCL-CHECK-4, ORCL-REPORT-8."""
    minutes = Minutes(task.selected)
    interrupted = not _asked(task, minutes)
    report = _report(task, minutes)
    old = () if task.known is None else stale(task.suite, task.known)
    if task.as_json:
        json(document(report, minutes, old))
    else:
        _print(report, minutes, old)
    failed = _write(task, minutes, report)
    code = Exit.INTERRUPTED if interrupted else EXIT[minutes.ending()[0]]
    stop(code or Exit.NOT_CONFORMING if failed else code)


def _asked(task: Task, minutes: Minutes) -> bool:
    """Go through the run; whether it came to its end. Clauses: ORCL-REPORT-5, ORCL-REPORT-8."""
    cases = tuple(chosen.case for chosen in task.selected.chosen)
    with (
        _lines(task) as lines,
        progress("check", len(cases) + len(task.canaries)) as step,
        closing(run(task.plan, cases, task.canaries)) as events,
    ):
        failures = 0
        try:
            for event in events:
                minutes.take(event)
                if isinstance(event, Came):
                    lines.add(event.held)
                    failures += event.held.status not in GOOD
                step(f"{failures} failed" if failures else "")
        except KeyboardInterrupt:
            minutes.interrupt()
            return False
    return True


def _lines(task: Task) -> Lines:
    """The streamed reports, opened. Clause: ORCL-REPORT-5."""
    paths = tuple(asked.path for asked in task.reports if asked.kind == STREAMED)
    try:
        return Lines(paths)
    except OSError as fault:
        raise typer.BadParameter(str(fault), param_hint="--report") from fault


def _report(task: Task, minutes: Minutes) -> Report:
    """The run as a value. Clauses: ORCL-REPORT-1, ORCL-HTML-1."""
    return Report(
        suite=task.suite.manifest.suite,
        specification=task.suite.manifest.spec,
        adapter=task.plan.adapter.introduction,
        command=task.plan.adapter.command,
        rulings=minutes.rulings,
        notes={flag.name: f"{flag.mistake} {flag.matters}" for flag in task.suite.flags},
        unfinished=minutes.unfinished,
        texts=clause_texts(),
    )


def _print(report: Report, minutes: Minutes, old: tuple[Stale, ...]) -> None:
    """For people. Clauses: ORCL-REPORT-2, ORCL-BASELINE-4."""
    for text in blocks(report):
        line(text)
    table(*summary(report))
    for entry in old:
        line(f"known failure {entry.id}: {entry.fate}")
    for text in tail(report, minutes):
        line(text)


def _write(task: Task, minutes: Minutes, report: Report) -> bool:
    """The reports and the baseline; whether any could not be written. Clause: ORCL-REPORT-7."""
    found = [(asked.path, write(asked, report)) for asked in task.reports]
    if task.write_baseline is not None:
        failures = written(task.suite, minutes.raw, task.known)
        path = task.write_baseline
        found.append((path, write_bytes(path, baseline_bytes(failures))))
    failed = [(path, result) for path, result in found if isinstance(result, Rejected)]
    for path, result in failed:
        note(f"{path}: {result.line()}")
    return bool(failed)
