"""The formats of mesh files, and how a file's name tells which it is."""

from enum import StrEnum
from pathlib import Path
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected


class Format(StrEnum):
    """The formats read and written, by their suffixes. Clause: TOOL-READ-1."""

    PLY = "ply"
    OFF = "off"
    OBJ = "obj"
    STL = "stl"


_BY_SUFFIX: Final = {f".{known}": known for known in Format}


def format_of(path: Path) -> Accepted[Format] | Rejected:
    """The format that a file's name says. Clause: TOOL-READ-1."""
    known = _BY_SUFFIX.get(path.suffix.lower())
    if known is None:
        said = f"suffix {path.suffix!r}" if path.suffix else "no suffix"
        return unknown(f"{said}; known are {', '.join(_BY_SUFFIX)}")
    return Accepted(known)


def unknown(detail: str) -> Rejected:
    """A format, or a variant of one, that is not read or written. Clause: TOOL-READ-1."""
    return Rejected(Reason.UNKNOWN_FORMAT, Clause.TOOL_READ_1, detail=detail)
