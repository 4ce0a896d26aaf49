"""`clers operators`: scripts that build meshes, what each step changes, and pictures of it."""

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from clers.cli.loading import load, taken
from clers.cli.meshes import AsJson, Mesh
from clers.cli.output import json, line, note, progress, reject, table, where_record

if TYPE_CHECKING:
    from clers.complexes.simplicial import Complex
    from clers.complexes.surface import Surface
    from clers.conventions.result import Rejected
    from clers.operators.families import AnyScript, Stage
    from clers.operators.sheets.operator import Script

app = typer.Typer(no_args_is_help=True, help="Scripts of Euler, handle and other operators.")

ScriptFile = Annotated[
    Path, typer.Argument(help="A script: operators, one a line or between semicolons; - is stdin.")
]
Start = Annotated[
    Path | None, typer.Option(help="Begin on this mesh, or complex (.json), not on nothing.")
]
By = Literal["handles", "euler", "word"]

LONG = 2000
"""Over so many faces a script takes long, for the operators are applied by their definition."""


@app.command()
def build(
    mesh: Mesh,
    by: Annotated[
        By, typer.Option(help="Handle operators, Euler operators alone, or the Edgebreaker walk.")
    ] = "handles",
    apart: Annotated[bool, typer.Option("--apart", help="Then take it apart again.")] = False,
    as_json: AsJson = False,
) -> None:
    """Print a script that makes the surface of a mesh from nothing."""
    from clers.operators.sheets.operator import taken_apart
    from clers.operators.sheets.text import write

    with progress("build", 2) as step:
        step("reading")
        surface = load(mesh, as_json=as_json).surface
        if surface.faces > LONG:
            note(f"clers: scripts are made in quadratic time; over {LONG} faces this takes long")
        step("building")
        script = _built(surface, by, mesh, as_json=as_json)
        if apart:
            script = (*script, *taken_apart(script))
    lines = [write((operator,)) for operator in script]
    if as_json:
        json(lines)
        return
    for text in lines:
        line(text)


def _built(surface: "Surface", by: By, mesh: Path, *, as_json: bool) -> "Script":
    """The script by one of the three ways. Clause: TOOL-OPERATORS-1."""
    from clers.operators.sheets.build import build as decomposed
    from clers.operators.sheets.euler import euler

    if by == "word":
        from clers.edgebreaker.encode import encode
        from clers.edgebreaker.on_sheets import on_sheets

        return taken(on_sheets(encode(surface).stream), mesh, as_json=as_json)
    script = decomposed(surface)
    return script if by == "handles" else taken(euler(script), mesh, as_json=as_json)


@dataclass(frozen=True, slots=True)
class StageView:
    """A stage as JSON has it. Clause: TOOL-OPERATORS-2."""

    operator: str
    numbers: dict[str, int]
    idle: str = ""


@app.command()
def apply(script: ScriptFile, start: Start = None, as_json: AsJson = False) -> None:
    """Run a script and print the numbers after each step."""
    stages, fault = _stages(script, start, as_json=as_json)
    if as_json:
        _print_json(script, stages, fault)
    elif stages:
        _print_table(stages)
    if fault is not None and not as_json:
        reject(str(script), fault)


def _print_table(stages: "tuple[Stage, ...]") -> None:
    """One row a stage; a number that a stage does not have is 0, as of a dimension too high."""
    heads = list(dict.fromkeys(name for stage in stages for name, _ in stage.numbers))
    idle = any(stage.idle for stage in stages)
    rows: list[list[object]] = []
    for k, stage in enumerate(stages):
        numbers = dict(stage.numbers)
        rows.append([k, stage.operator or "–", *(numbers.get(name, 0) for name in heads)])
        if idle:
            rows[-1].append(stage.idle)
    table(["step", "operator", *heads, *(["nothing done"] if idle else [])], rows)


def _print_json(script: Path, stages: "tuple[Stage, ...]", fault: "Rejected | None") -> None:
    from clers.cli.output import Exit, stop

    views = [StageView(stage.operator, dict(stage.numbers), stage.idle) for stage in stages]
    document: dict[str, object] = {"source": str(script), "stages": views}
    if fault is not None:
        document["reject"] = {
            "class": fault.fault,
            "reason": str(fault.reason),
            "at": where_record(fault.where),
            "clause": fault.clause,
            "detail": fault.detail,
        }
    json(document)
    if fault is not None:
        stop(Exit.NOT_CONFORMING)


def _stages(
    script: Path, start: Path | None, *, as_json: bool = False
) -> "tuple[tuple[Stage, ...], Rejected | None]":
    from clers.operators.families import stages

    read = _script(script, as_json=as_json)
    begun = None if start is None else _start(start, as_json=as_json)
    with progress("operators", 1) as step:
        step("applying")
        return stages(read, begun)


def _script(script: Path, *, as_json: bool) -> "AnyScript":
    """The script in a file or on standard input."""
    from clers.conventions.result import Accepted, and_then
    from clers.meshfile.reading import contents
    from clers.operators.families import read

    if str(script) == "-":
        return taken(read(sys.stdin.read()), script, as_json=as_json)
    text = and_then(contents(script), lambda data: Accepted(data.decode(errors="replace")))
    return taken(and_then(text, read), script, as_json=as_json)


def _start(start: Path, *, as_json: bool) -> "Surface | Complex":
    """A complex in JSON, or the surface of a mesh."""
    from clers.complexes.complex_text import read_complex
    from clers.conventions.result import and_then
    from clers.meshfile.reading import contents

    if start.suffix.lower() == ".json":
        text = and_then(contents(start), lambda data: read_complex(data.decode(errors="replace")))
        return taken(text, start, as_json=as_json)
    return load(start, as_json=as_json).surface


@app.command()
def draw(
    script: ScriptFile,
    out: Annotated[Path, typer.Option("--out", "-o", help="The .svg or .png file to write.")],
    start: Start = None,
) -> None:
    """Draw what is there after each step of a script."""
    from clers.meshfile.atomic import write_bytes
    from clers.pictures.png import png_of
    from clers.pictures.stage_scene import stage_scene
    from clers.pictures.stages import drawable
    from clers.pictures.svg import svg_of

    if out.suffix.lower() not in (".svg", ".png"):
        raise typer.BadParameter(f"{out} ends neither in .svg nor in .png", param_hint="--out")
    stages, fault = _stages(script, start)
    if fault is not None:
        reject(str(script), fault)
    seen = taken(drawable(stages), script)
    scene = stage_scene(stages, seen)
    data = svg_of(scene).encode() if out.suffix.lower() == ".svg" else png_of(scene)
    taken(write_bytes(out, data), out)
    line(f"{out}: {len(stages)} stages")
