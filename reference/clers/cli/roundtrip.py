"""`clers roundtrip`: meshes through the whole path, all promises checked. Clause: TOOL-ROUND-1."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from clers.cli.loading import SUFFIX, mesh_in
from clers.cli.output import Exit, json, line, progress, stop, table
from clers.conventions.result import Accepted, Rejected, and_then

if TYPE_CHECKING:
    from clers.container.trip import Trip
    from clers.geometry.mesh import Mesh

SUFFIXES = (".ply", ".off", ".obj", ".stl", SUFFIX)


@dataclass(frozen=True, slots=True)
class Row:
    """One mesh: where it was, and how it came back, or why it did not."""

    mesh: str
    trip: "Trip | None"
    rejected: str


def roundtrip(
    paths: Annotated[
        list[Path] | None, typer.Argument(help="Mesh files, or folders of them.")
    ] = None,
    random: Annotated[
        int, typer.Option(min=0, help="So many random meshes, half of them manifold3d solids.")
    ] = 0,
    seed: Annotated[int, typer.Option(help="The seed of the random meshes.")] = 0,
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON.")] = False,
) -> None:
    """Encode and decode meshes and check that each comes back: isomorphic, in order, bit-equal."""
    files = [file for path in paths or () for file in _files(path)]
    if not files and not random:
        raise typer.BadParameter("name a mesh, a folder with meshes in it, or --random N")
    rows: list[Row] = []
    with progress("roundtrip", len(files) + random) as step:
        for file in files:
            step(file.name)
            rows.append(_row(file.name, mesh_in(file)))
        for k, mesh in enumerate(_random_meshes(random, seed)):
            step(f"random {k}")
            rows.append(_row(f"random {k}", Accepted(mesh)))
    failed = [row for row in rows if row.trip is None]
    if as_json:
        json(rows)
    else:
        _print(rows[: len(files)] + [row for row in rows[len(files) :] if row.trip is None])
        if random:
            _print_reach(rows[len(files) :])
        line(
            f"{len(rows) - len(failed)} of {len(rows)} meshes came back: isomorphic, equal under "
            "the order of creation, positions bit for bit"
        )
    stop(Exit.NOT_CONFORMING if failed else Exit.CONFORMING)


def _row(name: str, mesh: "Accepted[Mesh] | Rejected") -> Row:
    """One mesh there and back."""
    from clers.container.options import Options
    from clers.container.trip import round_trip

    match and_then(mesh, lambda given: round_trip(given, Options())):
        case Accepted(trip):
            return Row(name, trip, "")
        case Rejected() as rejected:
            return Row(name, None, rejected.line())


def _random_meshes(count: int, seed: int) -> "tuple[Mesh, ...]":
    """Half from scripts of operators, half solids; positions with every kind of float."""
    if count == 0:
        return ()
    from clers.generate.meshes import meshes
    from clers.generate.sample import sample
    from clers.generate.solids import solids
    from clers.generate.surfaces import surfaces

    half = count // 2
    drawn = sample(meshes(surfaces()), count - half, seed)
    return (*drawn, *(sample(solids(), half, seed) if half else ()))


def _print_reach(rows: list[Row]) -> None:
    """What the random meshes reached."""
    trips = [row.trip for row in rows if row.trip is not None]
    if trips:
        line(
            f"random: genus to {max(t.genus for t in trips)}, "
            f"curves to {max(t.curves for t in trips)}, "
            f"components to {max(t.components for t in trips)}, "
            f"{min(t.faces for t in trips)} to {max(t.faces for t in trips)} faces"
        )


def _files(path: Path) -> list[Path]:
    """The file named, or the mesh files that lie directly in the folder named."""
    if not path.is_dir():
        return [path]
    return sorted(p for p in path.iterdir() if p.suffix.lower() in SUFFIXES)


def _print(rows: list[Row]) -> None:
    heads = ["mesh", "vertices", "faces", "components", "genus", "curves", "bits/triangle", "bytes"]
    cells: list[list[object]] = []
    for row in rows:
        t = row.trip
        if t is None:
            cells.append([row.mesh, row.rejected, *[""] * 6])
            continue
        bits = f"{8 * t.connectivity_bytes / t.faces:.3f}"
        cells.append([
            row.mesh, t.vertices, t.faces, t.components, t.genus, t.curves, bits, t.file_bytes
        ])  # fmt: skip
    whole = [cells_of for row, cells_of in zip(rows, cells, strict=True) if row.trip is not None]
    if whole:
        table(heads, whole)
    for row in rows:
        if row.trip is None:
            line(f"{row.mesh}: {row.rejected}")
