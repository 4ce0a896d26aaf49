"""The most memory that coding a mesh takes, asked of processes that do nothing else."""

import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from clers.codes.registry import CodeName
from clers.measure.speed.contender import Given


@dataclass(frozen=True, slots=True)
class Memory:
    """Bytes per triangle: of the index list, and at most beside it, and of decoding. TOOL-SPEED-6.

    `encode` is beside the index list; `decode` includes the surface that is made.
    """

    code: str
    index_list: float
    encode: float
    decode: float


def memory(given: Given, code: CodeName) -> Memory:
    """The memory of a code on a mesh. Clause: TOOL-SPEED-6."""
    faces = given.surface.faces
    with TemporaryDirectory() as folder:
        indices, data = Path(folder, "indices"), Path(folder, "data")
        indices.write_bytes(given.indices.buffer)
        vertices = str(given.surface.vertices)
        listed, more = _ask("encode", code, vertices, str(indices), str(data))
        (back,) = _ask("decode", str(data))
    return Memory(code, listed / faces, more / faces, back / faces)


def _ask(*arguments: str) -> list[int]:
    done = subprocess.run(
        [sys.executable, "-m", "clers.measure.speed.peak", *arguments],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    return [int(word) for word in done.stdout.split()]
