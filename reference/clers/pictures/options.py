"""What a user may choose about a picture, and the reading of step lists."""

from dataclasses import dataclass
from enum import StrEnum
from re import fullmatch
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected


class Layout(StrEnum):
    """How faces come into the plane. Clause: TOOL-PICTURE-5."""

    AUTO = "auto"
    FLAT = "flat"
    VIEW = "view"
    RIBBON = "ribbon"


@dataclass(frozen=True, slots=True)
class Pointer:
    """What a picture points at, whatever of it is there. Clause: TOOL-PICTURE-14.

    Faces and vertices by number; `triangle`: three vertices that need not be those of a face.
    """

    faces: tuple[int, ...] = ()
    vertices: tuple[int, ...] = ()
    triangle: tuple[int, int, int] | None = None


NOWHERE: Final = Pointer()


@dataclass(frozen=True, slots=True)
class Options:
    """The choices; each has a default that suits the mesh. Clause: TOOL-PICTURE-10.

    `steps`: the states to show, by numbers of visited faces; none for the default. `view`: the
    direction that a view is seen from. `labels`: letters, vertex numbers. `tree`: the dual tree and
    the primal remainder. `size`: of a panel's longer side, in pixels. `pointer`: what to point at.
    """

    steps: tuple[int, ...] = ()
    layout: Layout = Layout.AUTO
    view: tuple[float, float, float] | None = None
    labels: bool | None = None
    tree: bool = False
    size: int | None = None
    pointer: Pointer = NOWHERE


DEFAULT: Final = Options()

SIZES: Final = range(40, 8001)
"""The sizes that a panel may have, in pixels."""


def steps_of(text: str, faces: int) -> Accepted[tuple[int, ...]] | Rejected:
    """Read a list like `0,5,10-20` of steps of a walk over that many faces: TOOL-PICTURE-10."""
    steps: set[int] = set()
    for item in text.split(","):
        form = fullmatch(r"\s*([0-9]{1,12})(?:-([0-9]{1,12}))?\s*", item)
        if form is None:
            detail = f"{item.strip()!r} is neither a number nor a range like 10-20"
            return Rejected(Reason.BAD_NUMBER, Clause.TOOL_PICTURE_10, detail=detail)
        low, high = int(form[1]), int(form[2] or form[1])
        if not low <= high <= faces:
            detail = f"{item.strip()} is not within 0-{faces}, upwards"
            return Rejected(Reason.NO_SUCH_STEP, Clause.TOOL_PICTURE_10, detail=detail)
        steps.update(range(low, high + 1))
    return Accepted(tuple(sorted(steps)))
