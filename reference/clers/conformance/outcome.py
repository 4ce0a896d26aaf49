"""What comes of a request to a foreign process: a sum, and nothing beside it. ORCL-RUN-1."""

from dataclasses import dataclass

from clers.conformance.messages import Rejection, Step
from clers.conformance.results import Result


@dataclass(frozen=True, slots=True)
class Answered:
    """The result, and the steps on the way to it. Clause: ORCL-REPLY-1."""

    result: Result
    steps: tuple[Step, ...] = ()


@dataclass(frozen=True, slots=True)
class Declined:
    """The adapter says that the input is bad. Clause: ORCL-REPLY-2."""

    rejection: Rejection
    steps: tuple[Step, ...] = ()


@dataclass(frozen=True, slots=True)
class Unsupported:
    """The adapter says that it does not do this. Clause: ORCL-REPLY-3."""

    cap: str


@dataclass(frozen=True, slots=True)
class Erred:
    """The adapter says that it failed. Clause: ORCL-REPLY-4."""

    message: str


@dataclass(frozen=True, slots=True)
class Crash:
    """The process ended: its exit code (negative: the signal), and the end of its standard error.

    None for a process that only closed its output. Clause: ORCL-RUN-5.
    """

    code: int | None
    errors: str


@dataclass(frozen=True, slots=True)
class TimedOut:
    """No terminal reply in so many seconds. Clauses: ORCL-RUN-2, ORCL-RUN-3."""

    seconds: float
    errors: str


@dataclass(frozen=True, slots=True)
class ProtocolError:
    """What the process wrote is no reply to the request. Clauses: ORCL-RUN-4, ORCL-RUN-8.

    `why` says what is wrong, `hint` what may be the cause, `start` is the start of the line.
    """

    why: str
    hint: str
    start: str


@dataclass(frozen=True, slots=True)
class NoProcess:
    """There is nobody to ask. Clause: ORCL-RUN-6."""

    why: str
    errors: str = ""


Broken = Crash | TimedOut | ProtocolError
"""After these the process is ended. Clause: ORCL-RUN-3."""

Given = Answered | Declined | Unsupported | Erred
"""What a process says in a terminal reply."""

Second = Given | Broken | NoProcess
"""What comes of asking one process once."""


@dataclass(frozen=True, slots=True)
class Flaky:
    """A process ended, and a new one, asked the same, did not: what came of it. ORCL-RUN-5."""

    first: Crash
    then: Given | TimedOut | ProtocolError


Outcome = Second | Flaky
