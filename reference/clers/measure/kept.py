"""Memory that was freed stays with the process, for what is measured next."""

import ctypes
import platform
from typing import Final

MOST_MAPPED: Final = -4
LEAST_TRIMMED: Final = -1
"""M_MMAP_MAX and M_TRIM_THRESHOLD of glibc's `mallopt`."""

GREATEST: Final = (1 << 31) - 1


def keep_freed_memory() -> bool:
    """Let the C library hand out again what was freed; whether it is one that can be told.

    Else a large array is fresh memory each time, of which the system clears page after page, and a
    small one is not: time per triangle rises where arrays pass 32 MB, by nothing that a coder does.
    Clause: TOOL-SPEED-2.
    """
    if platform.libc_ver()[0] != "glibc":
        return False
    tell = ctypes.CDLL(None).mallopt
    return bool(tell(MOST_MAPPED, 0) and tell(LEAST_TRIMMED, GREATEST))
