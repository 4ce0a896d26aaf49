"""`clers bench codecs`: meshes through codecs of other people, and what came back."""

from pathlib import Path
from typing import Annotated

import typer

from clers.cli.loading import taken
from clers.cli.options import AsJson
from clers.cli.output import json, line, note, progress, table

SUFFIXES = (".ply", ".off", ".obj", ".stl")
PAGE = ".md"


def codecs(
    paths: Annotated[
        list[Path] | None, typer.Argument(help="Mesh files, or folders of them.", exists=True)
    ] = None,
    out: Annotated[Path | None, typer.Option("--out", "-o", help="A page (.md) to write.")] = None,
    made: Annotated[bool, typer.Option(help="Send small meshes made for this, too.")] = True,
    as_json: AsJson = False,
) -> None:
    """What codecs of other people do to meshes, each difference on a small one. ORCL-CODEC-14."""
    from clers.meshfile.atomic import write_bytes
    from clers.oracle.codecs.given import files_of, in_files
    from clers.oracle.codecs.made import by_hand, loose
    from clers.oracle.codecs.page import cells, page
    from clers.oracle.codecs.settings import SETTINGS
    from clers.oracle.codecs.survey import steps_of, survey

    if out is not None and out.suffix.lower() != PAGE:
        raise typer.BadParameter(f"{out} is no {PAGE}", param_hint="--out")
    meshes, left = in_files(files_of(paths or [], SUFFIXES))
    given = (*meshes, *by_hand(), *loose()) if made else meshes
    with progress("codecs", steps_of(given, SETTINGS)) as step:
        found = survey(given, left, SETTINGS, step)
    words = [*map(str, paths or []), *([] if made else ["--no-made"])]
    if out is not None:
        command = " ".join(["clers bench codecs", *words, "-o", str(out)])
        taken(write_bytes(out, page(found, command).encode()), out)
    if as_json:
        json(found)
        return
    table(["mesh", "vertices", "faces", *found.settings], [cells(row) for row in found.rows])
    line("")
    for shown in found.shown:
        faces = " ".join("-".join(map(str, face)) for face in shown.smallest.faces)
        many = f"{len(shown.meshes)} meshes"
        line(f"{shown.setting}: {shown.finding}, {many}; smallest: {faces or 'no faces'}")
    for name in found.missing:
        note(f"{name}: its package is not installed")
    for file, why in found.left_out:
        note(f"{file}: {why}")
