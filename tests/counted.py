"""How much work is done, counted in lines that the interpreter executes, not in seconds."""

import sys
from collections.abc import Callable
from types import FrameType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from _typeshed import TraceFunction


def lines(work: Callable[[], object], package: str) -> int:
    """How many lines of files whose path names the package a piece of work executes."""
    count = 0

    def on_line(_: FrameType, event: str, __: object) -> "TraceFunction | None":
        nonlocal count
        count += event == "line"
        return on_line

    def on_call(frame: FrameType, _: str, __: object) -> "TraceFunction | None":
        return on_line if package in frame.f_code.co_filename else None

    before = sys.gettrace()
    sys.settrace(on_call)
    try:
        work()
    finally:
        sys.settrace(before)
    return count
