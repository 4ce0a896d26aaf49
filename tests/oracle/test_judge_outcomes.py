"""Verdicts on rejections and breakdowns, and their signatures, by hand."""

import msgspec
import pytest
from judged_by_hand import case_of

from clers.conformance.judging.judge import judge
from clers.conformance.judging.judged import Divergence, Status
from clers.conformance.messages import Rejection
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
)
from clers.conformance.payloads import Faces
from clers.conformance.samples import GARBAGE, SAMPLES
from clers.conformance.serve import INTRODUCTION
from clers.conventions.reason import Fault

GOOD = case_of(SAMPLES["word.decode"])
BAD = case_of(GARBAGE["word.decode"][0])
FILE = case_of(GARBAGE["mesh.decode"][0])
REJECTED = Rejection(Fault.INVALID, "unknown-symbol", {"symbol": 0}, "EB-GRAMMAR-1", "'X'")


@pytest.mark.parametrize(
    ("outcome", "status", "kind"),
    [
        (Crash(None, ""), Status.CRASH, " output closed"),
        (Crash(7, ""), Status.CRASH, " exit"),
        (Crash(0, ""), Status.CRASH, " exit"),
        (Crash(-11, "x"), Status.CRASH, " SIGSEGV"),
        (Crash(-6, ""), Status.CRASH, " SIGABRT"),
        (Crash(-99, ""), Status.CRASH, " signal"),
        (TimedOut(5.0, ""), Status.TIMEOUT, ""),
        (Erred("it is 7"), Status.ERROR, ""),
        (NoProcess("none"), Status.ERROR, " no process"),
        (
            ProtocolError("a reply with id 3, the request has id 5", "h", "s"),
            Status.PROTOCOL,
            " a reply with id",
        ),
        (ProtocolError("a result that it: no", "h", "s"), Status.PROTOCOL, " a result that it"),
        (ProtocolError("no number", "h", "s"), Status.PROTOCOL, " no number"),
        (Flaky(Crash(-9, ""), TimedOut(5.0, "")), Status.FLAKY, " SIGKILL"),
    ],
)
def test_breakdowns(outcome: Outcome, status: Status, kind: str) -> None:
    """Clauses: ORCL-JUDGE-1, ORCL-JUDGE-5, ORCL-JUDGE-10."""
    found = judge(GOOD, outcome, INTRODUCTION)
    assert found.status is status
    assert found.signature == f"word.decode {status}{kind}"
    assert found.divergence is msgspec.UNSET
    assert found.why


def test_a_result_where_a_rejection_is_right() -> None:
    """Clauses: ORCL-JUDGE-7, ORCL-DIVERGE-11."""
    found = judge(BAD, Answered(Faces(faces=(), vertices=0)), INTRODUCTION)
    assert found.signature == "word.decode fail a result instead of invalid"
    assert isinstance(found.divergence, Divergence)
    assert found.divergence.place == "at symbol 0"
    assert found.divergence.symbol == 0
    assert found.divergence.expected == "invalid: unknown-symbol at symbol 0 [EB-GRAMMAR-1]"
    assert found.divergence.got == 'answered: {"faces":[],"vertices":0}'


@pytest.mark.parametrize(
    ("at", "place", "numbers"),
    [
        ({}, "the whole input", (msgspec.UNSET,) * 4),
        ({"face": 2}, "at face 2", (msgspec.UNSET, 2, msgspec.UNSET, msgspec.UNSET)),
        (
            {"byte": 5, "section": "HEAD"},
            "at byte 5, section HEAD",
            (msgspec.UNSET, msgspec.UNSET, 5, msgspec.UNSET),
        ),
        (
            {"byte": 5, "section": ""},
            "at byte 5",
            (msgspec.UNSET, msgspec.UNSET, 5, msgspec.UNSET),
        ),
        ({"step": 3}, "at step 3", (msgspec.UNSET, msgspec.UNSET, msgspec.UNSET, 3)),
        ({"simplex": (1, 2)}, "at simplex (1, 2)", (msgspec.UNSET,) * 4),
    ],
)
def test_what_should_be_blamed_is_the_place(
    at: dict[str, int | str | tuple[int, ...]], place: str, numbers: tuple[object, ...]
) -> None:
    """Clause: ORCL-DIVERGE-11."""
    case = msgspec.structs.replace(BAD, reject=Rejection(Fault.LIMIT, "", at))
    found = judge(case, Answered({}), INTRODUCTION).divergence
    assert isinstance(found, Divergence)
    assert found.place == place
    assert (found.symbol, found.face, found.byte, found.stage) == numbers


