"""Face lists: what a mesh file says, before anyone believes it is a surface."""

from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True, slots=True)
class FaceList:
    """An ordered list of oriented triangles over vertices 0 … vertices-1; nothing is checked yet.

    Clause: CPLX-INPUT-1.
    """

    faces: tuple[tuple[int, int, int], ...]
    vertices: int


@dataclass(frozen=True, slots=True)
class Limits:
    """The largest mesh a reader is willing to hold. Clause: CPLX-INPUT-3."""

    faces: int
    vertices: int


DEFAULT_LIMITS: Final = Limits(faces=1 << 26, vertices=1 << 26)
