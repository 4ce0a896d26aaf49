"""Takes limits upon itself and becomes another program: LIMIT COMMAND ARGUMENT…

Run by its path, with nothing imported of the package, so that it is quick and safe after a fork.
Clause: ORCL-RUN-7.
"""

import os
import resource
import sys


def launch(memory: int, command: list[str]) -> None:
    """Limit the address space, forbid core files, and run the command instead of this program."""
    _, most = resource.getrlimit(resource.RLIMIT_AS)
    cap = memory if most == resource.RLIM_INFINITY else min(memory, most)
    resource.setrlimit(resource.RLIMIT_AS, (cap, cap))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    try:
        os.execvp(command[0], command)
    except OSError as fault:
        sys.exit(f"{command[0]}: {fault.strerror}")


if __name__ == "__main__":
    launch(int(sys.argv[1]), sys.argv[2:])
