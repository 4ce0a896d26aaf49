"""How commands come by a mesh: any mesh file, or a `.clers` file; or one line and exit 1."""

from pathlib import Path
from typing import TYPE_CHECKING, Final, TypeVar

from clers.cli.output import reject
from clers.conventions.result import Accepted, Rejected, and_then

if TYPE_CHECKING:
    from clers.geometry.mesh import Mesh

T = TypeVar("T")

SUFFIX: Final = ".clers"


def load(path: Path, *, as_json: bool = False) -> "Mesh":
    """The mesh in a file, checked by chapters 3 and 7, or by chapter 8. Clause: TOOL-OUTPUT-2."""
    return taken(mesh_in(path), path, as_json=as_json)


def mesh_in(path: Path) -> "Accepted[Mesh] | Rejected":
    """The mesh in a file, `.clers` or a mesh file by its suffix."""
    from clers.container.file import decode
    from clers.meshfile.mesh import judged
    from clers.meshfile.reading import contents, read

    if path.suffix.lower() == SUFFIX:
        return and_then(contents(path), decode)
    return and_then(read(path), judged)


def taken(result: Accepted[T] | Rejected, path: Path, *, as_json: bool = False) -> T:
    """The value, or the rejection in one line that names the file, and exit 1."""
    if isinstance(result, Rejected):
        reject(str(path), result, as_json=as_json)
    return result.value
