"""An adapter to be asked: whatever it does, each request has one outcome, and time and space end.

with Session(("node", "adapter.js")) as session:
    outcome = session.ask(asked(1, MeshDecode(id=0, input=FileForm(hex="0a91"))))
"""

from collections.abc import Sequence
from dataclasses import dataclass
from time import monotonic
from types import TracebackType
from typing import Final, assert_never

import msgspec

from clers import SPEC_VERSION
from clers.conformance.bounds import DEFAULT_BOUNDS, Bounds
from clers.conformance.in_words import in_words
from clers.conformance.lines import NoMessage, line_of, reply_in, result_in
from clers.conformance.messages import (
    PROTOCOL,
    ErrorReply,
    EventReply,
    Hello,
    Introduction,
    OkReply,
    Operation,
    RejectReply,
    Step,
    Terminal,
    UnsupportedReply,
)
from clers.conformance.outcome import (
    Answered,
    Broken,
    Crash,
    Declined,
    Erred,
    Flaky,
    Given,
    NoProcess,
    Outcome,
    ProtocolError,
    Second,
    TimedOut,
    Unsupported,
)
from clers.conformance.process import Ended, Flooded, Process, Silent

PURE_OUTPUT: Final = "standard output carries the protocol only; print to standard error instead"


@dataclass(frozen=True, slots=True)
class Asked:
    """A request as it is sent: operation, id, whether events are wanted, and the line itself."""

    operation: str
    id: int
    traced: bool
    line: bytes


def asked(number: int, operation: Operation) -> Asked:
    """The request under this id. Clause: ORCL-REPLY-1."""
    numbered = msgspec.structs.replace(operation, id=number)
    name = str(type(operation).__struct_config__.tag)
    return Asked(name, number, operation.trace == "full", line_of(numbered))


def hello(suite: str = "") -> Asked:
    """The first request to a process. Clause: ORCL-HELLO-1."""
    return Asked("hello", 0, False, line_of(Hello(0, PROTOCOL, SPEC_VERSION, suite)))


BYE: Final = b'{"op":"bye"}\n'
"""Clause: ORCL-BYE-1."""


