"""Writing a file whole or not at all; for everything that the tools write. Clause: TOOL-WRITE-4."""

import os
import secrets
import stat
from pathlib import Path

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected


def unwritable(detail: str) -> Rejected:
    """Why nothing was written. Clause: TOOL-WRITE-4."""
    return Rejected(Reason.UNWRITABLE_FILE, Clause.TOOL_WRITE_4, detail=detail)


def write_bytes(path: Path, data: bytes) -> Accepted[Path] | Rejected:
    """Give a file these bytes, or leave everything as it was; its path. Clause: TOOL-WRITE-4.

    An interrupt (Ctrl-C) goes on to the caller after the new file was removed.
    """
    try:
        target = Path(os.path.realpath(path))
        mode = target.stat().st_mode if target.exists() else None
        if mode is not None and not stat.S_ISREG(mode):
            return unwritable("a folder" if stat.S_ISDIR(mode) else "not a regular file")
        _replace(target, data, mode)
    except OSError as error:
        return unwritable(error.strerror or str(error))
    except ValueError as error:  # a name with a null byte
        return unwritable(str(error))
    return Accepted(path)


def _replace(target: Path, data: bytes, mode: int | None) -> None:
    """The new file is created with the permissions that the process gives to new files."""
    new = target.with_name(f".{target.name}.{secrets.token_hex(8)}.new")
    opened = os.open(new, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), 0o666)
    try:
        with os.fdopen(opened, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        if mode is not None:
            new.chmod(stat.S_IMODE(mode))
        new.replace(target)
    except BaseException:
        new.unlink(missing_ok=True)
        raise
    _flush_folder(target.parent)


def _flush_folder(folder: Path) -> None:
    """Bring the new name itself to the disk, where the system can."""
    try:
        opened = os.open(folder, os.O_RDONLY)
    except OSError:  # systems that do not open folders
        return
    try:
        os.fsync(opened)
    except OSError:  # file systems that do not flush folders; the name is in place all the same
        return
    finally:
        os.close(opened)
