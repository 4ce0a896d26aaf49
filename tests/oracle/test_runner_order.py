"""Asking again in another order: which cases, and what their replies say."""

from hashlib import sha256

import pytest

from clers.conformance.judging.judged import GOOD, Divergence, Judged, Status
from clers.conformance.messages import Rejection, Step
from clers.conformance.outcome import (
    Answered,
    Crash,
    Declined,
    Erred,
    Flaky,
    NoProcess,
    Outcome,
    ProtocolError,
    TimedOut,
    Unsupported,
)
from clers.conformance.payloads import JustWord
from clers.conventions.reason import Fault
from clers.oracle.runs.order import again, leak
from clers.oracle.runs.pieces import Result
from clers.oracle.runs.said import NOTHING, said


def result(name: str, status: Status = Status.PASS, reply: str = "reply", why: str = "") -> Result:
    return Result(Judged(id=name, op="echo", clauses=("C",), status=status, why=why), reply)


def rank(name: str) -> str:
    return sha256(name.encode()).hexdigest()


def names(count: int) -> list[str]:
    return [f"case-{k}" for k in range(count)]


@pytest.mark.parametrize(
    ("count", "share"), [(0, 0), (7, 7), (20, 20), (1000, 20), (1001, 21), (5000, 100)]
)
def test_two_in_a_hundred(count: int, share: int) -> None:
    """ORCL-ORDER-1: rounded up, twenty at least, those of the smallest hash."""
    found = again([result(name) for name in names(count)])
    assert list(found) == sorted(sorted(names(count), key=rank)[:share], key=rank, reverse=True)


def test_only_what_was_answered() -> None:
    """ORCL-ORDER-1: a share of the replies, not of the cases."""
    answered = [result(name) for name in names(30)]
    mute = [result(f"mute-{k}", Status.SKIP, NOTHING) for k in range(5000)]
    found = again([*mute, *answered])
    assert len(found) == 20
    assert {*found} <= {*names(30)}


@pytest.mark.parametrize("status", [status for status in Status if status not in GOOD])
def test_failures_are_asked_again(status: Status) -> None:
    """ORCL-ORDER-1: the first twenty, beside the others; those without a reply are not."""
    passed = [result(name) for name in names(900)]
    failed = [result(f"failed-{k}", status) for k in range(25)]
    silent = [result(f"silent-{k}", status, NOTHING) for k in range(9)]
    found = again([*silent, *passed, *failed])
    few = sorted([*names(900), *(f"failed-{k}" for k in range(25))], key=rank)[:20]
    expected = {*few, *(f"failed-{k}" for k in range(20))}
    assert list(found) == sorted(expected, key=rank, reverse=True)


def test_another_reply_is_a_leak() -> None:
    """ORCL-ORDER-2."""
    before = Result(
        Judged(
            id="a",
            op="word.decode",
            clauses=("C", "D"),
            status=Status.FAIL,
            why="face 7 is wrong",
            signature="word.decode fail face",
            divergence=Divergence(kind="face", place="face 7", expected="1", got="2"),
        ),
        "one",
    )
    now = result("a", Status.PASS, "other")
    assert leak(before, now) == Judged(
        id="a",
        op="word.decode",
        clauses=("C", "D"),
        status=Status.FLAKY,
        why="state leaks: first fail (face 7 is wrong); in another order, of a new process, pass",
        signature="word.decode flaky state leaks",
    )
    assert leak(before, before) is None
    assert leak(result("a"), result("a", Status.CRASH, NOTHING)) is not None


REJECTION = Rejection(Fault.INVALID, "empty-word", {"symbol": 3}, "EB-GRAMMAR-1", "it is empty")
ALIKE: list[tuple[Outcome, Outcome]] = [
    (Answered({"a": 1, "b": 2}), Answered({"b": 2, "a": 1})),
    (Declined(REJECTION), Declined(Rejection(Fault.INVALID, "empty-word"))),
    (Declined(REJECTION), Declined(REJECTION, (Step(0, "C"),))),
    (Erred("at 0x7f01"), Erred("at 0x7f99")),
    (Unsupported("handles"), Unsupported("handles")),
]
DIFFERENT: list[Outcome] = [
    Answered({"a": 1}),
    Answered({"a": 2}),
    Answered(JustWord(word="CRE")),
    Answered(JustWord(word="CRE"), (Step(0, "C"),)),
    Answered(JustWord(word="CRE"), (Step(1, "C"),)),
    Declined(REJECTION),
    Declined(Rejection(Fault.MALFORMED, "empty-word")),
    Declined(Rejection(Fault.INVALID, "unknown-symbol")),
    Unsupported("handles"),
    Unsupported("components"),
    Erred("it is broken"),
]


@pytest.mark.parametrize(("one", "other"), ALIKE)
def test_replies_that_are_the_same(one: Outcome, other: Outcome) -> None:
    """ORCL-ORDER-2."""
    assert said(one) == said(other) != NOTHING


def test_replies_that_are_not_the_same() -> None:
    """ORCL-ORDER-2."""
    assert len({said(outcome) for outcome in DIFFERENT}) == len(DIFFERENT)


@pytest.mark.parametrize(
    "outcome",
    [
        Crash(3, ""),
        TimedOut(1.0, ""),
        ProtocolError("", "", ""),
        NoProcess("nobody"),
        Flaky(Crash(3, ""), Answered({})),
    ],
)
def test_no_reply(outcome: Outcome) -> None:
    """ORCL-ORDER-1."""
    assert said(outcome) == NOTHING
