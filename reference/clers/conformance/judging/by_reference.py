"""A request with the reference's own answer: as a case, and as an outcome. Clause: ORCL-CASE-1."""

from typing import Final

import msgspec
from msgspec import Raw

from clers.conformance.cases.case import Case
from clers.conformance.cases.identity import named
from clers.conformance.lines import NoMessage, result_in
from clers.conformance.messages import EventReply, OkReply, Operation, RejectReply
from clers.conformance.outcome import Answered, Declined
from clers.conformance.serve import serve

UNNAMED: Final = "unnamed-aaaaaaaa"


def answered(request: Operation) -> tuple[Case, Answered | Declined] | None:
    """The case that a request is, and what the reference does with it; None if it is unsupported.

    The case holds no trace; the outcome has the steps that the request asks for.
    Clauses: ORCL-CASE-1, ORCL-CASE-2.
    """
    op = str(type(request).__struct_config__.tag)
    given = Raw(msgspec.json.encode(request.input))
    *events, end = serve(request)
    steps = tuple(event.ev for event in events if isinstance(event, EventReply))
    match end:
        case OkReply(ok=ok):
            result = result_in(op, ok)
            if isinstance(result, NoMessage):
                return None
            case = Case(id=UNNAMED, op=op, clauses=(), origin="generated", input=given, ok=ok)
            return named("reference", case), Answered(result, steps)
        case RejectReply(reject=rejection):
            case = Case(
                id=UNNAMED, op=op, clauses=(), origin="generated", input=given, reject=rejection
            )
            return named("reference", case), Declined(rejection)
        case _:
            return None
