"""Takes limits upon itself and becomes another program: LIMIT COMMAND ARGUMENT…

Run by its path, with nothing imported of the package, so that it is quick and safe after a fork.
Clauses: ORCL-RUN-7, ORCL-POOL-4.
"""

import os
import resource
import signal
import sys
from contextlib import suppress

PR_SET_PDEATHSIG = 1
"""Of Linux's prctl: the signal that a process gets when the one that started it ends."""


def end_with_the_parent() -> None:
    """Ask the system to end this process if its parent is killed, where it can. ORCL-POOL-4."""
    if sys.platform == "linux":
        with suppress(ImportError):  # a Python that was built without it
            import ctypes

            ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


def launch(memory: int, command: list[str]) -> None:
    """Limit the address space, forbid core files, and run the command instead of this program."""
    _, most = resource.getrlimit(resource.RLIMIT_AS)
    cap = memory if most == resource.RLIM_INFINITY else min(memory, most)
    resource.setrlimit(resource.RLIMIT_AS, (cap, cap))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    end_with_the_parent()
    try:
        os.execvp(command[0], command)
    except OSError as fault:
        sys.exit(f"{command[0]}: {fault.strerror}")


if __name__ == "__main__":
    launch(int(sys.argv[1]), sys.argv[2:])
