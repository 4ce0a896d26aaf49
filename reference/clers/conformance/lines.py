"""Messages and lines: written, and read strictly. Clauses: ORCL-LINE-1, ORCL-LINE-3."""

from dataclasses import dataclass
from typing import Final

import msgspec

from clers.conformance.messages import (
    ErrorReply,
    EventReply,
    Introduction,
    OkReply,
    RejectReply,
    Reply,
    Request,
    UnsupportedReply,
)
from clers.conformance.results import RESULTS, Result

REPLIES: Final[dict[str, msgspec.json.Decoder[Reply]]] = {
    "ev": msgspec.json.Decoder(EventReply),
    "ok": msgspec.json.Decoder(OkReply),
    "reject": msgspec.json.Decoder(RejectReply),
    "unsupported": msgspec.json.Decoder(UnsupportedReply),
    "error": msgspec.json.Decoder(ErrorReply),
}
"""A reader for each reply, by the key that tells it from the others. Clause: ORCL-REPLY-1."""

_REQUEST: Final[msgspec.json.Decoder[Request]] = msgspec.json.Decoder(Request)
_OBJECT: Final = msgspec.json.Decoder(dict[str, msgspec.Raw])
_VALUE: Final = msgspec.json.Decoder(dict[str, object])
FAULTS: Final = (msgspec.DecodeError, RecursionError, UnicodeDecodeError)
"""What decoding a line can raise, whatever bytes are on it. Clause: ORCL-LINE-3."""


@dataclass(frozen=True, slots=True)
class NoMessage:
    """A line that is no message, and why."""

    why: str


def line_of(message: Request | Reply) -> bytes:
    """The message on one line. Clause: ORCL-LINE-1."""
    return msgspec.json.encode(message) + b"\n"


def object_in(line: bytes) -> dict[str, msgspec.Raw] | NoMessage:
    """The keys of a line of UTF-8, their values unread. Clause: ORCL-LINE-1."""
    try:
        return _OBJECT.decode(line.decode())
    except FAULTS as fault:
        return NoMessage(str(fault))


def request_in(line: bytes) -> Request | NoMessage:
    """The request on a line. Clause: ORCL-LINE-3."""
    try:
        return _REQUEST.decode(line)
    except FAULTS as fault:
        return NoMessage(str(fault))


def reply_in(line: bytes) -> Reply | NoMessage:
    """The reply on a line: exactly one of the five. Clauses: ORCL-LINE-3, ORCL-REPLY-1."""
    keys = object_in(line)
    if isinstance(keys, NoMessage):
        return keys
    named = [key for key in REPLIES if key in keys]
    if len(named) != 1:
        return NoMessage(f"it has {' and '.join(named) or 'none'} of {', '.join(REPLIES)}")
    try:
        return REPLIES[named[0]].decode(line)
    except FAULTS as fault:
        return NoMessage(str(fault))


def result_in(operation: str, ok: msgspec.Raw) -> Result | NoMessage:
    """The result of an operation, of the form it must have; of one that is not known, any.

    Clauses: ORCL-LINE-3, ORCL-REPLY-1.
    """
    kind = RESULTS[operation][1] if operation in RESULTS else None
    try:
        if operation == "hello":
            return msgspec.json.decode(ok, type=Introduction)
        return _VALUE.decode(ok) if kind is None else msgspec.json.decode(ok, type=kind)
    except FAULTS as fault:
        return NoMessage(str(fault))
