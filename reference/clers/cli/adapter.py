"""`clers adapter`: the reference as an adapter, a doctor for others, and sources to start from."""

import sys
from pathlib import Path
from typing import Annotated

import typer

from clers.cli import codecs
from clers.cli.adapter_command import Command, words_of
from clers.cli.options import AsJson
from clers.cli.output import Exit, json, line, note, progress, stop, table

app = typer.Typer(
    no_args_is_help=True, rich_markup_mode=None, help="Programs that stand for an implementation."
)
app.command()(codecs.draco)
app.command()(codecs.meshoptimizer)
app.command()(codecs.files)


@app.command()
def reference() -> None:
    """Serve the reference on standard input and output, as an adapter. Clause: ORCL-SERVE-1."""
    from clers.conformance.adapter import loop

    loop(sys.stdin.buffer, sys.stdout.buffer)


@app.command()
def doctor(
    adapter: Command,
    seconds: Annotated[float, typer.Option(min=0.1, help="For each request, at least.")] = 5.0,
    start: Annotated[float, typer.Option(min=0.1, help="Seconds until hello is answered.")] = 30.0,
    memory: Annotated[int, typer.Option(min=1, help="MiB of address space.")] = 8192,
    as_json: AsJson = False,
) -> None:
    """Check that an adapter's plumbing holds, before anything is judged. Clause: ORCL-DOCTOR-1."""
    from clers.conformance.bounds import Bounds
    from clers.conformance.doctor import CHECKS, examine
    from clers.conformance.outcome import NoProcess

    words = words_of(adapter)
    bounds = Bounds(start=start, request=seconds, memory=memory << 20)
    with progress("doctor", len(CHECKS)) as step:
        found = examine(words, bounds, step)
    if isinstance(found, NoProcess):
        if as_json:
            json({"adapter": words, "why": found.why, "errors": found.errors})
        else:
            note(f"{adapter}: {found.why}")
            note(found.errors.rstrip())
        stop(Exit.ADAPTER)
    failed = sum(not finding.passed for finding in found)
    if as_json:
        json({"adapter": words, "failed": failed, "checks": found})
    else:
        rows = [[f.check, "ok" if f.passed else "FAILED", f.found] for f in found]
        table(["check", "", "found"], rows)
        line(f"{len(found) - failed} of {len(found)} checks passed")
    stop(Exit.NOT_CONFORMING if failed else Exit.CONFORMING)


@app.command()
def init(
    language: Annotated[str, typer.Argument(help="python, javascript, c, rust or go.")],
    into: Annotated[Path, typer.Option(help="The folder to write it into.")] = Path(),
) -> None:
    """Write the source of an adapter that does echo and nothing else. Clause: ORCL-STARTER-1."""
    from clers.conformance.starters import STARTERS, source

    if language not in STARTERS:
        raise typer.BadParameter(f"{language!r} is none of {', '.join(STARTERS)}")
    starter = STARTERS[language]
    path = into / starter.file
    into.mkdir(parents=True, exist_ok=True)
    try:
        with path.open("x", encoding="utf-8") as file:
            file.write(source(starter))
    except FileExistsError as fault:
        raise typer.BadParameter(f"{path} is already there") from fault
    line(f"{path}: written. Then:")
    for command in starter.commands:
        line(f"  {command}")
