"""Asking, as a function: a process behind a session, or a function in this process."""

from collections.abc import Callable, Sequence
from typing import assert_never

from clers.conformance.lines import NoMessage, request_in, result_in
from clers.conformance.messages import (
    Call,
    ErrorReply,
    EventReply,
    OkReply,
    Operation,
    RejectReply,
    Reply,
    UnsupportedReply,
)
from clers.conformance.outcome import Answered, Declined, Erred, Outcome, ProtocolError, Unsupported
from clers.conformance.session import Asked

Ask = Callable[[Asked], Outcome]
"""What comes of a request, whoever is asked. Clause: ORCL-RUN-1."""

Answer = Callable[[Operation], Sequence[Reply]]
"""An implementation in this process: events, then one terminal reply. Clause: ORCL-REPLY-1."""


def asking(answer: Answer) -> Ask:
    """Ask a function as if it were a process, its request read from the line. ORCL-REPLY-1."""

    def ask(asked: Asked) -> Outcome:
        request = request_in(asked.line)
        if not isinstance(request, Call):
            return ProtocolError("no request of an operation", "", asked.line[:200].decode())
        *events, last = answer(request)
        steps = tuple(reply.ev for reply in events if isinstance(reply, EventReply))
        match last:
            case OkReply(ok=ok):
                result = result_in(asked.operation, ok)
                if isinstance(result, NoMessage):
                    return ProtocolError(f"a result of no form: {result.why}", "", "")
                return Answered(result, steps)
            case RejectReply(reject=rejection):
                return Declined(rejection, steps)
            case UnsupportedReply(unsupported=lacking):
                return Unsupported(lacking.cap)
            case ErrorReply(error=failure):
                return Erred(failure.message)
            case EventReply():
                return ProtocolError("events without a terminal reply", "", "")
            case _:
                assert_never(last)

    return ask
