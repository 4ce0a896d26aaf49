"""How much work is done, counted in lines that the interpreter executes, not in seconds.

Machine code has no lines: tests that count are marked `interpreted`.
"""

import sys
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from _typeshed import TraceFunction


def lines(work: Callable[[], object], package: str) -> int:
    """How many lines of files whose path names the package a piece of work executes."""
    return lines_by_file(work, package).total()


def lines_by_file(work: Callable[[], object], package: str) -> Counter[str]:
    """How many lines a piece of work executes in each file of a package, by the files' stems."""
    count: Counter[str] = Counter()

    def on_line(frame: FrameType, event: str, __: object) -> "TraceFunction | None":
        if event == "line":
            count[frame.f_code.co_filename] += 1
        return on_line

    def on_call(frame: FrameType, _: str, __: object) -> "TraceFunction | None":
        return on_line if package in frame.f_code.co_filename else None

    before = sys.gettrace()
    sys.settrace(on_call)
    try:
        work()
    finally:
        sys.settrace(before)
    return Counter({Path(file).stem: lines for file, lines in count.items()})
