"""`clers check`: an adapter against the golden vectors. Clauses: ORCL-CHECK-1 … ORCL-CHECK-12."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from clers.cli.adapter_command import Command, words_of
from clers.cli.options import AsJson
from clers.cli.output import Exit, json, note, stop
from clers.cli.places import place_of

if TYPE_CHECKING:
    from clers.conformance.bounds import Bounds
    from clers.oracle.runs.baseline import Baseline
    from clers.oracle.runs.pieces import Adapter
    from clers.oracle.runs.reports.asked import AskedFor
    from clers.oracle.runs.selection import Selected, Selection
    from clers.oracle.suite.files import Suite

Many = list[str] | None


def check(
    adapter: Command,
    profile: Annotated[
        Many, typer.Option(metavar="NAME", help="Cases of this profile; repeatable.")
    ] = None,
    op: Annotated[
        Many, typer.Option(metavar="NAME", help="Cases of this operation; repeatable.")
    ] = None,
    clause: Annotated[
        Many, typer.Option(metavar="ID", help="Cases that cite this clause; repeatable.")
    ] = None,
    only: Annotated[
        Many, typer.Option(metavar="GLOB", help="Cases whose id matches; repeatable.")
    ] = None,
    baseline: Annotated[Path | None, typer.Option(help="A file of known failures.")] = None,
    write_baseline: Annotated[
        Path | None, typer.Option(help="Write the failures to this file.")
    ] = None,
    report: Annotated[
        Many,
        typer.Option(metavar="KIND=FILE", help="KIND: jsonl, junit, md or html; repeatable."),
    ] = None,
    vectors: Annotated[Path | None, typer.Option(help="The folder of a suite.")] = None,
    workers: Annotated[int, typer.Option(min=1, help="Processes that ask.")] = 2,
    scheduler: Annotated[str, typer.Option(help="The address of a Dask scheduler.")] = "",
    max_failures: Annotated[int, typer.Option(min=0, help="Stop after so many; 0: never.")] = 0,
    strict_reasons: Annotated[
        bool, typer.Option("--strict-reasons", help="Judge reasons, not only classes.")
    ] = False,
    canaries: Annotated[
        bool, typer.Option("--canaries", help="Ask wrong vectors too, which must fail.")
    ] = False,
    seconds: Annotated[float, typer.Option(min=0.1, help="For each request, at least.")] = 5.0,
    start: Annotated[float, typer.Option(min=0.1, help="Seconds until hello is answered.")] = 30.0,
    restarts: Annotated[int, typer.Option(min=1, help="Processes started anew, in all.")] = 200,
    memory: Annotated[int, typer.Option(min=1, help="MiB of address space.")] = 8192,
    as_json: AsJson = False,
) -> None:
    """Ask an adapter the cases of a suite, and say what came of each. Clause: ORCL-CHECK-1."""
    from clers.cli.check_run import Task, carry_out
    from clers.conformance.bounds import Bounds
    from clers.oracle.runs.baseline import Expected
    from clers.oracle.runs.run import Plan
    from clers.oracle.runs.selection import Selection

    command = words_of(adapter)
    reports = _reports(report or [])
    suite = _suite(vectors)
    names = (tuple(given or ()) for given in (profile, op, clause, only))
    selected = _selected(suite, Selection(*names))
    known = None if baseline is None else _known(baseline)
    place = place_of(workers, scheduler)
    bounds = Bounds(start=start, request=seconds, memory=memory << 20, restarts=restarts)
    said = _met(command, bounds, suite.manifest.suite, strict=strict_reasons, as_json=as_json)
    plan = Plan(said, place, Expected(known.known if known else ()).of, max_failures)
    songs = suite.canaries if canaries else ()
    carry_out(Task(plan, suite, selected, songs, known, write_baseline, reports, as_json))


def _reports(texts: list[str]) -> "tuple[AskedFor, ...]":
    from clers.oracle.runs.reports.asked import NoReport, asked_for

    found = asked_for(texts)
    if isinstance(found, NoReport):
        raise typer.BadParameter(found.why, param_hint="--report")
    return found


def _suite(folder: Path | None) -> "Suite":
    """The suite; one that is not as its manifest says is a fault of the oracle's own."""
    from clers.conventions.result import Rejected
    from clers.oracle.suite.files import DEFAULT, read_suite

    found = read_suite(folder or DEFAULT)
    if isinstance(found, Rejected):
        note(f"{folder or DEFAULT}: {found.line()}")
        stop(Exit.SELF_CHECK)
    return found.value


def _selected(suite: "Suite", selection: "Selection") -> "Selected":
    from clers.oracle.runs.selection import NotThere, select

    found = select(suite, selection)
    if isinstance(found, NotThere):
        raise typer.BadParameter(found.why)
    return found


def _known(path: Path) -> "Baseline":
    """Clause: ORCL-BASELINE-5."""
    from clers.conventions.result import Rejected
    from clers.oracle.runs.baseline import read_baseline

    found = read_baseline(path)
    if isinstance(found, Rejected):
        raise typer.BadParameter(f"{path}: {found.line()}", param_hint="--baseline")
    return found.value


def _met(
    command: list[str], bounds: "Bounds", suite: str, *, strict: bool, as_json: bool
) -> "Adapter":
    """The adapter, if it answers hello. Clause: ORCL-CHECK-10."""
    from clers.conformance.outcome import NoProcess
    from clers.oracle.runs.pieces import meet

    found = meet(command, bounds, strict_reasons=strict, suite=suite)
    if isinstance(found, NoProcess):
        if as_json:
            json({"command": command, "why": found.why, "errors": found.errors})
        else:
            note(f"{' '.join(command)}: {found.why}")
            note(found.errors.rstrip())
        stop(Exit.ADAPTER)
    return found
