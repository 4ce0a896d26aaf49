"""`python -m clers.cli.mutation clers.complexes --tests tests/complexes --sample 400`."""

import os
import signal
from collections import Counter
from pathlib import Path
from typing import Annotated

import msgspec
import typer

from clers.cli.output import Exit, line, note, progress, stop, table
from clers.measure.mutation.campaign import Plan, run
from clers.measure.mutation.outcome import Fate, Report
from clers.measure.mutation.sample import subjects


def main(
    modules: Annotated[list[str], typer.Argument(help="Modules, or packages for all of theirs.")],
    tests: Annotated[list[str] | None, typer.Option(help="Files or folders of tests.")] = None,
    without: Annotated[list[str] | None, typer.Option(help="Not modules of such a name.")] = None,
    sample: Annotated[int | None, typer.Option(min=1, help="Draw so many; else all.")] = None,
    seed: Annotated[int, typer.Option(help="Of the sample.")] = 1,
    workers: Annotated[int, typer.Option(min=1, help="Mutants tried at a time.")] = 1,
    memory: Annotated[int, typer.Option(min=256, help="MiB of address space for each.")] = 4096,
    json: Annotated[Path | None, typer.Option(help="Also write the report to this file.")] = None,
) -> None:
    """Change modules in one place at a time, and see whether some test fails."""
    found = subjects(modules, without or [])
    if isinstance(found, str):
        raise typer.BadParameter(f"no module {found}", param_hint="MODULES")
    roots = {name.split(".")[0] for name in modules}
    if len(roots) != 1 or not found:
        raise typer.BadParameter("modules of one package", param_hint="MODULES")
    plan = Plan(found, roots.pop(), tuple(tests or ["tests"]), sample, seed, workers, memory << 20)
    with progress("mutants", sample or 0) as step:
        report = run(plan, step)
    if isinstance(report, str):
        note(report)
        stop(Exit.SELF_CHECK)
    if json is not None:
        json.write_bytes(msgspec.json.format(msgspec.json.encode(report), indent=1))
    show(report)
    if not report.complete:
        stop(Exit.INTERRUPTED)


def show(report: Report) -> None:
    """Print the survivors, each with its change, then the counts. Clause: TOOL-MUTATION-5."""
    for mutant in report.judged:
        if mutant.fate in (Fate.SURVIVED, Fate.UNREACHED):
            line(f"{mutant.module}:{mutant.mutant.place} {mutant.mutant.kind} {mutant.fate}")
            line(mutant.difference)
    fates = Counter((mutant.module, mutant.fate) for mutant in report.judged)
    rows = [
        (name, *(fates[name, fate] for fate in Fate))
        for name in report.modules
        if any(fates[name, fate] for fate in Fate)
    ]
    table(("module", *Fate), rows)
    for name in report.left_out:
        line(f"left out, for it does not pass on the unchanged source: {name}")
    tried = len(report.judged)
    line(
        f"{tried} of {report.mutants} mutants, seed {report.seed}: {report.killed} killed, "
        f"{report.timed_out} timed out, {report.survived} survived, {report.unreached} unreached; "
        f"score {100 * report.score:.1f} %"
    )
    if not report.complete:
        line(f"interrupted: {report.sampled - tried} drawn mutants were not tried")


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    os.environ["CLERS_KERNELS"] = "interpreted"  # as their text stands, changed or not
    typer.run(main)
