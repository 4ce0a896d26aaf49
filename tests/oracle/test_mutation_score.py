"""The score in the manifest is of the mutants that there are."""

from clers.conventions.result import Accepted
from clers.oracle.mutants.every import BY_NAME, MUTANTS
from clers.oracle.mutants.explained import EXPLAINED
from clers.oracle.suite.files import DEFAULT, read_suite
from clers.oracle.suite.records import Score


def test_the_score_of_the_suite_is_of_these_mutants() -> None:
    """Clauses: ORCL-MUTANT-5, ORCL-MUTANT-6."""
    suite = read_suite(DEFAULT)
    assert isinstance(suite, Accepted)
    score = suite.value.manifest.mutation
    assert isinstance(score, Score)
    assert score.mutants == len(MUTANTS)
    assert score.killed + len(score.survivors) == score.mutants
    assert score.killed >= 0.98 * score.mutants
    assert {found.mutant: found.why for found in score.survivors} == dict(EXPLAINED)
    assert set(EXPLAINED) <= set(BY_NAME)
