"""`clers trace -o`: the walk as a picture; SVG or PNG by the file's suffix."""

from pathlib import Path
from typing import TYPE_CHECKING

import typer

from clers.cli.loading import taken

if TYPE_CHECKING:
    from clers.edgebreaker.stream import Encoding
    from clers.geometry.mesh import Mesh


def draw_into(
    out: Path, mesh: "Mesh", encoding: "Encoding", *, steps: str, layout: str, tree: bool
) -> None:
    """Draw the walk over a mesh into a file. Clauses: TOOL-PICTURE-1, TOOL-PICTURE-10."""
    from clers.meshfile.atomic import write_bytes
    from clers.pictures.draw import draw
    from clers.pictures.options import Layout, Options, steps_of
    from clers.pictures.png import to_png
    from clers.pictures.svg import to_svg

    if layout not in set(Layout):
        known = ", ".join(Layout)
        raise typer.BadParameter(f"{layout!r} is none of {known}", param_hint="--layout")
    if out.suffix.lower() not in (".svg", ".png"):
        raise typer.BadParameter(f"{out} ends neither in .svg nor in .png", param_hint="--out")
    chosen: tuple[int, ...] = ()
    if steps == "last":
        chosen = (mesh.surface.faces,)
    elif steps != "auto":
        text = f"0-{mesh.surface.faces}" if steps == "all" else steps
        chosen = taken(steps_of(text, mesh.surface.faces), out)
    options = Options(steps=chosen, layout=Layout(layout), tree=tree)
    picture = taken(draw(mesh.surface, encoding, mesh.positions, options), out)
    data = to_svg(picture).encode() if out.suffix.lower() == ".svg" else to_png(picture)
    taken(write_bytes(out, data), out)
