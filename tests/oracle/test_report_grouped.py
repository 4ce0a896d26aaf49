"""What both reports tell of a run. Clauses: ORCL-HTML-1, ORCL-HTML-2, ORCL-HTML-5."""

import shlex

import msgspec
import pytest
from reported import COMMAND, ECHO, HOSTILE, RULINGS, mirrored, numbered, report, ruled

from clers.conformance.judging.judged import Status
from clers.conformance.outcome import Answered, Erred
from clers.oracle.reports.grouped import (
    IN_FULL,
    LONGEST,
    Parted,
    cut,
    facts,
    grouped,
    headline,
    summary,
)
from clers.oracle.reports.report import Ruling
from clers.oracle.reports.texts import clause_texts


def test_failures_are_put_together_by_signature_in_order() -> None:
    """Clause: ORCL-HTML-2."""
    found = grouped(report())
    assert [(alike.signature, alike.status, alike.count) for alike in found] == [
        ("word.decode fail face", Status.FAIL, 22),
        ("word.decode fail malformed instead of invalid", Status.FAIL, 1),
        ("word.decode crash SIGSEGV", Status.CRASH, 1),
    ]


def test_the_first_twenty_are_told_in_full() -> None:
    """Clause: ORCL-HTML-2."""
    faces = grouped(report())[0]
    ids = [failure.ruling.judged.id for failure in faces.failures]
    assert ids == [f"turned-{k}-aaaaaaaa" for k in range(IN_FULL)]
    assert [(other.id, other.profile) for other in faces.others] == [
        ("turned-20-aaaaaaaa", "core"),
        ("turned-21-aaaaaaaa", "core"),
    ]
    assert faces.others[0].why.startswith("face 2, made by symbol 1 (R): expected (0, 3, 1)")


def test_a_failure_in_full() -> None:
    """Clause: ORCL-HTML-2."""
    failure = grouped(report())[0].failures[0]
    assert failure.parted == Parted("face 2, made by symbol 1 (R)", "(0, 3, 1)", "(0, 1, 3)")
    assert [name for name, _ in failure.clauses] == ["EB-ORDER-1", "EB-WORD-1"]
    assert failure.clauses[0][1].startswith("Vertices")
    assert failure.clauses[1][1] == ""
    assert failure.flags == (("mirrored", "right for left <b>; it matters"), ("deaf", ""))
    words = shlex.split(failure.command)
    assert words[:4] == ["clers", "explain", "turned-0-aaaaaaaa", "-a"]
    assert tuple(shlex.split(words[4])) == COMMAND


def test_a_failure_without_a_divergence() -> None:
    """Clause: ORCL-HTML-2."""
    crash = grouped(report())[2].failures[0]
    assert crash.parted is None
    assert crash.why.startswith("crash: exit code -11")


def test_summary() -> None:
    """Clause: ORCL-HTML-2: statuses that do not occur have no column."""
    heads, rows = summary(report())
    assert heads == ("profile", "cases", "pass", "fail", "skip", "crash")
    assert rows == (
        ("core", "23", "1", "22", "0", "0"),
        ("handles", "3", "0", "1", "1", "1"),
        ("all", "26", "1", "23", "1", "1"),
    )
    assert report().skips() == {"components is not declared": 1}


def test_known_failures_are_none_of_the_failures() -> None:
    """Clauses: ORCL-JUDGE-1, ORCL-HTML-2."""
    known = Ruling(
        "core",
        RULINGS[1].case,
        msgspec.structs.replace(RULINGS[1].judged, status=Status.XFAIL),
    )
    mended = Ruling(
        "core",
        RULINGS[0].case,
        msgspec.structs.replace(RULINGS[0].judged, status=Status.XPASS, signature="mended"),
    )
    found = report((known, mended))
    assert found.failures() == (mended,)
    assert summary(found)[0] == ("profile", "cases", "xfail", "xpass")


@pytest.mark.parametrize(
    ("rulings", "unfinished", "said"),
    [
        (RULINGS, "", "24 of 26 cases failed, 1 of 26 skipped."),
        (RULINGS[:1], "", "No case of 1 failed."),
        (RULINGS[:1], "interrupted", "Not finished: interrupted. 0 of 1 cases failed."),
        ((), "", "No case of 0 failed."),
    ],
)
def test_headlines(rulings: tuple[Ruling, ...], unfinished: str, said: str) -> None:
    """Clause: ORCL-HTML-2."""
    assert headline(report(rulings, unfinished)) == said


def test_who_was_asked_what() -> None:
    """Clause: ORCL-HTML-2."""
    assert facts(report()) == (
        ("adapter", f"{HOSTILE} 0.3 (c++)"),
        ("command", "'./fast mesh' '<x>'"),
        ("suite", "abcdefgh"),
        ("specification", "0.1"),
        ("operations", "echo, word.decode"),
        (
            "capabilities",
            "handles yes, boundaries one, components no, at most 10 faces and 20 symbols",
        ),
        ("codes", "plain"),
        ("coders", "none"),
        ("policy: ties", "<b>"),
    )


def test_long_texts_are_cut() -> None:
    """Clause: ORCL-HTML-5."""
    assert cut("x" * LONGEST) == "x" * LONGEST
    assert cut("x" * (LONGEST + 1)) == "x" * LONGEST + f"… ({LONGEST + 1} characters)"
    long: dict[str, object] = {"text": "y" * 1000}
    case = numbered(ECHO, "long")
    parted = grouped(report((ruled(case, Answered(long)),)))[0].failures[0].parted
    assert parted is not None
    assert max(len(parted.place), len(parted.expected), len(parted.got)) < LONGEST + 30
    erred = grouped(report((ruled(case, Erred("z" * 1000)),)))[0]
    assert len(erred.failures[0].why) < LONGEST + 30
    assert mirrored("a", 0) == ()


def test_the_texts_of_the_clauses_are_at_hand() -> None:
    """Clause: ORCL-HTML-2."""
    texts = clause_texts()
    assert texts["ORCL-LINE-2"].startswith("One request is open at a time")
    assert len(texts) > 800
