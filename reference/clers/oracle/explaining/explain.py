"""What there is to say of a case. Pure. Clauses: ORCL-EXPLAIN-1 … ORCL-EXPLAIN-4."""

from collections.abc import Mapping

import msgspec
from msgspec import UnsetType

from clers.conformance.cases.case import Case, Edit, FaultForm, operation_of, right_result
from clers.conformance.judging.rejections import element_of, line_of
from clers.conformance.lines import NoMessage
from clers.oracle.explaining.explanation import Explanation, Table, Told
from clers.oracle.explaining.inputs import asked_in_short, cut, result_in_short
from clers.oracle.explaining.tables import tables_of

UNKNOWN = "the specification is not at hand"


def explanation(case: Case, clauses: Mapping[str, str], flags: Mapping[str, str]) -> Explanation:
    """The explanation of a case; `clauses` and `flags` are texts by name. Total.

    Clauses: ORCL-EXPLAIN-1, ORCL-EXPLAIN-2, ORCL-EXPLAIN-3.
    """
    request, result = operation_of(case), right_result(case)
    asks = request.why if isinstance(request, NoMessage) else asked_in_short(request)
    tables: tuple[Table, ...] = ()
    if not isinstance(request, NoMessage) and not isinstance(result, NoMessage):
        tables = tables_of(case, request, result)
    rejected = None if isinstance(case.reject, UnsetType) else case.reject
    if rejected is not None:
        detail = f": {rejected.detail}" if rejected.detail else ""
        answer = f"reject {line_of(rejected)}{detail}"
    else:
        answer = result.why if isinstance(result, NoMessage) else result_in_short(result)
    return Explanation(
        id=case.id,
        op=case.op,
        origin=case.origin,
        size=case.size,
        requires=case.requires,
        comment=case.comment,
        asks=asks,
        answer=answer,
        compare=case.compare,
        clauses=tuple(Told(name=c, text=clauses.get(c, UNKNOWN)) for c in case.clauses),
        flags=tuple(Told(name=f, text=flags.get(f, "")) for f in case.flags),
        tables=tables,
        blamed="" if rejected is None else element_of(rejected) or "the whole input",
        fault=case.fault,
    )


def undoing(fault: FaultForm) -> tuple[str, ...]:
    """The edits that undo a fault, a line each. Clause: ORCL-EXPLAIN-3."""
    lines = tuple(_undone(edit) for edit in fault.undo)
    return (*lines, "then the checksums are made anew") if fault.sealed else lines


def _undone(edit: Edit) -> str:
    """A number is exchanged; of a string or an array a stretch is."""
    change = f"{_said(edit.remove)} becomes {_said(edit.insert)}"
    whole = bytes(edit.remove)[:1] not in (b'"', b"[")
    return f"{edit.path}: {change}" if whole else f"{edit.path}, from {edit.at} on: {change}"


def _said(value: msgspec.Raw) -> str:
    return cut(bytes(value).decode())
