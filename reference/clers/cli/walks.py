"""`clers word` and `clers trace`: what the walk writes, and how, step by step."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from clers.cli.loading import load, taken
from clers.cli.meshes import AsJson, Mesh
from clers.cli.output import json, line, note, progress, table

if TYPE_CHECKING:
    from clers.edgebreaker.stream import Encoding
    from clers.edgebreaker.trace import Entry


def word(mesh: Mesh, as_json: AsJson = False) -> None:
    """Print the CLERS word of a mesh, its handle data and the order of its vertices."""
    from clers.cli.views import word_view
    from clers.edgebreaker.encode import encode

    with progress("word", 2) as step:
        step("reading")
        surface = load(mesh, as_json=as_json).surface
        step("walking")
        view = word_view(encode(surface))
    if as_json:
        json(view)
        return
    line(f"word: {view.word}")
    line(f"components with boundary: {view.components_with_boundary}")
    if view.handles:
        table(["kind", "s", "at", "side"], [[h.kind, h.s, h.at, h.side] for h in view.handles])
    else:
        line("handle data: none")
    line(f"vertex order: {' '.join(map(str, view.vertex_order))}")


def trace(
    mesh: Mesh,
    out: Annotated[
        Path | None, typer.Option("--out", "-o", help="Draw the walk into this .svg or .png file.")
    ] = None,
    steps: Annotated[
        str, typer.Option(help="Draw these steps: 0,5,10-20, or all, or last.")
    ] = "auto",
    layout: Annotated[
        str, typer.Option(help="flat, view (from the side that shows most), ribbon, or auto.")
    ] = "auto",
    tree: Annotated[
        bool, typer.Option("--tree", help="Draw the dual tree and the primal remainder too.")
    ] = False,
    operators: Annotated[
        bool, typer.Option("--operators", help="Print the operators of the definition instead.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Show the walk step by step: symbol, gate, apex, stack; as text, JSON, or pictures."""
    # The pictures of the worked examples are drawn by this: TOOL-PAGE-2.
    from clers.edgebreaker.encode import encode
    from clers.edgebreaker.outline import outline
    from clers.edgebreaker.trace import trace as entries_of

    with progress("trace", 3) as step:
        step("reading")
        given = load(mesh, as_json=as_json)
        step("walking")
        encoding = encode(given.surface)
        entries = entries_of(
            given.surface, encoding, taken(outline(encoding.stream), mesh, as_json=as_json)
        )
        if out is not None:
            from clers.cli.drawing import draw_into

            step("drawing")
            draw_into(out, given, encoding, steps=steps, layout=layout, tree=tree)
            line(f"{out}: {len(entries)} faces")
            return
    if operators:
        _print_operators(mesh, encoding)
    elif as_json:
        json(entries)
    else:
        _print_entries(entries)


def _print_entries(entries: "tuple[Entry, ...]") -> None:
    heads = ["step", "symbol", "face", "gate", "apex", "stack", "χ", "new vertices", "records"]
    rows: list[list[object]] = []
    for k, e in enumerate(entries):
        opened = [f"opens {e.opens}"] if e.opens >= 0 else []
        records = ", ".join([*opened, *(f"closes {r}" for r in e.closes)])
        gate = f"{e.gate[0]}→{e.gate[1]}" if e.symbol != "P" else "–"
        new = " ".join(map(str, e.new))
        rows.append([k, e.symbol, e.face, gate, e.triangle[0], e.stack, e.euler, new, records])
    table(heads, rows)


LONGEST_FOLD = 20000


def _print_operators(path: Path, encoding: "Encoding") -> None:
    """The definition's fold, with the numbers of the growing surface. Clauses: EB-FOLD-1, -3."""
    from clers.conventions.result import and_then
    from clers.edgebreaker.definition import fold, steps

    if len(encoding.stream.word) > LONGEST_FOLD:
        note(f"clers: the definition is quadratic; over {LONGEST_FOLD} faces this takes long")
    found = taken(steps(encoding.stream), path)
    states = taken(and_then(steps(encoding.stream), fold), path)
    rows = [
        [k, " + ".join(map(repr, step)), s.euler, s.genus, len(s.loops), s.components]
        for k, (step, s) in enumerate(zip(found, states, strict=True))
    ]
    table(["step", "operators", "χ", "genus", "loops", "components"], rows)
