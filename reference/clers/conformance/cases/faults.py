"""The check of a case that is rejected: that it has one fault, and that mending it is accepted.

Clauses: ORCL-FAULT-1, ORCL-FAULT-2.
"""

from collections.abc import Mapping

import msgspec
from msgspec import UnsetType

from clers.conformance.cases.case import Case, operation_of
from clers.conformance.cases.edits import NoEdit, same_input, undone
from clers.conformance.lines import NoMessage
from clers.conformance.messages import OkReply, RejectReply, Reply, UnsupportedReply
from clers.conformance.serve import serve

LIMIT = "limit"


def reference_answer(case: Case) -> Reply | NoMessage:
    """What the reference answers to a case. Clause: ORCL-CASE-1."""
    operation = operation_of(case)
    return operation if isinstance(operation, NoMessage) else serve(operation)[-1]


def fault_in(case: Case, suite: Mapping[str, Case]) -> str:
    """Why a case that is to be rejected is no good one, or an empty string; `suite` by id.

    It is rejected by the reference as it says; it has one fault or is of the limits; undoing the
    fault gives the input of its parent, which is of the same operation, and accepted. Of cases that
    are not rejected nothing is asked but that they have no fault.
    Clauses: ORCL-FAULT-1, ORCL-FAULT-2, ORCL-FAULT-4, ORCL-LIMIT-1.
    """
    if isinstance(case.reject, UnsetType):
        return "" if isinstance(case.fault, UnsetType) else "it has a fault and is not rejected"
    match reference_answer(case):
        case RejectReply(reject=reject):
            said = msgspec.structs.replace(reject, detail=case.reject.detail)
            if said != case.reject:
                return f"the reference rejects it otherwise: {msgspec.json.encode(said).decode()}"
        case OkReply():
            return "the reference accepts it"
        case other:
            return f"the reference does not reject it: {other}"
    if isinstance(case.fault, UnsetType):
        return "" if case.reject.fault == LIMIT else "it names no fault"
    parent = suite.get(case.fault.parent)
    if parent is None:
        return f"its parent {case.fault.parent} is not in the suite"
    return _against(case, parent)


def _against(case: Case, parent: Case) -> str:
    if parent.op != case.op or not isinstance(parent.reject, UnsetType):
        return f"its parent {parent.id} is of another operation, or rejected"
    mended = undone(case)
    if isinstance(mended, NoEdit):
        return f"its fault cannot be undone: {mended.why}"
    if not same_input(mended, parent.input):
        return f"undoing its fault does not give the input of {parent.id}"
    if same_input(case.input, parent.input):
        return "it has no fault: its input is its parent's"
    match reference_answer(parent):
        case OkReply():
            return ""
        case RejectReply() | UnsupportedReply() as other:
            return f"the reference does not accept its parent: {other}"
        case other:
            return f"its parent is no request: {other}"
