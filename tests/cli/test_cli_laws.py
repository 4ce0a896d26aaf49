"""`clers laws` on a registry of three toy laws."""

import json

import pytest
from hypothesis import strategies as st
from hypothesis.strategies import SearchStrategy
from typer.testing import CliRunner

from clers.cli.main import app
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Given, Law, same
from clers.conventions.verdict import Holds

NUMBERS = Given("toy-numbers", "whole numbers", int)
UNKNOWN = Given("toy-unknown", "nobody can draw them", int)
TRUE = Law("true", Clause.CONV_LAW_1, "nothing is said", NUMBERS, lambda _: Holds())
SMALL = Law("small", Clause.CONV_LAW_2, "they are small", NUMBERS, lambda n: same(True, n < 5))
LOST = Law("lost", Clause.CONV_LAW_3, "nothing is said", UNKNOWN, lambda _: Holds())


def strategy_for(domain: str) -> SearchStrategy[object] | None:
    return st.integers() if domain == NUMBERS.name else None


def call(*arguments: str) -> tuple[int, str]:
    result = CliRunner().invoke(app, ["laws", *arguments])
    return result.exit_code, result.stdout


@pytest.fixture(autouse=True)
def registry(monkeypatch: pytest.MonkeyPatch) -> None:
    chapters: dict[int, tuple[AnyLaw, ...]] = {1: (TRUE,), 3: (SMALL, LOST)}
    monkeypatch.setattr("clers.laws.CHAPTERS", chapters)
    monkeypatch.setattr("clers.laws.ALL", (TRUE, SMALL, LOST))
    monkeypatch.setattr("clers.generate.domains.strategy_for", strategy_for)


def test_list() -> None:
    """Clause: CONV-LAW-3."""
    assert call("--chapter", "3") == (
        0,
        "law    clause      for all      holds\n"
        "small  CONV-LAW-2  toy-numbers  they are small\n"
        "lost   CONV-LAW-3  toy-unknown  nothing is said\n"
        "\n"
        "domain       meaning\n"
        "toy-numbers  whole numbers\n"
        "toy-unknown  nobody can draw them\n",
    )
    assert call("--chapter", "2")[0] == 2


def test_list_as_json() -> None:
    """Clause: TOOL-OUTPUT-1."""
    code, said = call("--json")
    assert (code, [law["name"] for law in json.loads(said)]) == (0, ["true", "small", "lost"])
    assert json.loads(said)[1] == {
        "name": "small",
        "clause": "CONV-LAW-2",
        "statement": "they are small",
        "domain": "toy-numbers",
        "meaning": "whole numbers",
    }


def test_run() -> None:
    """Clauses: CONV-LAW-5, TOOL-EXIT-1."""
    assert call("run", "--examples", "30") == (
        1,
        "ok      true [CONV-LAW-1] 30 examples\n"
        "FAILED  small [CONV-LAW-2] they are small\n"
        "        example:  5\n"
        "        expected: True\n"
        "        got:      False\n"
        "        where:    of the whole input\n"
        "ERROR   lost [CONV-LAW-3] no generator for the domain toy-unknown\n"
        "1 of 3 laws held\n",
    )


def test_run_one() -> None:
    """Clause: TOOL-EXIT-1."""
    said = "ok      true [CONV-LAW-1] 10 examples\n1 of 1 laws held\n"
    assert call("run", "--law", "true", "--examples", "10") == (0, said)
    assert call("run", "--chapter", "1", "--examples", "10") == (0, said)
    assert call("run", "--law", "lost")[0] == 1
    assert call("run", "--law", "none") == (2, "")
    assert call("run", "--chapter", "1", "--law", "small") == (2, "")
    assert call("run", "--examples", "0") == (2, "")


def test_run_as_json() -> None:
    """Clause: TOOL-OUTPUT-1."""
    code, said = call("run", "--json", "--examples", "30")
    assert code == 1
    assert json.loads(said) == [
        {"law": "true", "clause": "CONV-LAW-1", "outcome": "held", "examples": 30},
        {
            "law": "small",
            "clause": "CONV-LAW-2",
            "outcome": "failed",
            "example": "5",
            "expected": "True",
            "got": "False",
            "where": "of the whole input",
        },
        {
            "law": "lost",
            "clause": "CONV-LAW-3",
            "outcome": "unjudged",
            "why": "no generator for the domain toy-unknown",
        },
    ]


def test_nothing_to_run_is_no_success(monkeypatch: pytest.MonkeyPatch) -> None:
    """Clause: TOOL-EXIT-1."""
    monkeypatch.setattr("clers.laws.ALL", ())
    assert call("run") == (4, "")


def test_a_name_twice_is_no_registry(monkeypatch: pytest.MonkeyPatch) -> None:
    """Clauses: CONV-LAW-3, TOOL-EXIT-1."""
    monkeypatch.setattr("clers.laws.ALL", (TRUE, SMALL, TRUE))
    assert call("run") == (4, "")
    assert call() == (4, "")
