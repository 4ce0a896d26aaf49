"""How tests start the deliberately bad adapters."""

import sys
import time
from pathlib import Path
from typing import Final

FOLDER: Final = Path(__file__).parent / "bad_adapters"


def bad(name: str, *arguments: str) -> tuple[str, ...]:
    """The command of a bad adapter."""
    return sys.executable, str(FOLDER / f"{name}.py"), *arguments


def runs(pid: int) -> bool:
    """Whether a process is there and no zombie."""
    try:
        stat = Path(f"/proc/{pid}/stat").read_text()
    except FileNotFoundError:
        return False
    return stat.rpartition(")")[2].split()[0] != "Z"


def is_gone(pid: int) -> bool:
    """Whether a process that was killed has ended; the system may need a moment."""
    deadline = time.monotonic() + 10
    while runs(pid) and time.monotonic() < deadline:
        time.sleep(0.01)
    return not runs(pid)
