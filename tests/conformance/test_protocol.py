"""The published schema, and the messages of both sides held against it."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Final

import jsonschema
import pytest
from typer.testing import CliRunner

from clers.cli.main import app
from clers.conformance.adapter import answered
from clers.conformance.lines import NoMessage, line_of, reply_in, request_in, result_in
from clers.conformance.messages import Bye, OkReply, Reply
from clers.conformance.numbers import from_wire, to_wire
from clers.conformance.results import RESULTS
from clers.conformance.samples import GARBAGE, SAMPLES
from clers.conformance.session import asked, hello

FILE: Final = Path(__file__).parents[2] / "spec" / "schemas" / "protocol.schema.json"
SCHEMA: Final[Mapping[str, object]] = json.loads(FILE.read_text())


def holds(schema: object, value: object) -> bool:
    """Whether a value keeps to a part of the schema."""
    whole = {"$schema": SCHEMA["$schema"], "allOf": [schema], "$defs": SCHEMA["$defs"]}
    return bool(jsonschema.Draft202012Validator(whole).is_valid(value))


def part(operation: str, of: str) -> object:
    operations = SCHEMA["operations"]
    assert isinstance(operations, dict)
    return operations[operation][of]


def test_the_schema_is_the_one_published() -> None:
    """ORCL-LINE-3."""
    said = CliRunner().invoke(app, ["schema", "protocol"])
    assert said.exit_code == 0
    assert json.loads(said.stdout) == SCHEMA
    jsonschema.Draft202012Validator.check_schema(dict(SCHEMA))


def test_hello_keeps_to_the_schema() -> None:
    """Clauses: ORCL-LINE-3, ORCL-HELLO-1, ORCL-HELLO-2."""
    request = json.loads(hello("abcdefghijkl").line)
    assert request.pop("suite") == "abcdefghijkl"
    assert {**request, "suite": ""} == json.loads(hello().line)
    request = json.loads(hello().line)
    assert request == {"op": "hello", "id": 0, "protocol": 1, "spec": "0.1", "suite": ""}
    assert holds(part("hello", "request"), request)
    assert holds({"$ref": "#/$defs/Request"}, request)
    (reply,) = (json.loads(line_of(r)) for r in said(hello().line))
    assert holds({"$ref": "#/$defs/Reply"}, reply)
    assert holds(part("hello", "ok"), reply["ok"])
    assert holds({"$ref": "#/$defs/Request"}, {"op": "bye"})


def said(line: bytes) -> tuple[Reply, ...]:
    found = answered(line)
    assert not isinstance(found, Bye)
    return found


@pytest.mark.parametrize("name", RESULTS)
def test_both_sides_keep_to_the_schema(name: str) -> None:
    """Clauses: ORCL-LINE-1, ORCL-LINE-3, ORCL-REPLY-1."""
    for operation in (SAMPLES[name], *GARBAGE.get(name, ())):
        line = asked(7, operation).line
        assert line.count(b"\n") == 1
        assert line.endswith(b"\n")
        assert holds(part(name, "request"), json.loads(line))
        read = request_in(line)
        assert not isinstance(read, NoMessage)
        assert line_of(read) == line
        *_, last = replies = said(line)
        for reply in replies:
            document = json.loads(line_of(reply))
            assert document["id"] == 7
            assert holds({"$ref": "#/$defs/Reply"}, document)
            assert reply_in(line_of(reply)[:-1]) == reply or isinstance(reply, OkReply)
            if isinstance(last, OkReply) and reply is last:
                assert holds(part(name, "ok"), document["ok"])
                assert not isinstance(result_in(name, last.ok), NoMessage)


@pytest.mark.parametrize(
    "document",
    [
        {"id": 1, "ok": {}, "more": 0},
        {"id": 1},
        {"id": 1, "ok": {}, "reject": {"class": "invalid"}},
        {"id": 1, "reject": {"class": "awkward"}},
        {"id": -1, "ok": {}},
        {"id": "1", "ok": {}},
        {"id": 1, "unsupported": {}},
        {"id": 1, "error": "no"},
        {"id": 1, "ev": {"i": 0}},
        {"id": (1 << 53) + 1, "ok": {}},
    ],
    ids=json.dumps,
)
def test_what_is_no_reply(document: object) -> None:
    """Clauses: ORCL-LINE-3, ORCL-REPLY-1: schema and reader refuse the same."""
    assert not holds({"$ref": "#/$defs/Reply"}, document)
    assert isinstance(reply_in(json.dumps(document).encode()), NoMessage)


@pytest.mark.parametrize(
    ("number", "good"),
    [
        (0, True),
        (-(1 << 53), True),
        (1 << 53, True),
        ((1 << 53) + 1, False),
        (-(1 << 53) - 1, False),
        ("9007199254740993", True),
        ("-9007199254740993", True),
        ("1" * 1000, True),
        ("1" * 1001, False),
        ("09007199254740993", False),
        ("+9007199254740993", False),
        ("12", False),
        ("", False),
        (1.5, False),
        (None, False),
    ],
)
def test_numbers(number: object, good: bool) -> None:
    """ORCL-VALUE-1."""
    given = {"faces": [[0, 1, number]], "vertices": 3}
    request = {"op": "surface.classify", "id": 1, "in": given}
    assert holds(part("surface.classify", "request"), request) is good
    assert isinstance(request_in(json.dumps(request).encode()), NoMessage) is not good


def test_numbers_there_and_back() -> None:
    """ORCL-VALUE-1."""
    edge = 9007199254740992
    assert [to_wire(n) for n in (0, edge, -edge)] == [0, edge, -edge]
    assert [to_wire(n) for n in (edge + 1, -edge - 1)] == [
        "9007199254740993",
        "-9007199254740993",
    ]
    for n in (0, -1, edge, edge + 1, -edge - 1, 10**999):
        assert from_wire(to_wire(n)) == n


@pytest.mark.parametrize(
    ("text", "good"), [("", True), ("0aff", True), ("0", False), ("0A", False)]
)
def test_bytes(text: str, good: bool) -> None:
    """ORCL-VALUE-2."""
    request = {"op": "mesh.decode", "id": 1, "in": {"hex": text}}
    assert holds(part("mesh.decode", "request"), request) is good
    assert isinstance(request_in(json.dumps(request).encode()), NoMessage) is not good


def test_the_example_of_the_page() -> None:
    """Clauses: ORCL-LINE-3, ORCL-REPLY-1: its messages are messages, and the reference's answer."""
    page = (FILE.parents[1] / "09-conformance.md").read_text()
    block = page.partition("```\n>")[2].partition("```")[0]
    lines = f">{block}".replace("\n     ", "").splitlines()
    assert [line[0] for line in lines] == list("><><<<<<>")
    for line in lines:
        message = line[2:].encode()
        read = request_in(message) if line[0] == ">" else reply_in(message)
        assert not isinstance(read, NoMessage), read
    ours = [json.loads(line_of(reply)) for reply in said(lines[2][2:].encode())]
    shown = [json.loads(line[2:]) for line in lines[3:-1]]
    assert ours[-1] == shown[-1]
    told = [
        {key: reply["ev"][key] for key in event["ev"]}
        for reply, event in zip(ours, shown[:-1], strict=False)
    ]
    assert told == [event["ev"] for event in shown[:-1]]
    assert len(ours) == len(shown)
