"""The operations by name: how each is asked and what form its result has. ORCL-OP-1 … ORCL-OP-8."""

from collections.abc import Mapping
from typing import Final

from clers.conformance import messages as message
from clers.conformance import payloads as form

Result = dict[str, object] | form.Payload | message.Introduction
"""What `ok` carries: of echo an object, of hello an introduction, else a payload. ORCL-REPLY-1."""

RESULTS: Final[Mapping[str, tuple[type[message.Operation], type[form.Payload] | None]]] = {
    "echo": (message.Echo, None),
    "surface.classify": (message.Classify, form.Classified),
    "operator.apply": (message.Apply, form.Stages),
    "arithmetic.encode": (message.ArithmeticEncode, form.BitString),
    "arithmetic.decode": (message.ArithmeticDecode, form.Symbols),
    "word.encode": (message.WordEncode, form.WordForm),
    "word.decode": (message.WordDecode, form.Faces),
    "code.encode": (message.CodeEncode, form.BitString),
    "code.decode": (message.CodeDecode, form.JustWord),
    "mesh.encode": (message.MeshEncode, form.FileForm),
    "mesh.decode": (message.MeshDecode, form.MeshForm),
    "codec.roundtrip": (message.Roundtrip, form.MeshForm),
}
"""All operations; echo gives any object. Clauses: ORCL-OP-1 … ORCL-OP-8."""

REPLIES: Final = (
    message.EventReply,
    message.OkReply,
    message.RejectReply,
    message.UnsupportedReply,
    message.ErrorReply,
)
"""The five replies. Clause: ORCL-REPLY-1."""
