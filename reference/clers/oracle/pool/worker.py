"""A worker process: one item at a time through a pipe, so that a death is one item's death."""

import signal
from collections.abc import Callable, Generator, Iterable, Iterator
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass
from multiprocessing import get_context
from multiprocessing.connection import Connection
from types import FrameType
from typing import Final, Generic, TypeVar

A = TypeVar("A")
B = TypeVar("B")

PATIENCE: Final = 10.0
"""Seconds that a worker has to end its own children. Clause: ORCL-POOL-4."""


@dataclass(frozen=True, slots=True)
class Part(Generic[B]):
    """One of the results that the task made of an item."""

    result: B


@dataclass(frozen=True, slots=True)
class Done:
    """The task has no more results of the item."""


@dataclass(frozen=True, slots=True)
class Raised:
    """What the task raised: a fault of the program, to be raised in its turn."""

    fault: Exception


@dataclass(frozen=True, slots=True)
class Died:
    """The worker ended before it was done, with this code (negative: the signal)."""

    code: int | None


Message = Part[B] | Done | Raised


class Worker(Generic[A, B]):
    """A process that does one thing with what it is given. Private and mutable."""

    def __init__(self, task: Callable[[A], Iterable[B]]) -> None:
        """Interrupts from the keyboard do not reach it, not even while it starts. ORCL-POOL-4."""
        context = get_context("spawn")
        self.pipe, theirs = context.Pipe()
        self._process = context.Process(target=_work, args=(task, theirs), daemon=True)
        with _interrupts_held():
            self._process.start()
        theirs.close()

    def give(self, item: A) -> None:
        """Hand it an item; if it is dead, `taken` will say so."""
        with suppress(BrokenPipeError, ConnectionResetError):
            self.pipe.send(item)

    def taken(self) -> Message[B] | Died:
        """What it says next; after `Died` the worker is ended."""
        try:
            found: Message[B] = self.pipe.recv()
        except (EOFError, ConnectionResetError):
            return Died(self.end())
        return found

    def end(self, patience: float = 0.0) -> int | None:
        """End it, and let it end its own children first; its exit code. Clause: ORCL-POOL-4.

        One that has nothing to do ends by itself, for which it has so many seconds.
        """
        self.pipe.close()
        self._process.join(patience)
        self._process.terminate()
        self._process.join(PATIENCE)
        self._process.kill()
        self._process.join()
        return self._process.exitcode


@contextmanager
def _interrupts_held() -> Iterator[None]:
    """An interrupt waits until the body is done; who is started in it begins likewise."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _leave(number: int, frame: FrameType | None) -> None:
    """Asked to end: unwind, so that whatever the task has started is ended. ORCL-POOL-4.

    Once: who asks again must not disturb the unwinding.
    """
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    raise SystemExit(128 + number)


def _work(task: Callable[[A], Iterable[B]], pipe: "Connection[Message[B], A]") -> None:
    """What a worker does all day; it ends when nobody can give it anything any more."""
    signal.signal(signal.SIGTERM, _leave)
    signal.signal(signal.SIGINT, lambda *_: None)  # a handler is not inherited by children
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
    with suppress(EOFError, ConnectionResetError, BrokenPipeError):
        while True:
            with closing(_said(task, pipe.recv())) as messages:
                for message in messages:
                    _send(pipe, message)
    signal.signal(signal.SIGTERM, signal.SIG_IGN)  # it ends anyway


def _send(pipe: "Connection[Message[B], A]", message: Message[B]) -> None:
    """Say something; if nobody hears it, the task is ended, and nothing disturbs its ending."""
    try:
        pipe.send(message)
    except (BrokenPipeError, ConnectionResetError):
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        raise


def _said(task: Callable[[A], Iterable[B]], item: A) -> Generator[Message[B], None, None]:
    try:
        yield from map(Part, task(item))
    except Exception as fault:
        yield Raised(fault)
    else:
        yield Done()
