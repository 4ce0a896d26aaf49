"""Known failures: what they make of results, how they are written, and ids that are gone."""

from pathlib import Path

import pytest
from small_suite import CODED, ECHOES, WORDS, small_suite

from clers.conformance.cases.case import Case
from clers.conformance.judging.judged import GOOD, Judged, Status
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.oracle.runs.baseline import (
    Baseline,
    Expected,
    Known,
    Stale,
    baseline_bytes,
    read_baseline,
    stale,
    written,
)
from clers.oracle.suite.files import Suite


@pytest.fixture(scope="module")
def suite(tmp_path_factory: pytest.TempPathFactory) -> Suite:
    return small_suite(tmp_path_factory.mktemp("suite"))


def came(case: Case, status: Status, signature: str = "", why: str = "") -> Judged:
    return Judged(
        id=case.id, op=case.op, clauses=case.clauses, status=status, why=why, signature=signature
    )


CASE = WORDS[0]
BAD = [status for status in Status if status not in (*GOOD, Status.XPASS)]


@pytest.mark.parametrize("status", BAD)
def test_a_failure_that_is_known(status: Status) -> None:
    """ORCL-BASELINE-2."""
    hold = Expected((Known(CASE.id, status, "word face"),)).of
    judged = came(CASE, status, "word face", "it parts")
    assert hold(judged) == came(CASE, Status.XFAIL, "word face", "it parts")
    assert hold(came(CASE, Status.SKIP)) == came(CASE, Status.SKIP)
    assert hold(came(ECHOES[0], status)) == came(ECHOES[0], status)


def test_a_known_failure_that_fails_otherwise() -> None:
    """ORCL-BASELINE-2: it stays what it is, and says how it was known to fail."""
    hold = Expected(
        (Known(CASE.id, Status.FAIL, "word face"), Known(ECHOES[0].id, Status.CRASH, ""))
    ).of
    assert hold(came(CASE, Status.FAIL, "word bit", "parts")) == came(
        CASE, Status.FAIL, "word bit", "parts (known otherwise: word face)"
    )
    assert hold(came(CASE, Status.CRASH, "word face")).status is Status.CRASH
    assert hold(came(ECHOES[0], Status.TIMEOUT, "", "late")).why == "late (known otherwise: crash)"


def test_a_known_failure_that_passes() -> None:
    """ORCL-BASELINE-2: xpass, but for one that was seen to fail only at times."""
    hold = Expected((Known(CASE.id, Status.FAIL, "x"), Known(ECHOES[0].id, Status.FLAKY, "y"))).of
    assert hold(came(CASE, Status.PASS)) == came(CASE, Status.XPASS, why="known as fail, it passes")
    assert hold(came(ECHOES[0], Status.PASS)).status is Status.XFAIL
    assert Status.XPASS not in GOOD
    assert hold(came(ECHOES[1], Status.PASS)) == came(ECHOES[1], Status.PASS)


def test_the_file(suite: Suite, tmp_path: Path) -> None:
    """ORCL-BASELINE-1: one failure a line, by id; it is read as it was written."""
    results = [
        came(CASE, Status.FAIL, "word.decode fail face"),
        came(WORDS[1], Status.PASS),
        came(ECHOES[3], Status.CRASH, "echo crash"),
        came(ECHOES[4], Status.SKIP),
    ]
    baseline = written(suite, results, None)
    assert baseline_bytes(baseline).decode() == (
        f'{{"suite":"{suite.manifest.suite}","known":[\n'
        f'{{"id":"{ECHOES[3].id}","status":"crash","signature":"echo crash"}},\n'
        f'{{"id":"{CASE.id}","status":"fail","signature":"word.decode fail face"}}\n'
        "]}\n"
    )
    file = tmp_path / "known.json"
    file.write_bytes(baseline_bytes(baseline))
    found = read_baseline(file)
    assert isinstance(found, Accepted)
    assert sorted(found.value.known, key=str) == sorted(baseline.known, key=str)
    assert found.value.suite == suite.manifest.suite
    hold = Expected(found.value.known).of
    assert {hold(result).status for result in results} <= GOOD
    assert baseline_bytes(Baseline("s", ())) == b'{"suite":"s","known":[]}\n'


def test_what_the_run_did_not_judge_is_kept(suite: Suite) -> None:
    """ORCL-BASELINE-3: but not what the suite no longer has, nor what was judged anew."""
    before = Baseline(
        "older",
        (
            Known(ECHOES[0].id, Status.FAIL, "not asked"),
            Known(ECHOES[1].id, Status.FAIL, "skipped"),
            Known(CASE.id, Status.FAIL, "passes now"),
            Known(CODED[0].id, Status.FAIL, "fails otherwise"),
            Known("gone-aaaaaaaa", Status.FAIL, ""),
        ),
    )
    results = [
        came(CASE, Status.PASS),
        came(CODED[0], Status.CRASH, "now"),
        came(ECHOES[1], Status.SKIP),
    ]
    assert written(suite, results, before) == Baseline(
        suite.manifest.suite,
        (before.known[0], before.known[1], Known(CODED[0].id, Status.CRASH, "now")),
    )


def test_ids_that_are_gone(suite: Suite) -> None:
    """ORCL-BASELINE-4."""
    names = (CASE.id, "old-aaaaaaaa", "gone-aaaaaaaa", "never-aaaaaaaa")
    baseline = Baseline("s", tuple(Known(name, Status.FAIL, "") for name in names))
    assert stale(suite, baseline) == (
        Stale("old-aaaaaaaa", f"retired, now {CASE.id}: it was wrong"),
        Stale("gone-aaaaaaaa", "retired: it was twice there"),
        Stale("never-aaaaaaaa", "unknown to the suite"),
    )


@pytest.mark.parametrize(
    "text",
    [
        b"",
        b"[]",
        b'{"suite":"s"}',
        b'{"suite":"s","known":[],"more":1}',
        b'{"suite":"s","known":[{"id":"a-aaaaaaaa","status":"fail"}]}',
        b'{"suite":"s","known":[{"id":"a-aaaaaaaa","status":"odd","signature":""}]}',
        b'{"suite":"s","known":[{"id":"a","status":"fail","signature":""}]}',
        b'{"suite":"s","known":[{"id":"a-aaaaaaaa","status":"pass","signature":""}]}',
        b'{"suite":"s","known":[{"id":"a-aaaaaaaa","status":"skip","signature":""}]}',
        b'{"suite":"s","known":[{"id":"a-aaaaaaaa","status":"xfail","signature":""}]}',
        b'{"suite":"s","known":[{"id":"a-aaaaaaaa","status":"xpass","signature":""}]}',
        b'{"suite":"\xff","known":[]}',
        b"[" * 10_000,
    ],
)
def test_no_baseline(tmp_path: Path, text: bytes) -> None:
    """ORCL-BASELINE-5."""
    file = tmp_path / "known.json"
    file.write_bytes(text)
    found = read_baseline(file)
    assert isinstance(found, Rejected)
    assert found.reason is Reason.UNREADABLE_FILE
    assert found.detail != ""


def test_no_file(tmp_path: Path) -> None:
    """ORCL-BASELINE-5."""
    found = read_baseline(tmp_path / "known.json")
    assert isinstance(found, Rejected)
    assert found.detail == "No such file or directory"
