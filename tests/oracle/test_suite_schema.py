"""The published schema of the files of a suite, and files that keep to it or do not."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Final

import jsonschema
import pytest
from msgspec import Raw, UnsetType
from tampered import first, whole
from typer.testing import CliRunner

from clers.cli.main import app
from clers.conformance.cases.case import PROFILES
from clers.conformance.results import RESULTS
from clers.oracle.suite.files import DEFAULT

SCHEMA: Final = Path(__file__).parents[2] / "spec" / "schemas" / "vectors.schema.json"


def schema() -> Mapping[str, object]:
    document: Mapping[str, object] = json.loads(SCHEMA.read_text())
    return document


def test_the_published_schema() -> None:
    """ORCL-CASE-7: is the one of the records."""
    done = CliRunner().invoke(app, ["schema", "vectors"])
    assert json.loads(done.stdout) == schema()


def test_the_files_keep_to_the_schema() -> None:
    """ORCL-CASE-7: all but the cases whole, of those the first and the last of each file."""
    validator = jsonschema.Draft202012Validator(schema())
    for name in ("manifest.json", "flags.json", "retired.json", "canaries.json"):
        validator.validate(json.loads((DEFAULT / name).read_text()))
    for entry in whole().manifest.files:
        document = json.loads((DEFAULT / entry.path).read_text())
        ends = [document["cases"][0], document["cases"][-1]]
        validator.validate({**document, "cases": ends})


@pytest.mark.parametrize("op", list(RESULTS))
def test_inputs_and_results_keep_to_the_schema(op: str) -> None:
    """ORCL-CASE-7: `operations` says of what form they are."""
    forms = schema()["operations"]
    assert isinstance(forms, dict)
    case = next(
        case
        for case in whole().cases
        if case.op == op and case.size < 10 and not isinstance(case.ok, UnsetType)
    )
    of_result = {**schema(), "anyOf": [forms[op]["ok"]]}
    jsonschema.validate(value(case.ok), of_result)
    of_request = {**schema(), "anyOf": [forms[op]["request"]]}
    jsonschema.validate({"op": op, "id": 0, "in": value(case.input)}, of_request)


def value(raw: Raw | UnsetType) -> object:
    assert not isinstance(raw, UnsetType)
    found: object = json.loads(bytes(raw))
    return found


@pytest.mark.parametrize(
    "document",
    [
        {"profile": "core", "op": "echo", "cases": [{"id": "x"}]},
        {"profile": "core", "op": "echo"},
        {"flags": [{"name": "x"}]},
        {},
    ],
)
def test_the_schema_refuses_others(document: Mapping[str, object]) -> None:
    """ORCL-CASE-7."""
    assert not jsonschema.Draft202012Validator(schema()).is_valid(document)


def test_profiles_in_the_manifest() -> None:
    """ORCL-SUITE-2, ORCL-SUITE-3."""
    assert [profile.name for profile in whole().manifest.profiles] == list(PROFILES)
    assert first("word.decode", "ok").op in RESULTS
