"""Prints the most memory that coding a mesh once takes; run in a process of its own, once a way.

python -m clers.measure.speed.peak encode CODE VERTICES INDICES FILE
python -m clers.measure.speed.peak decode FILE
"""

import sys
from pathlib import Path

from clers.codes.registry import CodeName
from clers.complexes.corner_table import surface_of_indices
from clers.complexes.index_list import index_list
from clers.container import file
from clers.container.options import Options
from clers.conventions.result import and_then
from clers.measure.path import must
from clers.measure.peak import forget_peak, peak_bytes


def _anew() -> int:
    """The bytes that this process has now."""
    forget_peak()
    return peak_bytes()


def encoded(code: CodeName, vertices: int, indices: Path, out: Path) -> tuple[int, int]:
    """The bytes that the index list took, and at most were taken more. Clause: TOOL-SPEED-6."""
    start = _anew()
    given = must(index_list(indices.read_bytes(), vertices))
    listed = _anew()
    data = must(and_then(surface_of_indices(given), lambda s: file.encode(s, None, Options(code))))
    most = peak_bytes()
    out.write_bytes(data)
    return listed - start, most - listed


def decoded(path: Path) -> int:
    """The bytes that were taken at most, the surface included. Clause: TOOL-SPEED-6."""
    data = path.read_bytes()
    start = _anew()
    must(file.decode(data))
    return peak_bytes() - start


def main(arguments: list[str]) -> None:
    """Print what one way takes, in bytes."""
    match arguments:
        case ["encode", code, vertices, indices, out]:
            listed, more = encoded(CodeName(code), int(vertices), Path(indices), Path(out))
            sys.stdout.write(f"{listed} {more}\n")
        case ["decode", path]:
            sys.stdout.write(f"{decoded(Path(path))}\n")
        case _:
            raise SystemExit(2)


if __name__ == "__main__":
    main(sys.argv[1:])
