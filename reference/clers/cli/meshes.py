"""`clers encode`, `decode` and `info`: meshes to files and back, and what is in them.

Clauses: TOOL-ENCODE-1, TOOL-ENCODE-2, TOOL-INFO-1.
"""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from clers.cli.loading import SUFFIX, load, taken
from clers.cli.output import json, line, note, progress, table

if TYPE_CHECKING:
    from clers.cli.views import FileView, InfoView
    from clers.container.options import Accuracy

AsJson = Annotated[bool, typer.Option("--json", help="Print JSON.")]
Mesh = Annotated[Path, typer.Argument(help="A PLY, OFF, OBJ, STL or .clers file.")]


def _accuracy(positions: str) -> "Accuracy":
    """`exact`, or `qN` for N bits an axis. Clause: TOOL-ENCODE-2."""
    from clers.container.options import Exact, InBits

    if positions == "exact":
        return Exact()
    if positions.startswith("q") and positions[1:].isdecimal() and 1 <= int(positions[1:]) <= 30:
        return InBits(int(positions[1:]))
    raise typer.BadParameter(
        f"{positions!r} is neither exact nor q1 … q30", param_hint="--positions"
    )


def encode(
    mesh: Mesh,
    out: Annotated[Path, typer.Option("--out", "-o", help="The .clers file to write.")],
    code: Annotated[
        str, typer.Option(help="The code of the word; `clers info` says what it promises.")
    ] = "best",
    positions: Annotated[
        str, typer.Option(help="exact, qN (N bits an axis, 1 to 30), or none.")
    ] = "exact",
    as_json: AsJson = False,
) -> None:
    """Compress a mesh into a .clers file."""
    from clers.cli.views import file_view
    from clers.codes.registry import CodeName
    from clers.container import file
    from clers.container.options import Exact, Options
    from clers.meshfile.atomic import write_bytes

    if code not in set(CodeName):
        known = ", ".join(CodeName)
        raise typer.BadParameter(f"{code!r} is none of {known}", param_hint="--code")
    accuracy = Exact() if positions == "none" else _accuracy(positions)
    with progress("encode", 3) as step:
        step("reading")
        given = load(mesh, as_json=as_json)
        placed = None if positions == "none" else given.positions
        step("encoding")
        data = taken(
            file.encode(given.surface, placed, Options(CodeName(code), accuracy)),
            mesh,
            as_json=as_json,
        )
        step("writing")
        taken(write_bytes(out, data), out, as_json=as_json)
    view = file_view(taken(file.inspect(data), out), len(data), given.surface)
    if as_json:
        json(view)
    else:
        lengths = ", ".join(f"{s.tag} {s.bytes}" for s in view.sections)
        line(f"{out}: {given.surface.faces} faces, {len(data)} bytes ({lengths})")


def decode(
    source: Annotated[Path, typer.Argument(help="A .clers file.", metavar="IN.clers")],
    out: Annotated[Path, typer.Option("--out", "-o", help="The mesh file to write.")],
    as_json: AsJson = False,
) -> None:
    """Decompress a .clers file into a mesh file; the suffix of OUT says which format."""
    from clers.cli.views import info_view
    from clers.complexes.face_list import FaceList
    from clers.container import file
    from clers.meshfile.mesh import unjudged
    from clers.meshfile.reading import contents
    from clers.meshfile.writing import write

    with progress("decode", 3) as step:
        step("reading")
        data = taken(contents(source), source, as_json=as_json)
        step("decoding")
        mesh = taken(file.decode(data), source, as_json=as_json)
        if mesh.positions is None:
            raise typer.BadParameter(f"{source} holds no positions, a mesh file needs them")
        faces = FaceList(tuple(mesh.surface.triangles()), mesh.surface.vertices)
        step("writing")
        taken(write(out, unjudged(faces, mesh.positions)), out, as_json=as_json)
    if as_json:
        json(info_view(mesh.surface))
    else:
        line(f"{out}: {mesh.surface.vertices} vertices, {mesh.surface.faces} faces")


def info(mesh: Mesh, as_json: AsJson = False) -> None:
    """Say what is in a mesh or a .clers file: counts, components, curves, genus, sections."""
    from clers.cli.views import file_view, info_view
    from clers.container.file import inspect
    from clers.meshfile.reading import contents

    with progress("info", 2) as step:
        step("reading")
        given = load(mesh, as_json=as_json)
        described: FileView | None = None
        if mesh.suffix.lower() == SUFFIX:
            data = taken(contents(mesh), mesh, as_json=as_json)
            found = taken(inspect(data), mesh, as_json=as_json)
            described = file_view(found, len(data), given.surface)
        step("counting")
        view = info_view(given.surface, described)
    if as_json:
        json(view)
        return
    _print_info(mesh, view)


def _print_info(path: Path, view: "InfoView") -> None:
    line(f"{path}: {view.vertices} vertices, {view.faces} faces, {len(view.components)} components")
    if view.file is not None:
        f = view.file
        line(
            f"version {f.version}, {f.bytes} bytes, code {f.code}, positions {f.positions}, "
            f"{f.symbols} symbols, {f.records} records, {f.components_with_boundary} with boundary"
        )
        most = "does not apply here" if f.most_bits is None else f"{f.most_bits} bits here"
        line(f"guarantee of {f.code}: {f.guarantee}; {most}")
        table(["section", "bytes"], [[s.tag, s.bytes] for s in f.sections])
    shown = view.components[:20]
    rows = [
        [k, c.vertices, c.faces, c.edges, c.boundary_edges, c.curves, c.genus, c.euler]
        for k, c in enumerate(shown)
    ]
    heads = ["component", "vertices", "faces", "edges", "boundary", "curves", "genus", "χ"]
    table(heads, rows)
    if len(view.components) > len(shown):
        note(f"… and {len(view.components) - len(shown)} components more; --json has them all")
