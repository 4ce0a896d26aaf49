"""Memory that was freed is handed out again, where glibc is there to do it."""

import platform
import subprocess
import sys

TWICE = """
from resource import RUSAGE_SELF, getpagesize, getrusage
from clers.measure.kept import keep_freed_memory

def fresh() -> int:
    before = getrusage(RUSAGE_SELF).ru_minflt
    bytes(1) * (1 << 26)
    return (getrusage(RUSAGE_SELF).ru_minflt - before) * getpagesize()

kept = keep_freed_memory()
print(int(kept), fresh() >> 20, fresh() >> 20)
"""


def test_freed_memory_is_kept() -> None:
    """TOOL-SPEED-2: 64 MB taken once more are no fresh pages, or the library says it cannot."""
    done = subprocess.run([sys.executable, "-c", TWICE], capture_output=True, text=True, check=True)
    kept, first, second = map(int, done.stdout.split())
    assert kept == (platform.libc_ver()[0] == "glibc")
    assert first >= 60
    assert second <= (1 if kept else 70)
