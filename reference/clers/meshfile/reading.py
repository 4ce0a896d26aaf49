"""From files and bytes to raw meshes."""

import stat
from pathlib import Path
from typing import Final, assert_never

from clers.complexes.face_list import DEFAULT_LIMITS, Limits
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.meshfile import obj, off, ply, stl
from clers.meshfile.faults import unreadable
from clers.meshfile.formats import Format, format_of
from clers.meshfile.mesh import RawMesh

LONGEST: Final = 1 << 32


def read(path: Path, limits: Limits = DEFAULT_LIMITS) -> Accepted[RawMesh] | Rejected:
    """The mesh that a file says, nothing repaired. Clauses: TOOL-READ-1 … TOOL-READ-9."""
    return and_then(
        format_of(path),
        lambda known: and_then(contents(path), lambda data: parse(known, data, limits)),
    )


def parse(
    known: Format, data: bytes, limits: Limits = DEFAULT_LIMITS
) -> Accepted[RawMesh] | Rejected:
    """The mesh that a file's bytes say; pure. Clauses: TOOL-READ-2 … TOOL-READ-9."""
    match known:
        case Format.PLY:
            return ply.parse(data, limits)
        case Format.OFF:
            return off.parse(data, limits)
        case Format.OBJ:
            return obj.parse(data, limits)
        case Format.STL:
            return stl.parse(data, limits)
        case _:
            assert_never(known)


def contents(path: Path, longest: int = LONGEST) -> Accepted[bytes] | Rejected:
    """The bytes of a regular file. Clauses: TOOL-READ-5, TOOL-READ-6.

    A device or a pipe could go on for ever, so it is not opened.
    """
    try:
        status = path.stat()
        if not stat.S_ISREG(status.st_mode):
            return unreadable("not a regular file")
        if status.st_size > longest:
            detail = f"{status.st_size} bytes, the limit is {longest}"
            return Rejected(Reason.TOO_MANY_BYTES, Clause.TOOL_READ_6, detail=detail)
        return Accepted(path.read_bytes())
    except OSError as error:
        return unreadable(error.strerror or str(error))
    except ValueError as error:  # a name with a null byte
        return unreadable(str(error))
