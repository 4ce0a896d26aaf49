"""This repository obeys the rules on its own specification."""

from pathlib import Path

import pytest

import clers
from clers.cli.reading import read_with_laws
from clers.specification.check import RULES
from clers.specification.finding import Rule
from clers.specification.repository import Repository

ROOT = Path(clers.__file__).parents[2]


@pytest.fixture(scope="module")
def repository() -> Repository:
    return read_with_laws(ROOT)


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.__name__)
def test_rule(rule: Rule, repository: Repository) -> None:
    """Clause: CONV-CLAUSE-2."""
    faults = [finding.sentence for finding in rule(repository)]
    assert not faults, "\n".join(faults)


def test_there_is_something_to_obey(repository: Repository) -> None:
    """Clause: CONV-CLAUSE-2."""
    assert len(repository.clauses) > 300
    assert {clause.chapter for clause in repository.clauses} >= {0, 1, 2, 3, 4, 5, 6, 7, 8, 10}
    assert len(repository.pages) > 10
    assert sum(len(module.laws) for module in repository.modules) > 50
