"""One foreign process in a session of its own, its three pipes read and written without waiting."""

import os
import selectors
import signal
import subprocess
import sys
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from time import monotonic, sleep
from typing import Final

from clers.conformance import launcher
from clers.conformance.bounds import Bounds

CHUNK: Final = 1 << 16
TICK: Final = 0.05
"""Seconds between two looks at whether the process still runs."""

PATIENCE: Final = 0.5
"""Seconds that a process has to end after it closed its output, and its children after it."""


@dataclass(frozen=True, slots=True)
class Ended:
    """The process ended, or closed its output (code None)."""

    code: int | None


@dataclass(frozen=True, slots=True)
class Silent:
    """No whole line came in time."""


@dataclass(frozen=True, slots=True)
class Flooded:
    """More bytes came than are read for one request."""

    start: bytes


class Process:
    """A running program and what it wrote so far; private and mutable. Clauses: ORCL-RUN-3, -7."""

    __slots__ = (
        "_bounds", "_errors", "_out_open", "_popen", "_received", "_selector", "_unread", "_unsent"
    )  # fmt: skip

    def __init__(self, command: Sequence[str], bounds: Bounds) -> None:
        """Start the command; OSError where the system will not."""
        limited = (sys.executable, "-I", "-S", str(Path(launcher.__file__)), str(bounds.memory))
        self._popen = subprocess.Popen(
            (*limited, *command),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            bufsize=0,
            start_new_session=True,
        )
        self._bounds = bounds
        self._unsent = memoryview(b"")
        self._unread = bytearray()
        self._errors = bytearray()
        self._received = 0
        self._out_open = True
        self._selector = selectors.DefaultSelector()
        for pipe in (self._in, self._out, self._err):
            os.set_blocking(pipe, False)
        for pipe in (self._out, self._err):
            self._selector.register(pipe, selectors.EVENT_READ)

    @property
    def pid(self) -> int:
        """The process and its session."""
        return self._popen.pid

    @property
    def errors(self) -> str:
        """The end of what it wrote to standard error. Clause: ORCL-RUN-7."""
        return self._errors.decode(errors="replace")

    @property
    def _in(self) -> int:
        return self._popen.stdin.fileno() if self._popen.stdin is not None else -1

    @property
    def _out(self) -> int:
        return self._popen.stdout.fileno() if self._popen.stdout is not None else -1

    @property
    def _err(self) -> int:
        return self._popen.stderr.fileno() if self._popen.stderr is not None else -1

    def send(self, data: bytes) -> None:
        """Let this be written while lines are awaited; what is read counts anew from here."""
        self._unsent, self._received = memoryview(data), 0

    def line(self, deadline: float) -> bytes | Ended | Silent | Flooded:
        """The next whole line, without its end; or why there is none. Clauses: ORCL-RUN-2, -7.

        The system is asked whether the process still runs only after a tick in which nothing came.
        """
        looked = 0
        while True:
            end = self._unread.find(b"\n", looked)
            if end >= 0:
                line = bytes(self._unread[:end])
                del self._unread[: end + 1]
                return line
            if self._received > self._bounds.output:
                return Flooded(bytes(self._unread[:200]))
            looked = len(self._unread)
            if not self._out_open:
                return Ended(self._code())
            left = deadline - monotonic()
            if left <= 0:
                return Silent()
            if self._pump(min(left, TICK)) or self._popen.poll() is None:
                continue
            if not self._pump(0.0):
                return Ended(self._code())

    def waiting(self) -> bytes:
        """What was written though nobody asked; nothing is waited for. Clause: ORCL-RUN-4."""
        while self._out_open and len(self._unread) <= CHUNK and self._take(self._out):
            pass
        return bytes(self._unread)

    def unread(self) -> bytes:
        """What came along with the last line. Clause: ORCL-RUN-4."""
        return bytes(self._unread)

    def leave(self) -> int | None:
        """Close its input and wait: its exit code, or None if it stays. Clause: ORCL-BYE-1."""
        deadline = monotonic() + self._bounds.farewell
        while len(self._unsent) > 0 and monotonic() < deadline and self._popen.poll() is None:
            self._pump(TICK)
        if self._popen.stdin is not None:
            self._popen.stdin.close()
        with suppress(subprocess.TimeoutExpired):
            return self._popen.wait(max(0.0, deadline - monotonic()))
        return None

    def others(self) -> bool:
        """Whether any process of the group is left, a moment after the first ended. ORCL-BYE-1."""
        deadline = monotonic() + PATIENCE
        while monotonic() < deadline:
            try:
                os.killpg(self.pid, 0)
            except ProcessLookupError:
                return False
            sleep(TICK)
        return True

    def end(self) -> None:
        """End all processes of its group, and read no more than errors. ORCL-RUN-3, -9."""
        with suppress(ProcessLookupError):
            os.killpg(self.pid, signal.SIGKILL)
        self._popen.wait()
        while self._take(self._err):
            pass
        self._selector.close()
        for pipe in (self._popen.stdin, self._popen.stdout, self._popen.stderr):
            if pipe is not None:
                pipe.close()

    def _code(self) -> int | None:
        with suppress(subprocess.TimeoutExpired):
            return self._popen.wait(PATIENCE)
        return None

    def _pump(self, seconds: float) -> bool:
        """Move bytes through the pipes, waiting so long at most; whether any output came."""
        self._write()
        ready = {key.fd for key, _ in self._selector.select(seconds)}
        if self._err in ready:
            self._take(self._err)
        return self._out in ready and self._take(self._out)

    def _write(self) -> None:
        """As much as the pipe takes; while there is more, its room is waited for too."""
        if len(self._unsent) == 0:
            return
        try:
            self._unsent = self._unsent[os.write(self._in, self._unsent) :]
        except BlockingIOError:
            pass
        except BrokenPipeError:
            self._unsent = memoryview(b"")
        watched = self._in in self._selector.get_map()
        if len(self._unsent) > 0 and not watched:
            self._selector.register(self._in, selectors.EVENT_WRITE)
        if len(self._unsent) == 0 and watched:
            self._selector.unregister(self._in)

    def _take(self, pipe: int) -> bool:
        """Read some of a pipe; whether anything came."""
        try:
            piece = os.read(pipe, CHUNK)
        except BlockingIOError:
            return False
        if not piece:
            if pipe in self._selector.get_map():
                self._selector.unregister(pipe)
            self._out_open = self._out_open and pipe != self._out
            return False
        if pipe == self._err:
            self._errors += piece
            del self._errors[: -self._bounds.errors]
        else:
            self._unread += piece
            self._received += len(piece)
        return True
