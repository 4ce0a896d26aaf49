"""Tasks for workers: they must stand in a module that a new process can import."""

import os
import signal
import time
from collections.abc import Iterator
from pathlib import Path


def double(number: int) -> tuple[int]:
    return (2 * number,)


def late_first(number: int) -> tuple[int]:
    """The first item takes longest, so that others are done before it."""
    time.sleep(0.3 if number == 0 else 0.0)
    return (number,)


def who(_: int) -> tuple[int]:
    time.sleep(0.05)
    return (os.getpid(),)


def fatal_seven(number: int) -> tuple[int]:
    """No worker survives item 7."""
    if number == 7:
        os.kill(os.getpid(), signal.SIGKILL)
    return (2 * number,)


def dies_at_once(number: int) -> tuple[int]:
    os.kill(os.getpid(), signal.SIGKILL)
    return (number,)


def dies_once(item: tuple[int, str]) -> Iterator[int]:
    """Twice and thrice the number. One worker ends over item 7, between the two results."""
    number, mark = item
    yield 2 * number
    if number == 7 and not Path(mark).exists():
        time.sleep(0.1)
        Path(mark).touch()
        os.kill(os.getpid(), signal.SIGKILL)
    yield 3 * number


def odd_ones_raise(number: int) -> Iterator[int]:
    yield number
    if number % 2:
        raise ValueError(f"{number} is odd")
    yield -number


def nothing_for_odd_ones(number: int) -> Iterator[int]:
    yield from (number,) * (number % 2 == 0) * 3


def lingers(mark: str) -> Iterator[str]:
    """Gives a result, then stays until it is ended, and says that too."""
    yield mark
    try:
        time.sleep(60)
        yield mark
    finally:
        Path(f"{mark}.ended").touch()


def waits(mark: str) -> Iterator[str]:
    """Says that it stands at a result, and whether it was ended there."""
    try:
        Path(mark).touch()
        while True:
            yield mark * 1000
    finally:
        Path(f"{mark}.ended").touch()
