"""Writing the files of a suite: only what changed, the manifest last. Clause: ORCL-SUITE-5."""

from collections.abc import Collection, Mapping
from pathlib import Path

from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.meshfile.atomic import write_bytes
from clers.oracle.suite.files import MANIFEST, fault, read_bytes


def present(folder: Path) -> tuple[str, ...]:
    """The paths of all files in a folder, within it, sorted; none if there is no folder."""
    return tuple(
        sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())
    )


def differing(
    folder: Path, files: Mapping[str, bytes], stale: Collection[str] = ()
) -> tuple[str, ...]:
    """The paths where a folder is not what it should be: other bytes, missing, or `stale` there.

    Clause: ORCL-SUITE-5.
    """
    other = {path for path in files if _bytes(folder, path) != files[path]}
    left = {path for path in stale if path not in files and (folder / path).is_file()}
    return tuple(sorted(other | left))


def _bytes(folder: Path, path: str) -> bytes | None:
    data = read_bytes(folder, path)
    return data.value if isinstance(data, Accepted) else None


def write_suite(
    folder: Path, files: Mapping[str, bytes], stale: Collection[str] = ()
) -> Accepted[tuple[str, ...]] | Rejected:
    """Make a folder hold these files, and no longer the `stale` ones; the paths that changed.

    Each file is written whole or not at all, the manifest after all others. What else the folder
    has stays. Clause: ORCL-SUITE-5.
    """
    changed = differing(folder, files, stale)
    for path in sorted(changed, key=lambda path: (path == MANIFEST, path)):
        target = folder / path
        try:
            if path not in files:
                target.unlink()
                continue
            target.parent.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            return fault(Reason.UNWRITABLE_FILE, path, str(error.strerror))
        written = write_bytes(target, files[path])
        if isinstance(written, Rejected):
            return fault(written.reason, path, written.detail)
    return Accepted(changed)
