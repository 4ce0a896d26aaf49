"""How cases are made here: a good one from its input, a bad one from a good one and edits."""

from collections.abc import Sequence
from typing import Final, NamedTuple

import msgspec
from msgspec import UNSET, Raw, UnsetType

from clers.conformance.cases.case import Case, Edit, FaultForm, Origin, operation_of
from clers.conformance.cases.edits import NoEdit, edited, inverse
from clers.conformance.cases.faults import reference_answer
from clers.conformance.cases.identity import named
from clers.conformance.lines import NoMessage
from clers.conformance.messages import OkReply, Operation, RejectReply, Trace
from clers.conformance.payloads import Payload
from clers.conventions.clause import Clause
from clers.conventions.reason import Fault, Reason
from clers.oracle.positives.asked import Asked, answered
from clers.oracle.suite.profiles import LIMITS, profile_of

NO_ID: Final = "none-aaaaaaaa"
"""What stands for the id until all else is there."""


class Draft(NamedTuple):
    """A case on its way into a suite: its profile, the words of its id, and itself, named."""

    profile: str
    slug: str
    case: Case


class Slip(AssertionError):
    """A case of this package that the reference does not answer as its writer wrote."""


def good(
    slug: str,
    op: str,
    given: Payload,
    clauses: Sequence[Clause],
    *,
    requires: Sequence[str] = (),
    size: int = 0,
    flags: Sequence[str] = (),
    origin: Origin = "hand",
    comment: str = "",
    trace: Trace = "none",
) -> Draft:
    """The case of an input that is accepted, its result the reference's. Clause: ORCL-CASE-1."""
    request = request_of(op, Raw(msgspec.json.encode(given)), trace)
    case = answered(
        Asked(
            slug, op, request, tuple(clauses), origin,
            tuple(requires), size, tuple(flags), comment,
        )
    )  # fmt: skip
    return Draft(profile_of(case), slug, case)


def request_of(op: str, given: Raw, trace: Trace = "none") -> Operation:
    """An operation on an input that has its form."""
    bare = Case(id=NO_ID, op=op, clauses=(), origin="hand", input=given)
    match operation_of(bare, trace):
        case NoMessage(why):
            raise Slip(f"{op} {bytes(given).decode()[:80]}: {why}")
        case request:
            return request


def bad(
    parent: Draft,
    kind: str,
    edits: Sequence[Edit],
    reason: Reason,
    clause: Clause,
    *,
    flags: Sequence[str] = (),
    requires: Sequence[str] = (),
    sealed: bool = False,
    size: int = 0,
) -> Draft:
    """The case of a good one's input after these edits, which is rejected for this reason.

    The reason and the clause are the writer's; the reference must agree, and adds the element.
    `requires` and `size` are what it needs beyond its parent. Clauses: ORCL-FAULT-1, ORCL-FAULT-2.
    """
    draft = spoilt(
        parent, kind, edits,
        flags=flags, requires=requires, sealed=sealed, size=size,
    )  # fmt: skip
    reject = draft.case.reject
    wanted = (str(reason), str(clause))
    if isinstance(reject, UnsetType) or (reject.reason, reject.clause) != wanted:
        raise Slip(f"{draft.slug}: {reason} [{clause}] expected, {reject}")
    return draft


def spoilt(
    parent: Draft,
    kind: str,
    edits: Sequence[Edit],
    *,
    flags: Sequence[str] = (),
    requires: Sequence[str] = (),
    sealed: bool = False,
    size: int = 0,
) -> Draft:
    """The case of a good one's input after these edits, whatever the reference says to it.

    If it is rejected the edits are its fault; if not, it is a case of its own.
    """
    before = parent.case
    after = edited(before.input, edits, sealed=sealed)
    if isinstance(after, NoEdit):
        raise Slip(f"{parent.slug} {kind}: {after.why}")
    words = f"{parent.slug}-{kind}"
    case = msgspec.structs.replace(
        before,
        requires=tuple(sorted({*before.requires, *requires})),
        size=max(before.size, size),
        flags=tuple(flags),
        input=after,
        ok=UNSET,
        trace=(),
        comment="",
    )
    match reference_answer(case):
        case OkReply(ok=ok):
            case = msgspec.structs.replace(case, ok=ok)
        case RejectReply(reject=reject):
            case = msgspec.structs.replace(
                case,
                clauses=(reject.clause,),
                reject=msgspec.structs.replace(reject, detail=""),
                fault=FaultForm(kind=kind, parent=before.id, undo=inverse(edits), sealed=sealed),
            )
        case other:
            raise Slip(f"{words}: {other}")
    return Draft(LIMITS if _over(case) else profile_of(case), words, named(words, case))


def _over(case: Case) -> bool:
    """Is it of the limits? Clause: ORCL-SUITE-3."""
    return not isinstance(case.reject, UnsetType) and case.reject.fault is Fault.LIMIT
