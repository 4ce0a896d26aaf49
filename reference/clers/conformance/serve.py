"""The reference as an adapter: a request to its replies, and nothing else. Pure.

What does an operation is imported where the operation is first asked, for an adapter is started
often and asked few of them. Clause: TOOL-START-2.
"""

from typing import Final, assert_never, get_args

import msgspec

from clers import SPEC_VERSION, __version__
from clers.codes.registry import CodeName
from clers.complexes.face_list import DEFAULT_LIMITS
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.messages import (
    PROTOCOL,
    Caps,
    EventReply,
    Introduction,
    Lacking,
    OkReply,
    Operation,
    Rejection,
    RejectReply,
    Reply,
    Request,
    Step,
    Terminal,
    UnsupportedReply,
)
from clers.conformance.results import RESULTS
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where_record import where_record

MAX_SYMBOLS: Final = 1 << 20
"""The most symbols that are decoded for a request. Clause: ORCL-SERVE-1."""

INTRODUCTION: Final = Introduction(
    PROTOCOL,
    "clers",
    __version__,
    "python",
    tuple(RESULTS),
    Caps(
        handles=True,
        boundaries="many",
        components=True,
        max_faces=DEFAULT_LIMITS.faces,
        max_symbols=MAX_SYMBOLS,
        trace=("word.encode", "word.decode"),
        codes=tuple(map(str, CodeName)),
        coders=get_args(form.CoderName),
    ),
    {"specification": SPEC_VERSION},
)
"""What the reference says of itself. Clauses: ORCL-HELLO-2, ORCL-SERVE-1."""

Answered = Accepted[form.Payload] | Rejected | Lacking
"""What an operation comes to."""


def serve(request: Request) -> tuple[Reply, ...]:
    """The replies to a request: events, if wanted, then one terminal reply; none to bye.

    Clauses: ORCL-REPLY-1, ORCL-HELLO-2, ORCL-HELLO-3, ORCL-EVENT-1, ORCL-SERVE-1.
    """
    match request:
        case message.Bye():
            return ()
        case message.Hello(id=number, protocol=protocol):
            if protocol != PROTOCOL:
                return (UnsupportedReply(number, Lacking("protocol")),)
            return (_ok(number, INTRODUCTION),)
        case message.Echo(id=number, input=given):
            return (_ok(number, given),)
        case _:
            end = _terminal(request.id, _answer(request))
            return (*(EventReply(request.id, step) for step in _steps(request)), end)


def _answer(request: Operation) -> Answered:  # noqa: C901  (one case an operation)
    match request:
        case message.Echo():
            return Lacking("echo")
        case message.Classify(input=given):
            from clers.conformance.served import surfaces

            return surfaces.classify(given)
        case message.Apply(input=given):
            from clers.conformance.served import scripts

            return scripts.apply(given)
        case message.ArithmeticEncode(input=given):
            from clers.conformance.served import arithmetic

            return arithmetic.encode(given)
        case message.ArithmeticDecode(input=given):
            from clers.conformance.served import arithmetic

            if given.count > MAX_SYMBOLS:
                return Lacking("max_symbols")
            return arithmetic.decode(given)
        case message.WordEncode(input=given):
            from clers.conformance.served import words

            return words.encode(given)
        case message.WordDecode(input=given):
            from clers.conformance.served import words

            return words.decode(given)
        case message.CodeEncode(input=given):
            from clers.conformance.served import codes

            code = codes.named(given.code)
            return Lacking(f"code.{given.code}") if code is None else codes.encode(code, given)
        case message.CodeDecode(input=given):
            from clers.conformance.served import codes

            if given.symbols > MAX_SYMBOLS:
                return Lacking("max_symbols")
            code = codes.named(given.code)
            return Lacking(f"code.{given.code}") if code is None else codes.decode(code, given)
        case message.MeshEncode(input=given):
            from clers.conformance.served import codes, meshes

            code = codes.named(given.code)
            return Lacking(f"code.{given.code}") if code is None else meshes.encode(code, given)
        case message.MeshDecode(input=given):
            from clers.conformance.served import meshes

            return meshes.decode(given)
        case message.Roundtrip(input=given):
            from clers.conformance.served import meshes

            return meshes.roundtrip(given)
        case _:
            assert_never(request)


def _steps(request: Operation) -> tuple[Step, ...]:
    """The events of a request; none of an input that is rejected. Clause: ORCL-EVENT-1."""
    match request:
        case message.WordEncode(trace="full", input=given):
            from clers.conformance.served import words

            found = words.steps_of_encoding(given)
        case message.WordDecode(trace="full", input=given):
            from clers.conformance.served import words

            found = words.steps_of_decoding(given)
        case _:
            return ()
    return found.value if isinstance(found, Accepted) else ()


def _ok(number: int, value: object) -> OkReply:
    return OkReply(number, msgspec.Raw(msgspec.json.encode(value)))


def _terminal(number: int, answered: Answered) -> Terminal:
    """Clauses: ORCL-REPLY-1, ORCL-REPLY-2, ORCL-REPLY-3."""
    match answered:
        case Accepted(value):
            return _ok(number, value)
        case Rejected():
            return RejectReply(number, rejection(answered))
        case Lacking():
            return UnsupportedReply(number, answered)
        case _:
            assert_never(answered)


def rejection(rejected: Rejected) -> Rejection:
    """A rejection as a message has it. Clauses: ORCL-REPLY-2, CONV-RESULT-3."""
    at = {
        key: tuple(value) if isinstance(value, list) else value
        for key, value in where_record(rejected.where).items()
    }
    return Rejection(
        rejected.fault, str(rejected.reason), at, str(rejected.clause), rejected.detail
    )
