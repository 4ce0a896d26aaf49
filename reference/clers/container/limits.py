"""What a reader of files is willing to hold."""

from dataclasses import dataclass
from typing import Final

from clers.complexes.face_list import DEFAULT_LIMITS, Limits


@dataclass(frozen=True, slots=True)
class FileLimits:
    """The longest file, and the largest mesh in it. Clause: FILE-LIMIT-1."""

    bytes: int
    mesh: Limits


DEFAULT_FILE_LIMITS: Final = FileLimits(1 << 31, DEFAULT_LIMITS)
