"""The domains that the laws of chapter 8 range over; `clers.generate` draws from them."""

from dataclasses import dataclass
from typing import Final

from clers.container.options import Options
from clers.conventions.law import Given
from clers.geometry.mesh import Mesh


@dataclass(frozen=True, slots=True)
class ToWrite:
    """A mesh and the options to write it with."""

    mesh: Mesh
    options: Options


@dataclass(frozen=True, slots=True)
class ToDamage:
    """A file to write, then a byte of it (by a number taken modulo its length) to change."""

    file: ToWrite
    place: int
    change: int


TO_WRITE: Final = Given(
    "meshes-to-write", "meshes with positions or without, and options for their file", ToWrite
)
TO_DAMAGE: Final = Given("files-to-damage", "a mesh to write, a byte, a change to it", ToDamage)
FILES: Final = Given(
    "files", "bytes: files as written, tampered with and sealed again, or mere noise", bytes
)
NUMBERS: Final = Given("stored-numbers", "integers that files store, small and large", int)
RAW_BYTES: Final = Given("raw-bytes", "a few bytes", bytes)
