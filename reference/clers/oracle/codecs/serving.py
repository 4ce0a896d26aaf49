"""A codec as an adapter: `codec.roundtrip` and `echo`, and nothing else. Pure but for the codec."""

from math import isfinite
from typing import Final, assert_never

import msgspec

from clers.complexes.face_list import DEFAULT_LIMITS
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.messages import PROTOCOL, Reply, Request
from clers.oracle.codecs.codec import Codec

CAPS: Final = message.Caps(
    handles=True,
    boundaries="many",
    components=True,
    max_faces=DEFAULT_LIMITS.faces,
    max_symbols=0,
)
"""What the wrapper bears: every mesh is handed on. Clause: ORCL-CODEC-9."""

NOT_FINITE: Final = "a coordinate that came back is no finite number"
"""JSON has no such numbers. Clause: ORCL-VALUE-3."""


def introduction(codec: Codec) -> message.Introduction:
    """What the adapter of a codec says of itself. Clauses: ORCL-HELLO-2, ORCL-CODEC-9."""
    return message.Introduction(
        PROTOCOL,
        codec.name,
        codec.version,
        codec.language,
        ("echo", "codec.roundtrip"),
        msgspec.structs.replace(CAPS, positions=codec.precisions),
        dict(codec.policy),
    )


def serve(codec: Codec, request: Request) -> tuple[Reply, ...]:
    """The reply to a request; none to bye. Clauses: ORCL-REPLY-1, ORCL-REPLY-3, ORCL-CODEC-9."""
    match request:
        case message.Bye():
            return ()
        case message.Hello(id=number, protocol=protocol):
            if protocol != PROTOCOL:
                return (message.UnsupportedReply(number, message.Lacking("protocol")),)
            return (_ok(number, introduction(codec)),)
        case message.Echo(id=number, input=given):
            return (_ok(number, given),)
        case message.Roundtrip(id=number, input=mesh):
            return (_answered(number, codec, mesh),)
        case _:
            name = str(type(request).__struct_config__.tag)
            return (message.UnsupportedReply(request.id, message.Lacking(name)),)


def _answered(number: int, codec: Codec, mesh: form.ThroughForm) -> Reply:
    answer = codec.through(mesh)
    match answer:
        case form.MeshForm(positions=form.Places(coordinates=at)) if not all(map(isfinite, at)):
            return message.ErrorReply(number, message.Failure(NOT_FINITE))
        case form.MeshForm():
            return _ok(number, answer)
        case message.Rejection():
            return message.RejectReply(number, answer)
        case message.Lacking():
            return message.UnsupportedReply(number, answer)
        case message.Failure():
            return message.ErrorReply(number, answer)
        case _:
            assert_never(answer)


def _ok(number: int, value: object) -> Reply:
    return message.OkReply(number, msgspec.Raw(msgspec.json.encode(value)))
