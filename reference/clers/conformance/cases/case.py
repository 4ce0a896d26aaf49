"""A case: one request, what is right to answer, and why anyone should ask. Clause: ORCL-CASE-1."""

from typing import Annotated, Final, Literal

import msgspec
from msgspec import UNSET, Meta, Raw, Struct, UnsetType

from clers.conformance.lines import NoMessage, result_in
from clers.conformance.messages import Operation, Rejection, Step, Trace
from clers.conformance.results import RESULTS, Result

Origin = Literal["exhaustive", "grammar", "generated", "real", "shrunk", "hand"]
"""Where a case comes from. Clause: ORCL-CASE-6."""

Comparison = Literal["exact", "isomorphic"]
"""How a result is compared. Clauses: ORCL-JUDGE-2, ORCL-JUDGE-3."""

Name = Annotated[str, Meta(pattern="^[a-z0-9]+(?:-[a-z0-9]+)*-[a-z2-7]{8}$")]
"""The id of a case. Clause: ORCL-CASE-2."""


class Edit(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """A change at one place of an input. Clause: ORCL-FAULT-2.

    `path` is a JSON pointer. Of a string or an array there, `remove` stands from `at` on, and
    `insert` takes its place (both strings, or both arrays); of anything else `remove` is the whole
    value and `insert` the new one.
    """

    path: str
    at: int = 0
    remove: Raw
    insert: Raw


class FaultForm(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True, omit_defaults=True):
    """The one fault of a case that is to be rejected. Clauses: ORCL-FAULT-1, ORCL-FAULT-2.

    `kind` names the fault, `parent` is the id of the case without it, `undo` mends it; `sealed`
    says that checksums are made anew after that.
    """

    kind: str
    parent: Name
    undo: tuple[Edit, ...]
    sealed: bool = False


class Case(
    Struct,
    frozen=True,
    forbid_unknown_fields=True,
    kw_only=True,
    omit_defaults=True,
    rename={"input": "in"},
):
    """One request and what is right to answer: `ok` or `reject`, never both. Clause: ORCL-CASE-1.

    `requires` are capabilities (ORCL-CASE-4), `size` the faces or symbols that must be borne,
    `flags` name what kinds of mistakes it may find, `trace` is the walk on the way to the answer.
    """

    id: Name
    op: str
    clauses: tuple[str, ...]
    origin: Origin
    requires: tuple[str, ...] = ()
    size: int = 0
    flags: tuple[str, ...] = ()
    input: Raw
    ok: Raw | UnsetType = UNSET
    reject: Rejection | UnsetType = UNSET
    compare: Comparison = "exact"
    trace: tuple[Step, ...] = ()
    fault: FaultForm | UnsetType = UNSET
    comment: str = ""


def operation_of(case: Case, trace: Trace = "none") -> Operation | NoMessage:
    """The case as a request, its id still 0. Clause: ORCL-CASE-1."""
    if case.op not in RESULTS:
        return NoMessage(f"no operation is named {case.op}")
    kind = RESULTS[case.op][0]
    line = b'{"op":%b,"id":0,"trace":"%b","in":%b}' % (
        msgspec.json.encode(case.op),
        trace.encode(),
        bytes(case.input),
    )
    try:
        return msgspec.json.decode(line, type=kind)
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as fault:
        return NoMessage(str(fault))


def right_result(case: Case) -> Result | NoMessage:
    """The result that is right, of the form that the operation has. Clause: ORCL-CASE-1."""
    if isinstance(case.ok, UnsetType):
        return NoMessage("the input is to be rejected")
    return result_in(case.op, case.ok)


PROFILES: Final = (
    "core",
    "handles",
    "boundaries",
    "components",
    "mixed",
    "codes",
    "operators",
    "geometry",
    "limits",
)
"""The profiles: each case is in one. Clause: ORCL-SUITE-3."""
