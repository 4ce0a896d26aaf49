"""From raw meshes to files."""

from pathlib import Path

from clers.conventions.result import Accepted, Rejected, and_then
from clers.meshfile.atomic import write_bytes
from clers.meshfile.formats import format_of
from clers.meshfile.mesh import RawMesh
from clers.meshfile.rendering import render


def write(path: Path, mesh: RawMesh) -> Accepted[Path] | Rejected:
    """Write the file of a mesh, whole or not at all. Clauses: TOOL-READ-1, TOOL-WRITE-1 … -4."""
    return and_then(
        format_of(path),
        lambda known: and_then(render(known, mesh), lambda data: write_bytes(path, data)),
    )
