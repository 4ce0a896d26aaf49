"""Kernels: the loops that all time goes into, over flat integers, compiled where that can be done.

A kernel is the one copy of its algorithm. It runs interpreted as it stands; when the package is
built where there is a C compiler, mypyc makes machine code of the same file (TOOL-BUILD-2).
Integers are of 64 bits there and wrap without a word, so each kernel says why its own cannot.

Machine code of another text than the one beside it is never run, and with the environment variable
CLERS_KERNELS=interpreted none is. The lines that a kernel executes are counted: what makes one
slower shows in a test (TOOL-BUILD-7). Clauses: TOOL-BUILD-1, TOOL-BUILD-3, TOOL-BUILD-4.
"""

import sys
from collections.abc import Sequence
from hashlib import sha256
from importlib.machinery import ModuleSpec, PathFinder
from importlib.util import spec_from_file_location
from os import environ
from pathlib import Path
from types import ModuleType
from typing import Final

HERE: Final = Path(__file__).parent
STAMP: Final = "compiled.sha256"
"""The file with the hash of the sources that were compiled."""


def digest(folder: Path) -> str:
    """The hash of all kernels' sources in a folder. Clause: TOOL-BUILD-3."""
    sources = sorted(path for path in folder.glob("*.py") if path.stem != "__init__")
    named = (path.name.encode() + b"\0" + path.read_bytes() + b"\0" for path in sources)
    return sha256(b"".join(named)).hexdigest()


def _compiled() -> bool:
    """Whether there is machine code of these very sources, and it is wanted.

    Clauses: TOOL-BUILD-3, TOOL-BUILD-4.
    """
    stamp = HERE / STAMP
    if environ.get("CLERS_KERNELS") == "interpreted" or not stamp.exists():
        return False
    return stamp.read_text("ascii").strip() == digest(HERE)


class _Sources:
    """Finds the sources of the kernels, whatever else lies beside them."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """The source of a kernel; of nothing else."""
        package, _, name = fullname.rpartition(".")
        source = HERE / f"{name}.py"
        return spec_from_file_location(fullname, source) if package == __name__ else None


COMPILED: Final = _compiled()
"""Whether the kernels are machine code. Clause: TOOL-BUILD-5."""

if not COMPILED:
    # Before those who would prefer machine code, after those who bring another source.
    sys.meta_path.insert(sys.meta_path.index(PathFinder), _Sources())
