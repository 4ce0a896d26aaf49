"""The rejections that the parsers of all formats share."""

from clers.complexes.face_list import Limits
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Rejected
from clers.conventions.where import WHOLE, AtByte, AtFace, Where


def unreadable(detail: str, where: Where = WHOLE) -> Rejected:
    """Content that is not of its format. Clause: TOOL-READ-5."""
    return Rejected(Reason.UNREADABLE_FILE, Clause.TOOL_READ_5, where, detail)


def bad_line(line: int, detail: str) -> Rejected:
    """A line, counted from 1, that is not of its format. Clause: TOOL-READ-5."""
    return unreadable(f"line {line}: {detail}")


def ends_early(at: int, detail: str) -> Rejected:
    """A binary file that ends before what it promised; `at` is its length. Clause: TOOL-READ-5."""
    return unreadable(detail, AtByte(at))


def not_a_triangle(face: int, corners: int) -> Rejected:
    """A face that is no triangle. Clause: TOOL-READ-4."""
    detail = f"{corners} corners"
    return Rejected(Reason.NOT_TRIANGLES, Clause.TOOL_READ_4, AtFace(face), detail)


def over_limit(vertices: int, faces: int, limits: Limits) -> Rejected | None:
    """Counts over the reader's limits. Clause: TOOL-READ-6."""
    for count, limit, name, reason in (
        (vertices, limits.vertices, "vertices", Reason.TOO_MANY_VERTICES),
        (faces, limits.faces, "faces", Reason.TOO_MANY_FACES),
    ):
        if count > limit:
            detail = f"{count} {name}, the limit is {limit}"
            return Rejected(reason, Clause.TOOL_READ_6, detail=detail)
    return None
