"""The messages of the protocol: requests and replies as frozen records. Clause: ORCL-LINE-3."""

from typing import Annotated, Final, Literal

from msgspec import UNSET, Meta, Raw, Struct, UnsetType

from clers.conformance import payloads as form
from clers.conventions.reason import Fault

PROTOCOL: Final = 1
"""The number of the protocol. Clause: ORCL-HELLO-1."""

Id = Annotated[int, Meta(ge=0, le=1 << 53)]
Trace = Literal["none", "full"]


class Hello(Struct, frozen=True, forbid_unknown_fields=True, tag_field="op", tag="hello"):
    """The first request. Clause: ORCL-HELLO-1."""

    id: Id
    protocol: int
    spec: str
    suite: str


class Bye(Struct, frozen=True, forbid_unknown_fields=True, tag_field="op", tag="bye"):
    """The last line; it has no reply. Clause: ORCL-BYE-1."""


class Call(
    Struct,
    frozen=True,
    forbid_unknown_fields=True,
    kw_only=True,
    tag_field="op",
    rename={"input": "in"},
):
    """What all operations have: an id, and whether events are wanted. Clause: ORCL-EVENT-1."""

    id: Id
    trace: Trace = "none"


class Echo(Call, frozen=True, kw_only=True, tag="echo"):
    """Clause: ORCL-OP-1."""

    input: dict[str, object]


class Classify(Call, frozen=True, kw_only=True, tag="surface.classify"):
    """Clause: ORCL-OP-2."""

    input: form.Faces


class Apply(Call, frozen=True, kw_only=True, tag="operator.apply"):
    """Clause: ORCL-OP-3."""

    input: form.ScriptForm


class ArithmeticEncode(Call, frozen=True, kw_only=True, tag="arithmetic.encode"):
    """Clause: ORCL-OP-4."""

    input: form.ToCode


class ArithmeticDecode(Call, frozen=True, kw_only=True, tag="arithmetic.decode"):
    """Clause: ORCL-OP-4."""

    input: form.Coded


class WordEncode(Call, frozen=True, kw_only=True, tag="word.encode"):
    """Clause: ORCL-OP-5."""

    input: form.Faces


class WordDecode(Call, frozen=True, kw_only=True, tag="word.decode"):
    """Clause: ORCL-OP-5."""

    input: form.StreamForm


class CodeEncode(Call, frozen=True, kw_only=True, tag="code.encode"):
    """Clause: ORCL-OP-6."""

    input: form.ToWord


class CodeDecode(Call, frozen=True, kw_only=True, tag="code.decode"):
    """Clause: ORCL-OP-6."""

    input: form.FromWord


class MeshEncode(Call, frozen=True, kw_only=True, tag="mesh.encode"):
    """Clause: ORCL-OP-7."""

    input: form.ToFile


class MeshDecode(Call, frozen=True, kw_only=True, tag="mesh.decode"):
    """Clause: ORCL-OP-7."""

    input: form.FileForm


class Roundtrip(Call, frozen=True, kw_only=True, tag="codec.roundtrip"):
    """Clauses: ORCL-OP-8, ORCL-CODEC-1."""

    input: form.ThroughForm


Operation = (
    Echo
    | Classify
    | Apply
    | ArithmeticEncode
    | ArithmeticDecode
    | WordEncode
    | WordDecode
    | CodeEncode
    | CodeDecode
    | MeshEncode
    | MeshDecode
    | Roundtrip
)
Request = Hello | Operation | Bye


class Caps(Struct, frozen=True, forbid_unknown_fields=True):
    """What an implementation can do within its operations. Clauses: ORCL-HELLO-2, ORCL-CODEC-16."""

    handles: bool
    boundaries: Literal["none", "one", "many"]
    components: bool
    max_faces: form.Count
    max_symbols: form.Count
    trace: tuple[str, ...] = ()
    codes: tuple[str, ...] = ()
    coders: tuple[str, ...] = ()
    positions: tuple[Literal["f32", "f64"], ...] = ("f32", "f64")


class Introduction(Struct, frozen=True, forbid_unknown_fields=True):
    """The answer to hello. Clause: ORCL-HELLO-2."""

    protocol: int
    name: str
    version: str
    language: str
    ops: tuple[str, ...]
    caps: Caps
    policy: dict[str, str] = {}


class Step(Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """An entry of the walk. Clauses: ORCL-EVENT-1, EB-TRACE-1."""

    i: int
    symbol: str
    component: int | UnsetType = UNSET
    face: int | UnsetType = UNSET
    triangle: tuple[int, int, int] | UnsetType = UNSET
    gate: tuple[int, int] | UnsetType = UNSET
    stack: int | UnsetType = UNSET
    new: tuple[int, ...] | UnsetType = UNSET
    opens: int | UnsetType = UNSET
    closes: tuple[int, ...] | UnsetType = UNSET
    euler: int | UnsetType = UNSET


class Rejection(
    Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True, rename={"fault": "class"}
):
    """Why an input is bad. Clauses: ORCL-REPLY-2, CONV-RESULT-2, CONV-RESULT-3."""

    fault: Fault
    reason: str = ""
    at: dict[str, int | str | tuple[int, ...]] = {}
    clause: str = ""
    detail: str = ""


class Lacking(Struct, frozen=True, forbid_unknown_fields=True):
    """What the adapter does not do. Clause: ORCL-REPLY-3."""

    cap: str


class Failure(Struct, frozen=True, forbid_unknown_fields=True):
    """What befell the adapter. Clause: ORCL-REPLY-4."""

    message: str


class EventReply(Struct, frozen=True, forbid_unknown_fields=True):
    """A step on the way. Clause: ORCL-EVENT-1."""

    id: Id
    ev: Step


class OkReply(Struct, frozen=True, forbid_unknown_fields=True):
    """The result, of the form that the operation has. Clause: ORCL-REPLY-1."""

    id: Id
    ok: Raw


class RejectReply(Struct, frozen=True, forbid_unknown_fields=True):
    """The input is bad. Clause: ORCL-REPLY-2."""

    id: Id
    reject: Rejection


class UnsupportedReply(Struct, frozen=True, forbid_unknown_fields=True):
    """The adapter does not do this. Clause: ORCL-REPLY-3."""

    id: Id
    unsupported: Lacking


class ErrorReply(Struct, frozen=True, forbid_unknown_fields=True):
    """The adapter has failed. Clause: ORCL-REPLY-4."""

    id: Id | None
    error: Failure


Terminal = OkReply | RejectReply | UnsupportedReply | ErrorReply
Reply = EventReply | Terminal
