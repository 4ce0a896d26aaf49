"""Prints the bytes per triangle that the path takes at its peak; run in a process of its own."""

import resource
import sys
from pathlib import Path
from typing import Final

from clers.generate.flat_families import sphere_of
from clers.measure.path import timed_path

STATUS: Final = Path("/proc/self/status")
FORGETTING: Final = Path("/proc/self/clear_refs")


def peak_bytes() -> int:
    """The most memory that this process has had so far.

    Linux counts what the parent had before the program started in `ru_maxrss`, but not in VmHWM.
    """
    if STATUS.exists():
        for line in STATUS.read_text().splitlines():
            if line.startswith("VmHWM:"):
                return 1024 * int(line.split()[1])
    unit = 1 if sys.platform == "darwin" else 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit


def forget_peak() -> None:
    """Let the peak begin anew with what this process has now, where the system can do that."""
    if FORGETTING.exists():
        FORGETTING.write_text("5")


def main() -> None:
    """Note the memory, make a mesh, walk the path, and say how much more was needed."""
    before = peak_bytes()
    mesh = sphere_of(int(sys.argv[1]))
    for _ in timed_path(mesh):
        pass
    sys.stdout.write(f"{(peak_bytes() - before) / mesh.faces}\n")


if __name__ == "__main__":
    main()
