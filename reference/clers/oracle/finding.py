"""A finding: a failure as a file, from which it can be asked again. Clause: ORCL-FIND-1."""

from hashlib import sha256
from pathlib import Path
from typing import Final

import msgspec
from msgspec import UNSET, Struct, UnsetType

from clers.conformance.cases.case import Case, operation_of
from clers.conformance.cases.identity import named
from clers.conformance.judging.judged import Judged
from clers.conformance.lines import NoMessage, request_in
from clers.conformance.messages import Call, Trace
from clers.conformance.session import Asked
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.meshfile.atomic import write_bytes
from clers.meshfile.reading import contents

LONGEST: Final = 1 << 28
"""Bytes of a file that is read."""


class Party(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """An adapter: its command, and what its hello says of it. Clause: ORCL-FIND-1."""

    command: tuple[str, ...]
    name: str
    version: str
    language: str


class Other(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """The second of two adapters, and how the reference judges each. Clause: ORCL-AGAINST-2."""

    adapter: Party
    outcome: str
    first: Judged
    second: Judged


class Shrunk(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """How large the input was and is, in how many requests; is no step left? ORCL-SHRINK-4."""

    unit: str
    before: int
    after: int
    asked: int
    minimal: bool


class Finding(Struct, frozen=True, forbid_unknown_fields=True, kw_only=True, omit_defaults=True):
    """A failure, with all that is needed to see it again. Clause: ORCL-FIND-1.

    `request` is the literal line without its end; `case` says what is right; `judged` what it came
    to; `law` the law that failed, if no single answer is wrong by itself.
    """

    request: str
    case: Case
    judged: Judged
    outcome: str
    adapter: Party
    protocol: int
    spec: str
    law: str = ""
    against: Other | UnsetType = UNSET
    shrunk: Shrunk | UnsetType = UNSET


def case_of(finding: Finding) -> Case:
    """The finding as a case of the vectors, under its id. Clause: ORCL-FIND-4."""
    slug = f"found-{finding.case.op.replace('.', '-')}"
    return named(slug, msgspec.structs.replace(finding.case, origin="shrunk"))


def asked_of(finding: Finding) -> Asked:
    """The literal request, as it is sent. Clauses: ORCL-FIND-1, ORCL-REPLAY-1."""
    line = finding.request.encode() + b"\n"
    request = request_in(line)
    number, trace = (request.id, request.trace) if isinstance(request, Call) else (0, "none")
    return Asked(finding.case.op, number, trace == "full", line)


def name_of(finding: Finding) -> str:
    """The name of its file: the same for the same failure of the same adapters. ORCL-FIND-2."""
    against = finding.against
    other = "" if isinstance(against, UnsetType) else against.adapter.name
    what = (finding.judged.signature, finding.law, finding.adapter.name, other)
    return f"fuzz-{sha256(msgspec.json.encode(what)).hexdigest()[:8]}.json"


def bytes_of(finding: Finding) -> bytes:
    """The finding as the bytes of its file. Clause: ORCL-FIND-2."""
    return msgspec.json.format(msgspec.json.encode(finding), indent=1) + b"\n"


def write(folder: Path, finding: Finding) -> Accepted[Path] | Rejected:
    """Write the finding into a folder, under its name, whole or not at all. ORCL-FIND-2."""
    return write_bytes(folder / name_of(finding), bytes_of(finding))


def parse(data: bytes) -> Accepted[Finding] | Rejected:
    """The finding that bytes say. Clauses: ORCL-FIND-2, ORCL-FIND-3."""
    try:
        finding = msgspec.json.decode(data, type=Finding)
    except (msgspec.DecodeError, RecursionError, UnicodeDecodeError) as fault:
        return _unreadable(str(fault))
    line = finding.request.encode() + b"\n"
    request = request_in(line)
    if isinstance(request, NoMessage) or not isinstance(request, Call):
        return _unreadable("its request is no request of an operation")
    trace: Trace = request.trace
    if operation_of(finding.case, trace) != msgspec.structs.replace(request, id=0):
        return _unreadable("its request is not the one of its case")
    return Accepted(finding)


def read(path: Path) -> Accepted[Finding] | Rejected:
    """The finding in a file. Total. Clause: ORCL-FIND-3."""
    return and_then(contents(path, LONGEST), parse)


def finding_schema() -> dict[str, object]:
    """The JSON Schema of findings, made from the record. Clause: ORCL-FIND-2."""
    (finding,), parts = msgspec.json.schema_components(
        [Finding],
        ref_template="#/$defs/{name}",
        schema_hook=lambda _: {"description": "any value"},
    )
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "A finding: a failure as a file, from which it can be asked again",
        **finding,
        "$defs": parts,
    }


def _unreadable(detail: str) -> Rejected:
    return Rejected(Reason.UNREADABLE_FILE, Clause.ORCL_FIND_3, detail=detail)
