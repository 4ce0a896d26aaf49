"""The laws of chapter 9: what is true of every message, and of how the reference answers."""

from dataclasses import dataclass
from typing import Final

from clers.conformance.adapter import answered
from clers.conformance.lines import NoMessage, line_of, reply_in, request_in, result_in
from clers.conformance.messages import Bye, Call, EventReply, OkReply, Operation
from clers.conformance.numbers import from_wire, to_wire
from clers.conformance.payloads import SAFE
from clers.conformance.serve import serve
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Given, Law, every, same
from clers.conventions.verdict import Holds, Verdict


@dataclass(frozen=True, slots=True)
class Wanted:
    """A request for an operation, of the right form, whatever it means."""

    operation: Operation


WANTED: Final = Given("adapter-requests", "requests of the right form, most of them bad", Wanted)
LINES: Final = Given("adapter-lines", "lines: requests, damaged requests, and noise", bytes)
INTEGERS: Final = Given("wire-integers", "integers, many of them near 2^53", int)


def _comes_back(wanted: Wanted) -> Verdict:
    line = line_of(wanted.operation)
    return every(same(wanted.operation, request_in(line)), same(1, line.count(b"\n")))


def _one_terminal(wanted: Wanted) -> Verdict:
    """Events, if they are wanted, and one terminal reply, all with the request's id."""
    request = wanted.operation
    replies = serve(request)
    events = [isinstance(reply, EventReply) for reply in replies]
    return every(
        same({request.id}, {reply.id for reply in replies}),
        same([True] * (len(replies) - 1) + [False], events),
        Holds() if request.trace == "full" else same(1, len(replies)),
    )


def _readable(wanted: Wanted) -> Verdict:
    """Each reply is read by the other side, and its result has the operation's form."""
    name = str(type(wanted.operation).__struct_config__.tag)
    verdicts: list[Verdict] = []
    for reply in serve(wanted.operation):
        read = reply_in(line_of(reply))
        verdicts.append(same(line_of(reply), b"" if isinstance(read, NoMessage) else line_of(read)))
        if isinstance(reply, OkReply):
            verdicts.append(same(False, isinstance(result_in(name, reply.ok), NoMessage)))
    return every(*verdicts)


def _answers(line: bytes) -> Verdict:
    """Whatever the line is, one terminal reply comes last; but nothing to bye."""
    found = answered(line)
    if isinstance(found, Bye):
        return same(Bye(), request_in(line))
    request = request_in(line)
    number = request.id if isinstance(request, Call) else found[-1].id
    return every(
        same([], [reply for reply in found[:-1] if not isinstance(reply, EventReply)]),
        same(False, isinstance(found[-1], EventReply)),
        same(number, found[-1].id),
    )


def _integer(value: int) -> Verdict:
    wire = to_wire(value)
    return every(
        same(value, from_wire(wire)),
        same(-SAFE <= value <= SAFE, isinstance(wire, int)),
    )


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "requests-come-back-from-lines",
        Clause.ORCL_LINE_1,
        "a request is one line, and reading the line gives the request",
        WANTED,
        _comes_back,
    ),
    Law(
        "one-terminal-reply",
        Clause.ORCL_REPLY_1,
        "the reference gives events only if asked, then one terminal reply, all with the same id",
        WANTED,
        _one_terminal,
    ),
    Law(
        "replies-are-read-by-the-oracle",
        Clause.ORCL_LINE_3,
        "each reply of the reference is read back as it was, its result in the operation's form",
        WANTED,
        _readable,
    ),
    Law(
        "every-line-is-answered",
        Clause.ORCL_REPLY_4,
        "whatever line the reference is given, it gives one terminal reply, but to bye",
        LINES,
        _answers,
    ),
    Law(
        "integers-come-back-from-messages",
        Clause.ORCL_VALUE_1,
        "an integer in a message is the same integer, and a number up to 2^53",
        INTEGERS,
        _integer,
    ),
)
