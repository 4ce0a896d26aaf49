"""Leaves a child that holds its output open, and ends."""

import subprocess
import sys

from good import Message, serve


def spoil(_: int, __: Message) -> None:
    child = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(3600)"])
    print(child.pid, file=sys.stderr, flush=True)
    sys.exit(9)


serve(spoil)