class Session:
    """A program that is asked, and started anew as often as it must be. Clauses: ORCL-RUN-1 … -9.

    The one place of the chapter with a life of its own: use it in a `with` statement.
    """

    def __init__(
        self, command: Sequence[str], bounds: Bounds = DEFAULT_BOUNDS, suite: str = ""
    ) -> None:
        """`suite` is the name of the suite that is asked, if one is. Clause: ORCL-HELLO-1."""
        self._hello = hello(suite)
        self._command = tuple(command)
        self._bounds = bounds
        self._process: Process | None = None
        self._introduction: Introduction | None = None
        self.starts = 0
        self.errors = ""

    def __enter__(self) -> "Session":
        """Nothing is started yet."""
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        """No process is left, whatever happened. Clause: ORCL-RUN-9."""
        self.end()

    @property
    def pid(self) -> int | None:
        """The process that runs now."""
        return None if self._process is None else self._process.pid

    def introduction(self) -> Introduction | NoProcess:
        """What the adapter says of itself; it is started if need be. Clause: ORCL-HELLO-2."""
        process = self._running()
        if isinstance(process, NoProcess):
            return process
        return self._introduction or NoProcess("it was not asked")

    def ask(self, request: Asked) -> Outcome:
        """What comes of a request. Total. Clauses: ORCL-RUN-1, ORCL-RUN-3, ORCL-RUN-5."""
        first = self._once(request)
        if not isinstance(first, Crash):
            return first
        second = self._once(request)
        match second:
            case Crash():
                return second
            case NoProcess():
                return first
            case _:
                return Flaky(first, second)

    def meet(self, request: Asked) -> Second:
        """Ask a new process something before any hello, and end it. Clause: ORCL-HELLO-3."""
        self.end()
        self.starts += 1
        try:
            process = Process(self._command, self._bounds)
        except OSError as fault:
            return NoProcess(f"it cannot be started: {fault}")
        self._process = process
        said = self._converse(process, request, self._bounds.start)
        self.end()
        return said

    def stray(self) -> bytes:
        """What came on standard output though no request is open. Clause: ORCL-RUN-4."""
        return b"" if self._process is None else self._process.waiting()

    def leave(self, *, say: bytes = BYE) -> tuple[int | None, bool]:
        """Say bye (or nothing): the exit code, or None; and whether it ended and left others.

        Clause: ORCL-BYE-1.
        """
        if self._process is None:
            return None, False
        self._process.send(say)
        code = self._process.leave()
        others = code is not None and self._process.others()
        self.end()
        return code, others

    def end(self) -> None:
        """End the process, if one runs, with its whole group. Clauses: ORCL-RUN-3, ORCL-RUN-9."""
        if self._process is not None:
            process, self._process = self._process, None
            process.end()
            self.errors = process.errors

    def _running(self) -> Process | NoProcess:
        """A process that has said hello. Clauses: ORCL-HELLO-1, ORCL-HELLO-4, ORCL-RUN-6."""
        if self._process is not None:
            return self._process
        if self.starts > self._bounds.restarts:
            return NoProcess(f"{self.starts} processes were started, no more are")
        self.starts += 1
        try:
            process = Process(self._command, self._bounds)
        except OSError as fault:
            return NoProcess(f"it cannot be started: {fault}")
        self._process = process
        said = self._converse(process, self._hello, self._bounds.start)
        why = self._greeted(said)
        if why is None:
            return process
        self.end()
        return NoProcess(why, self.errors)

    def _greeted(self, said: Given | Broken) -> str | None:
        """What is wrong with an answer to hello, if anything is. ORCL-HELLO-2, ORCL-HELLO-4."""
        if not isinstance(said, Answered) or not isinstance(said.result, Introduction):
            return f"no answer to hello: {in_words(said)}"
        if said.result.protocol != PROTOCOL:
            return f"it speaks protocol {said.result.protocol}, not {PROTOCOL}"
        if "echo" not in said.result.ops:
            return "it does not declare echo"
        if self._introduction not in (None, said.result):
            return f"it said hello otherwise than before: {in_words(said)}"
        self._introduction = said.result
        return None

    def _once(self, request: Asked) -> Second:
        process = self._running()
        if isinstance(process, NoProcess):
            return process
        early = process.waiting()
        if early:
            self.end()
            return _astray("a line that no request was open for", early)
        said = self._converse(process, request, self._bounds.seconds_for(request.line))
        if isinstance(said, Broken):
            self.end()
            if isinstance(said, Crash):
                return Crash(said.code, self.errors)
            if isinstance(said, TimedOut):
                return TimedOut(said.seconds, self.errors)
        return said

    def _converse(self, process: Process, request: Asked, seconds: float) -> Given | Broken:
        """Send a request and read its replies. Clauses: ORCL-LINE-2, ORCL-RUN-2 … ORCL-RUN-8."""
        deadline = monotonic() + seconds
        process.send(request.line)
        steps: list[Step] = []
        while True:
            line = process.line(deadline)
            match line:
                case Ended(code):
                    return Crash(code, process.errors)
                case Silent():
                    return TimedOut(seconds, process.errors)
                case Flooded(start):
                    return _astray(f"more than {self._bounds.output} bytes", start)
                case _:
                    reply = reply_in(line)
            if isinstance(reply, NoMessage):
                return _astray(f"a line that is no reply: {reply.why}", line)
            if reply.id != request.id:
                why = f"a reply with id {reply.id}, the request has id {request.id}"
                return ProtocolError(why, "one reply a request, with its id", _start(line))
            if not isinstance(reply, EventReply):
                more = process.unread()
                if more:
                    return _astray("more than one terminal reply", more)
                return _said(request.operation, reply, tuple(steps), line)
            if not request.traced:
                return ProtocolError("an event that was not asked for", "see trace", _start(line))
            steps.append(reply.ev)


def _said(
    operation: str, reply: Terminal, steps: tuple[Step, ...], line: bytes
) -> Given | ProtocolError:
    match reply:
        case OkReply(ok=ok):
            result = result_in(operation, ok)
            if isinstance(result, NoMessage):
                why = f"a result that {operation} does not have: {result.why}"
                return ProtocolError(why, "see clers schema protocol", _start(line))
            return Answered(result, steps)
        case RejectReply(reject=rejection):
            return Declined(rejection, steps)
        case UnsupportedReply(unsupported=lacking):
            return Unsupported(lacking.cap)
        case ErrorReply(error=failure):
            return Erred(failure.message)
        case _:
            assert_never(reply)


def _astray(why: str, line: bytes) -> ProtocolError:
    """Clause: ORCL-RUN-8."""
    hint = "see clers schema protocol" if line.lstrip().startswith(b"{") else PURE_OUTPUT
    return ProtocolError(why, hint, _start(line))


def _start(line: bytes) -> str:
    return line[:200].decode(errors="replace")
