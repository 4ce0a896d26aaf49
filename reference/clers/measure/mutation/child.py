"""Forked processes that run a task and answer with bytes."""

import os
import resource
import selectors
import signal
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from time import monotonic
from typing import Final, NoReturn

Task = Callable[[int], bytes]
"""What a child does, given the descriptor it answers on; it may also answer there itself."""

CHUNK: Final = 1 << 16


@dataclass(frozen=True, slots=True)
class Limits:
    """Bytes of address space, and seconds by the clock and of the processor."""

    memory: int
    seconds: float


@dataclass(slots=True)
class Child:
    """A running child, what it answered so far, and when it will be ended."""

    pid: int
    pipe: int
    answer: bytes
    deadline: float


def start(task: Task, limits: Limits) -> Child:
    """Fork a child that runs the task within limits, silently."""
    read, write = os.pipe()
    pid = os.fork()
    if pid == 0:
        os.close(read)
        _run(task, write, limits)
    os.close(write)
    return Child(pid, read, b"", monotonic() + limits.seconds)


def finish(child: Child) -> bytes:
    """End a child, if it still runs, and say what it answered."""
    os.kill(child.pid, signal.SIGKILL)
    os.waitpid(child.pid, 0)
    os.close(child.pipe)
    return child.answer


def answers(children: dict[Child, None] | list[Child]) -> Iterator[Child]:
    """Wait until children have answered or their time is over, and name these children."""
    with selectors.DefaultSelector() as selector:
        for child in children:
            selector.register(child.pipe, selectors.EVENT_READ, child)
        nearest = min((child.deadline for child in children), default=0.0)
        ready = {key.fd for key, _ in selector.select(max(0.0, nearest - monotonic()))}
    for child in children:
        if child.pipe in ready:
            piece = os.read(child.pipe, CHUNK)
            child.answer += piece
            if not piece:
                yield child
        elif child.deadline <= monotonic():
            yield child


def _run(task: Task, write: int, limits: Limits) -> NoReturn:
    """Do the task and end; nothing of the parent's must run after it."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    silence = os.open(os.devnull, os.O_RDWR)
    for descriptor in range(3):
        os.dup2(silence, descriptor)
    resource.setrlimit(resource.RLIMIT_AS, (limits.memory, limits.memory))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    try:
        answer = task(write)
        while answer:
            answer = answer[os.write(write, answer) :]
    finally:
        os._exit(0)
