"""The loop around `serve`: lines in, lines out, until bye. Clauses: ORCL-LINE-1, ORCL-LINE-2."""

from collections.abc import Callable
from typing import BinaryIO

import msgspec

from clers.conformance.lines import FAULTS, NoMessage, line_of, object_in, request_in
from clers.conformance.messages import (
    Bye,
    ErrorReply,
    Failure,
    Id,
    Lacking,
    Reply,
    Request,
    UnsupportedReply,
)
from clers.conformance.results import RESULTS
from clers.conformance.serve import serve

Server = Callable[[Request], tuple[Reply, ...]]
"""What answers requests: the reference, or a codec of somebody else."""


def answered(line: bytes, by: Server | None = None) -> tuple[Reply, ...] | Bye:
    """The replies to a line, whatever it is; or bye. Clauses: ORCL-REPLY-3, ORCL-REPLY-4."""
    request = request_in(line)
    match request:
        case NoMessage(why):
            return (_no_request(line, why),)
        case Bye():
            return request
        case _:
            return _guarded(request, by)


def _guarded(request: Request, by: Server | None) -> tuple[Reply, ...]:
    """What the code below does wrong is said and does not end the adapter. Clause: ORCL-REPLY-4."""
    try:
        return serve(request) if by is None else by(request)
    except Exception as fault:
        number = None if isinstance(request, Bye) else request.id
        return (ErrorReply(number, Failure(f"{type(fault).__name__}: {fault}")),)


def _no_request(line: bytes, why: str) -> Reply:
    """An operation that is not known, or a fault. Clauses: ORCL-REPLY-3, ORCL-REPLY-4."""
    keys = object_in(line)
    number = None if isinstance(keys, NoMessage) else _number_in(keys.get("id"))
    operation = None if isinstance(keys, NoMessage) else _text_in(keys.get("op"))
    known = operation in {*RESULTS, "hello", "bye"}
    if number is not None and operation is not None and not known:
        return UnsupportedReply(number, Lacking(operation))
    return ErrorReply(number, Failure(why))


def _text_in(raw: msgspec.Raw | None) -> str | None:
    try:
        return None if raw is None else msgspec.json.decode(raw, type=str)
    except FAULTS:
        return None


def _number_in(raw: msgspec.Raw | None) -> int | None:
    try:
        return None if raw is None else msgspec.json.decode(raw, type=Id)
    except FAULTS:
        return None


def loop(requests: BinaryIO, replies: BinaryIO, by: Server | None = None) -> None:
    """Answer line by line, until bye or the end. Clauses: ORCL-LINE-1, ORCL-LINE-2, ORCL-BYE-1."""
    while line := requests.readline():
        found = answered(line, by)
        if isinstance(found, Bye):
            return
        for reply in found:
            replies.write(line_of(reply))
        replies.flush()
