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

SUFFIXES = (".ply", ".off", ".obj", ".stl", SUFFIX)


@dataclass(frozen=True, slots=True)
class Row:
    """One mesh: where it was, and how it came back, or why it did not."""

    mesh: str
    trip: "Trip | None"
    rejected: str


def roundtrip(
    paths: Annotated[list[Path], typer.Argument(help="Mesh files, or folders of them.")],
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON.")] = False,
) -> None:
    """Encode and decode meshes and check that each comes back: isomorphic, in order, bit-equal."""
    from clers.container.options import Options
    from clers.container.trip import round_trip

    files = [file for path in paths for file in _files(path)]
    rows: list[Row] = []
    with progress("roundtrip", len(files)) as step:
        for file in files:
            step(file.name)
            match and_then(mesh_in(file), lambda mesh: round_trip(mesh, Options())):
                case Accepted(trip):
                    rows.append(Row(file.name, trip, ""))
                case Rejected() as rejected:
                    rows.append(Row(file.name, None, rejected.line()))
    failed = [row for row in rows if row.trip is None]
    if as_json:
        json(rows)
    else:
        _print(rows)
        line(f"{len(rows) - len(failed)} of {len(rows)} meshes came back: isomorphic, equal under "
             "the order of creation, positions bit for bit")  # fmt: skip
    stop(Exit.NOT_CONFORMING if failed or not rows else Exit.CONFORMING)


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
