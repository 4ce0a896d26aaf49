"""`clers generate`: surfaces drawn at random."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from clers.cli.loading import SUFFIX, taken
from clers.cli.output import line, progress

if TYPE_CHECKING:
    from clers.complexes.surface import Surface

app = typer.Typer(no_args_is_help=True, help="Draw surfaces at random.")


@app.callback()
def _generate() -> None:
    """Keep `sphere` a command of its own name while it is the only one."""


@app.command()
def sphere(
    vertices: Annotated[int, typer.Option("--vertices", "-n", min=4, help="How many vertices.")],
    seed: Annotated[int, typer.Option(min=0, help="The first seed.")] = 0,
    count: Annotated[int, typer.Option(min=1, help="How many spheres, each with a seed.")] = 1,
    out: Annotated[
        Path | None,
        typer.Option("--out", "-o", help="A .clers file, or a mesh file with made-up points."),
    ] = None,
) -> None:
    """Draw rooted triangulations of the sphere, each as likely as any other; print their words."""
    from clers.edgebreaker.encode import encode
    from clers.generate.uniform import uniform_sphere

    with progress("generate", count) as step:
        for k in range(count):
            step(f"seed {seed + k}")
            drawn = uniform_sphere(vertices, seed + k)
            if out is None:
                line(encode(drawn).stream.word)
                continue
            path = out if count == 1 else out.with_stem(f"{out.stem}-{k}")
            _write(path, drawn)
            line(f"{path}: {drawn.vertices} vertices, {drawn.faces} faces, seed {seed + k}")


def _write(path: Path, drawn: "Surface") -> None:
    """Connectivity alone into `.clers`, points on a spiral into a mesh file. TOOL-GENERATE-1."""
    from clers.complexes.corner_table import face_list
    from clers.container.file import encode
    from clers.conventions.result import and_then
    from clers.generate.spiral import spiral
    from clers.meshfile.atomic import write_bytes
    from clers.meshfile.mesh import unjudged
    from clers.meshfile.writing import write

    if path.suffix.lower() == SUFFIX:
        taken(and_then(encode(drawn), lambda data: write_bytes(path, data)), path)
    else:
        taken(write(path, unjudged(face_list(drawn), spiral(drawn))), path)
