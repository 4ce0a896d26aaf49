"""`clers bench speed`: how fast the path is, beside peers, and how time and memory grow."""

from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from clers.cli.loading import load, taken
from clers.cli.options import AsJson
from clers.cli.output import json, line, note, progress, table

if TYPE_CHECKING:
    from clers.measure.speed.contender import Given
    from clers.measure.speed.report import Speed

PAGE = ".md"
PLOTS = (".svg", ".png")


def speed(
    paths: Annotated[
        list[Path] | None, typer.Argument(help="Mesh files.", exists=True, dir_okay=False)
    ] = None,
    faces: Annotated[
        int, typer.Option(min=1000, help="Triangles of the largest meshes that are made.")
    ] = 1_000_000,
    rounds: Annotated[int, typer.Option(min=1, help="How often each codes each mesh.")] = 3,
    out: Annotated[Path | None, typer.Option("--out", "-o", help="A page (.md) to write.")] = None,
    plot: Annotated[Path | None, typer.Option(help="A plot (.svg, .png) to write.")] = None,
    as_json: AsJson = False,
) -> None:
    """Triangles per second there and back, beside peers; steps, ratios, memory, growth."""
    from clers.measure.kept import keep_freed_memory
    from clers.measure.speed.report import measure, spheres, steps_of

    if out is not None and out.suffix.lower() != PAGE:
        raise typer.BadParameter(f"{out} is no {PAGE}", param_hint="--out")
    if plot is not None and plot.suffix.lower() not in PLOTS:
        raise typer.BadParameter(f"{plot} is neither .svg nor .png", param_hint="--plot")
    files = paths or []
    read = _read(files, as_json)
    keep_freed_memory()
    with progress("speed", steps_of(len(files) + 2, faces, rounds)) as step:
        found = measure(chain(read, spheres(faces)), faces, rounds, step)
    _write(found, out, plot, _command(files, faces, rounds, out, plot))
    if as_json:
        json(found)
    else:
        _print(found)


def _read(files: list[Path], as_json: bool) -> "list[Given]":
    """The meshes of files, before anything is timed. TOOL-SPEED-1."""
    from clers.measure.speed.contender import given

    return [given(file.stem, load(file, as_json=as_json).surface) for file in files]


def _command(
    files: list[Path], faces: int, rounds: int, out: Path | None, plot: Path | None
) -> str:
    words = [*map(str, files), "--faces", str(faces), "--rounds", str(rounds)]
    words += [] if out is None else ["-o", str(out)]
    words += [] if plot is None else ["--plot", str(plot)]
    return f"clers bench speed {' '.join(words)}"


def _write(found: "Speed", out: Path | None, plot: Path | None, command: str) -> None:
    """The page and the plot. Clause: TOOL-SPEED-8."""
    from clers.meshfile.atomic import write_bytes

    if out is not None:
        from clers.measure.speed.tables import page

        taken(write_bytes(out, page(found, command).encode()), out)
    if plot is not None:
        from clers.measure.bits.plot import png, svg
        from clers.measure.speed.plot import figure

        drawn = figure(found)
        taken(write_bytes(plot, svg(drawn) if plot.suffix.lower() == ".svg" else png(drawn)), plot)


def _print(found: "Speed") -> None:
    from clers.measure.speed.tables import made_by, refused_lines, tables

    line(made_by(found.machine, found.rounds))
    for each in tables(found):
        line("")
        line(each.title)
        table(each.heads, each.rows)
    for told in refused_lines(found):
        note(told)
