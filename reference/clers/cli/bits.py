"""`clers bench bits` and `clers bench bounds`: what connectivity costs, beside peers and bounds."""

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from clers.cli.loading import SUFFIX, mesh_in, taken
from clers.cli.options import AsJson
from clers.cli.output import Exit, json, line, note, progress, stop, table
from clers.conventions.result import Accepted, Rejected, and_then

if TYPE_CHECKING:
    from clers.measure.bits.report import Given, Report
    from clers.oracle.pool.place import Place

SUFFIXES = (".ply", ".off", ".obj", ".stl", SUFFIX)
PLOTS = (".svg", ".png")
PAGE = ".md"
SEED = 1962
"""Tutte counted the triangulations of the sphere in that year."""

Paths = Annotated[list[Path] | None, typer.Argument(help="Mesh files, or folders of them.")]


def bits(
    paths: Paths = None,
    sphere: Annotated[
        int, typer.Option(min=0, help="A random sphere of so many faces (even, 4 or more), too.")
    ] = 0,
    out: Annotated[
        list[Path] | None, typer.Option("--out", "-o", help="A plot (.svg, .png) or a page (.md).")
    ] = None,
    workers: Annotated[int, typer.Option(min=1, help="Processes that measure.")] = 1,
    scheduler: Annotated[str, typer.Option(help="The address of a Dask scheduler.")] = "",
    as_json: AsJson = False,
) -> None:
    """Bits of connectivity per vertex and triangle: each code, beside peers and the limit."""
    from clers.cli.places import place_of
    from clers.measure.bits.report import STEPS, report
    from clers.oracle.pool.place import Local

    outs = out or []
    for name in outs:
        if name.suffix.lower() not in (*PLOTS, PAGE):
            raise typer.BadParameter(f"{name} is neither .svg, .png nor .md", param_hint="--out")
    files = _files(paths or [])
    if not files and not sphere:
        raise typer.BadParameter("name a mesh, a folder with meshes in it, or --sphere N")
    if sphere % 2 or sphere == 2:
        raise typer.BadParameter("a sphere has 4, 6, 8, … faces", param_hint="--sphere")
    place = place_of(workers, scheduler)
    if place == Local(1):
        with progress("bits", STEPS * (len(files) + bool(sphere))) as step:
            found = report(_given(files, sphere), step)
    else:
        found = _spread(files, sphere, place)
    for name in outs:
        taken(_write(name, found, _command(paths or [], sphere, name)), name)
    if as_json:
        json(found)
    else:
        _print(found)
    stop(Exit.NOT_CONFORMING if found.refused else Exit.CONFORMING)


def _spread(files: list[Path], sphere: int, place: "Place") -> "Report":
    """The same, each mesh by whom it comes to. Clause: TOOL-BITS-11."""
    from clers.cli.bits_spread import Item, report_of

    items = [Item(file.stem, file.resolve()) for file in files]
    if sphere:
        items.append(Item(f"sphere-{sphere}", None, sphere, SEED))
    with progress("bits", len(items)) as step:
        return report_of(items, place, step)


def _files(paths: list[Path]) -> list[Path]:
    """Files as they are; of a folder its meshes by name, not those of folders in it."""
    return [
        file
        for path in paths
        for file in (
            sorted(p for p in path.iterdir() if p.suffix.lower() in SUFFIXES)
            if path.is_dir()
            else [path]
        )
    ]


def _given(files: list[Path], sphere: int) -> "Iterator[Given]":
    for file in files:
        yield file.stem, and_then(mesh_in(file), lambda mesh: Accepted(mesh.surface))
    if sphere:
        from clers.measure.bits.spheres import random_sphere

        yield f"sphere-{sphere}", Accepted(random_sphere(sphere, SEED))


def _command(paths: list[Path], sphere: int, out: Path) -> str:
    words = [*map(str, paths), *(["--sphere", str(sphere)] if sphere else []), "-o", str(out)]
    return f"clers bench bits {' '.join(words)}"


def _write(out: Path, found: "Report", command: str) -> Accepted[Path] | Rejected:
    """The page or the plot, by the suffix. Clause: TOOL-BITS-9."""
    from clers.meshfile.atomic import write_bytes

    if out.suffix.lower() == PAGE:
        from clers.measure.bits.tables import page

        return write_bytes(out, page(found, command).encode())
    from clers.measure.bits.plot import figure, png, svg

    drawn = figure(found)
    return write_bytes(out, svg(drawn) if out.suffix.lower() == ".svg" else png(drawn))


def _print(found: "Report") -> None:
    from clers.measure.bits.tables import made_by, mean_line, tables

    line(made_by(found))
    if found.meshes:
        for each in tables(found):
            line("")
            line(each.title)
            table(each.heads, each.rows)
        line("")
        line(mean_line(found))
    for mesh in found.refused:
        note(f"{mesh.mesh}: {mesh.why}")


def bounds(
    paths: Paths = None,
    spheres: Annotated[int, typer.Option(min=1, help="How many random spheres.")] = 1000,
    seed: Annotated[int, typer.Option(help="The seed of the spheres.")] = SEED,
    out: Annotated[Path, typer.Option("--out", "-o", help="The plot, .svg or .png.")] = Path(
        "bounds.svg"
    ),
    as_json: AsJson = False,
) -> None:
    """Bits per triangle of random spheres and of meshes, beside what is guaranteed."""
    from clers.measure.bits.bounds import Bounds, on_meshes, on_spheres
    from clers.measure.bits.bounds_plot import drawn
    from clers.measure.bits.plot import png, svg
    from clers.meshfile.atomic import write_bytes

    if out.suffix.lower() not in PLOTS:
        raise typer.BadParameter(f"{out} is neither .svg nor .png", param_hint="--out")
    files = _files(paths or [])
    with progress("bounds", spheres + len(files)) as step:
        balls = on_spheres(spheres, seed, step)
        meshes, refused = on_meshes(_given(files, 0), step)
    found = Bounds(seed, balls, meshes, refused)
    figure = drawn(found)
    taken(write_bytes(out, svg(figure) if out.suffix.lower() == ".svg" else png(figure)), out)
    if as_json:
        json(found)
    else:
        line(f"{spheres} random spheres of 100 to 5000 faces, seed {seed}")
        heads = ["code", "guaranteed", "least", "mean", "most"]
        table(heads, [row.cells() for row in balls])
        for mesh in refused:
            note(f"{mesh.mesh}: {mesh.why}")
    stop(Exit.NOT_CONFORMING if refused else Exit.CONFORMING)