def test_a_rejection_where_a_result_is_right() -> None:
    """Clause: ORCL-JUDGE-7."""
    found = judge(GOOD, Declined(REJECTED), INTRODUCTION)
    assert found.signature == "word.decode fail invalid instead of a result"
    assert found.why == (
        "the whole input: expected a result, got invalid: unknown-symbol at symbol 0 [EB-GRAMMAR-1]"
    )


def test_the_class_is_normative_and_the_rest_is_advice() -> None:
    """Clauses: ORCL-JUDGE-7, ORCL-FAULT-3."""
    bare = Declined(Rejection(Fault.INVALID))
    assert judge(BAD, bare, INTRODUCTION).status is Status.PASS
    found = judge(BAD, Declined(Rejection(Fault.MALFORMED, "unknown-symbol")), INTRODUCTION)
    assert found.signature == "word.decode fail malformed instead of invalid"
    assert found.why == (
        "the class of the rejection: "
        "expected invalid: unknown-symbol at symbol 0 [EB-GRAMMAR-1], got malformed: unknown-symbol"
    )


@pytest.mark.parametrize(
    ("change", "kind", "expected", "got"),
    [
        ({"reason": ""}, "reason", "unknown-symbol", "none"),
        ({"reason": "x", "at": {}}, "reason", "unknown-symbol", "x"),
        ({"at": {"symbol": 1}, "clause": ""}, "element", "symbol 0", "symbol 1"),
        ({"clause": "EB-GRAMMAR-2"}, "clause", "EB-GRAMMAR-1", "EB-GRAMMAR-2"),
    ],
)
def test_strict_reasons(change: dict[str, object], kind: str, expected: str, got: str) -> None:
    """Clauses: ORCL-DIVERGE-11, ORCL-FAULT-3."""
    outcome = Declined(msgspec.structs.replace(REJECTED, detail="other words", **change))
    assert judge(BAD, outcome, INTRODUCTION).status is Status.PASS
    found = judge(BAD, outcome, INTRODUCTION, strict_reasons=True)
    assert found.signature == f"word.decode fail {kind}"
    assert found.why == f"the {kind} of the rejection: expected {expected}, got {got}"


def test_the_detail_is_never_judged() -> None:
    """Clause: ORCL-DIVERGE-11."""
    outcome = Declined(msgspec.structs.replace(REJECTED, detail="other words"))
    assert judge(BAD, outcome, INTRODUCTION, strict_reasons=True).status is Status.PASS


def test_keys_of_an_element_have_no_order() -> None:
    """Clause: ORCL-DIVERGE-11."""
    at: dict[str, int | str | tuple[int, ...]] = {"section": "HEAD", "byte": 5}
    case = msgspec.structs.replace(BAD, reject=Rejection(Fault.LIMIT, "", at))
    other = Declined(Rejection(Fault.LIMIT, "", {"byte": 5, "section": "HEAD"}))
    assert judge(case, other, INTRODUCTION, strict_reasons=True).status is Status.PASS


def test_a_case_that_is_none_is_an_error_and_says_so() -> None:
    """Clause: ORCL-JUDGE-10: judging is total."""
    broken = msgspec.structs.replace(GOOD, ok=msgspec.Raw(b"[]"))
    found = judge(broken, Answered(Faces(faces=(), vertices=0)), INTRODUCTION)
    assert (found.status, found.signature) == (Status.ERROR, "word.decode error case")
    assert found.why.startswith("the case itself is none: ")
    broken = msgspec.structs.replace(GOOD, input=msgspec.Raw(b"{}"))
    found = judge(broken, Answered(Faces(faces=(), vertices=0)), INTRODUCTION)
    assert (found.status, found.signature) == (Status.ERROR, "word.decode error case")
