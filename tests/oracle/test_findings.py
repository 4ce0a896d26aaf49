"""Findings as files: written, read back, refused where they are none."""

import json
from pathlib import Path
from typing import Final

import jsonschema
import msgspec
import pytest
from msgspec import Raw

from clers import SPEC_VERSION
from clers.conformance.cases.case import Case
from clers.conformance.cases.identity import identity, named
from clers.conformance.judging.judged import Judged, Status
from clers.conformance.messages import PROTOCOL, Rejection
from clers.conventions.reason import Fault, Reason
from clers.conventions.result import Accepted, Rejected
from clers.oracle.finding import (
    Finding,
    Other,
    Party,
    Shrunk,
    asked_of,
    bytes_of,
    case_of,
    finding_schema,
    name_of,
    parse,
    read,
    write,
)

SCHEMA: Final = Path(__file__).parents[2] / "spec" / "schemas" / "finding.schema.json"

INPUT: Final = '{"word":"CRE","handles":[],"components_with_boundary":0}'
CASE: Final = named(
    "any",
    Case(
        id="any-aaaaaaaa",
        op="word.decode",
        clauses=("EB-DECODE-1",),
        origin="generated",
        input=Raw(INPUT.encode()),
        ok=Raw(b'{"faces":[[0,1,2],[3,2,1],[0,3,1],[2,3,0]],"vertices":4}'),
    ),
)
JUDGED: Final = Judged(
    id=CASE.id, op=CASE.op, clauses=CASE.clauses, status=Status.FAIL, why="no", signature="a fail"
)
PARTY: Final = Party(command=("./fast", "-x"), name="fast", version="1", language="c")
FINDING: Final = Finding(
    request=f'{{"op":"word.decode","in":{INPUT}, "trace":"full","id":12}}',
    case=CASE,
    judged=JUDGED,
    outcome="answered: nonsense",
    adapter=PARTY,
    protocol=PROTOCOL,
    spec=SPEC_VERSION,
    shrunk=Shrunk(unit="symbols", before=90, after=3, asked=17, minimal=True),
)
OTHER: Final = Other(adapter=PARTY, outcome="declined", first=JUDGED, second=JUDGED)


def test_a_finding_comes_back_from_its_file(tmp_path: Path) -> None:
    """ORCL-FIND-1, ORCL-FIND-2."""
    for finding in (FINDING, msgspec.structs.replace(FINDING, law="comes-back", against=OTHER)):
        written = write(tmp_path, finding)
        assert isinstance(written, Accepted)
        assert written.value == tmp_path / name_of(finding)
        again = read(written.value)
        assert isinstance(again, Accepted)
        assert bytes_of(again.value) == written.value.read_bytes()
        assert again.value.shrunk == finding.shrunk
        jsonschema.validate(json.loads(written.value.read_text()), finding_schema())
    assert len(list(tmp_path.iterdir())) == 2


def test_a_smaller_finding_of_the_same_failure_has_the_same_name() -> None:
    """ORCL-FIND-2: signature, law and names of the adapters make the name, and nothing else."""
    name = name_of(FINDING)
    assert len(name) == len("fuzz-12345678.json")
    smaller = msgspec.structs.replace(FINDING, request="", outcome="", shrunk=msgspec.UNSET)
    assert name_of(smaller) == name
    judged = msgspec.structs.replace(JUDGED, signature="another")
    others = (
        msgspec.structs.replace(FINDING, judged=judged),
        msgspec.structs.replace(FINDING, law="comes-back"),
        msgspec.structs.replace(FINDING, against=OTHER),
        msgspec.structs.replace(FINDING, adapter=msgspec.structs.replace(PARTY, name="faster")),
    )
    assert len({name, *map(name_of, others)}) == 5


def test_the_request_is_sent_as_it_stands() -> None:
    """ORCL-FIND-1: not as it would be written anew."""
    asked = asked_of(FINDING)
    assert (asked.operation, asked.id, asked.traced) == ("word.decode", 12, True)
    assert asked.line == FINDING.request.encode() + b"\n"


def test_the_case_of_a_finding_is_a_shrunk_one_under_its_id() -> None:
    """ORCL-FIND-4."""
    case = case_of(FINDING)
    assert case.origin == "shrunk"
    assert case.id == identity("found-word-decode", CASE)
    assert (case.input, case.ok, case.clauses) == (CASE.input, CASE.ok, CASE.clauses)


REQUESTS: Final = {
    "other input": f'{{"op":"word.decode","id":1,"in":{INPUT.replace("CRE", "E")}}}',
    "other operation": '{"op":"echo","id":1,"in":{}}',
    "bye": '{"op":"bye"}',
    "hello": '{"op":"hello","id":0,"protocol":1,"spec":"","suite":""}',
    "no request": "word.decode",
}


@pytest.mark.parametrize("which", REQUESTS)
def test_a_request_that_is_not_its_cases_is_rejected(which: str) -> None:
    """ORCL-FIND-3."""
    found = parse(bytes_of(msgspec.structs.replace(FINDING, request=REQUESTS[which])))
    assert isinstance(found, Rejected)
    assert found.reason is Reason.UNREADABLE_FILE
    assert "request" in found.detail


@pytest.mark.parametrize("data", [b"", b"{}", b"\xff", b"[" * 100_000, b'{"request":1}'])
def test_what_is_no_finding_is_rejected(data: bytes) -> None:
    """ORCL-FIND-3."""
    found = parse(data)
    assert isinstance(found, Rejected)
    assert found.reason is Reason.UNREADABLE_FILE


def test_a_file_that_is_not_there_is_rejected(tmp_path: Path) -> None:
    """ORCL-FIND-3."""
    assert isinstance(read(tmp_path / "none.json"), Rejected)


def test_the_published_schema_is_that_of_the_record() -> None:
    """ORCL-FIND-2."""
    printed = json.loads(msgspec.json.encode(finding_schema()))
    assert json.loads(SCHEMA.read_text()) == printed


def test_a_rejection_is_an_expectation_too() -> None:
    """ORCL-FIND-1."""
    case = msgspec.structs.replace(CASE, ok=msgspec.UNSET, reject=Rejection(Fault.INVALID))
    found = parse(bytes_of(msgspec.structs.replace(FINDING, case=case)))
    assert isinstance(found, Accepted)
    assert found.value.case.reject == Rejection(Fault.INVALID)
