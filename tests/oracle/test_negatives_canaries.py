"""Canaries fail where they must, and limits are judged as limits."""

from collections import Counter
from functools import cache

import msgspec
import pytest
from msgspec import UNSET, Raw, UnsetType
from negative_cases import made, rejected

from clers.conformance.cases.case import Case, operation_of, right_result
from clers.conformance.cases.faults import reference_answer
from clers.conformance.cases.identity import identity
from clers.conformance.judging.judge import judge
from clers.conformance.judging.judged import Judged, Status
from clers.conformance.lines import NoMessage, result_in
from clers.conformance.messages import OkReply, Rejection, RejectReply
from clers.conformance.outcome import Answered, Declined, Outcome
from clers.conformance.serve import INTRODUCTION
from clers.conventions.reason import Fault
from clers.oracle.negatives import canaries
from clers.oracle.suite.profiles import LIMITS

CANARIES = canaries()


def _answer(case: Case) -> Outcome:
    match reference_answer(case):
        case OkReply(ok=ok):
            result = result_in(case.op, ok)
            assert not isinstance(result, NoMessage)
            return Answered(result)
        case RejectReply(reject=reject):
            return Declined(reject)
        case other:
            raise AssertionError(other)


def _judged(case: Case, *, strict: bool = False) -> Judged:
    return judge(case, _answer(case), INTRODUCTION, strict_reasons=strict)


@pytest.mark.parametrize("case", CANARIES, ids=lambda case: case.id)
def test_the_reference_fails_each(case: Case) -> None:
    """Clauses: ORCL-CANARY-1, ORCL-SUITE-7."""
    assert _judged(case).status is Status.FAIL


@pytest.mark.parametrize("case", CANARIES, ids=lambda case: case.id)
def test_each_is_wrong_in_one_thing(case: Case) -> None:
    """With the right expectation in its place it passes. Clause: ORCL-CANARY-1."""
    right = reference_answer(case)
    match right:
        case OkReply(ok=ok):
            mended = msgspec.structs.replace(case, ok=ok, reject=UNSET)
        case RejectReply(reject=reject):
            mended = msgspec.structs.replace(case, ok=UNSET, reject=reject)
        case other:
            raise AssertionError(other)
    assert _judged(mended, strict=True).status is Status.PASS


def test_they_are_good_requests_with_readable_expectations() -> None:
    """Clauses: ORCL-CASE-1, ORCL-CASE-2, ORCL-CANARY-1."""
    for case in CANARIES:
        assert not isinstance(operation_of(case), NoMessage)
        assert isinstance(case.ok, UnsetType) is not isinstance(case.reject, UnsetType)
        if isinstance(case.reject, UnsetType):
            assert not isinstance(right_result(case), NoMessage)
        slug = case.id[:-9]
        assert slug.startswith("canary-")
        assert case.id == identity(slug, case)
        assert case.clauses == ("ORCL-CANARY-1",)
    assert len({case.id for case in CANARIES}) == len(CANARIES)


@pytest.mark.parametrize(
    ("slug", "kind"),
    [
        ("mirrored", "face"),
        ("vertices-exchanged", "face"),
        ("faces-in-another-order", "face"),
        ("face-turned", "face"),
        ("face-missing", "face"),
        ("symbol-exchanged", "symbol"),
        ("order-of-vertices", "vertex"),
        ("genus-off-by-one", "genus"),
        ("number-of-a-stage", "loops"),
        ("bit-turned", "bit"),
        ("bit-more", "bit"),
        ("symbol-of-a-code", "symbol"),
        ("coordinate-moved", "axis"),
        ("byte-missing", "byte"),
        ("record-missing", "record"),
        ("side-of-a-record", "record"),
        ("mirrored-mesh", "mesh"),
        ("corner-moved", "vertex"),
        ("garbage-accepted", "a result"),
        ("good-rejected", "whole input"),
        ("good-file-rejected", "whole input"),
        ("another-class", "class"),
    ],
)
def test_each_kind_is_there_and_diverges_there(slug: str, kind: str) -> None:
    """Clauses: ORCL-CANARY-1, ORCL-JUDGE-4."""
    (case,) = (case for case in CANARIES if case.id[7:-9] == slug)
    found = _judged(case)
    assert kind in found.why
    assert found.divergence is not UNSET


def test_operations_that_have_a_canary() -> None:
    """Clause: ORCL-CANARY-1."""
    assert Counter(case.op for case in CANARIES) == {
        "word.decode": 7, "word.encode": 4, "surface.classify": 1, "operator.apply": 1,
        "code.encode": 2, "code.decode": 1, "mesh.decode": 3, "mesh.encode": 1,
        "codec.roundtrip": 2,
    }  # fmt: skip


@cache
def _limited() -> tuple[Case, ...]:
    return tuple(case for profile, _, case in made() if profile == LIMITS)


def test_a_limit_may_be_found_by_whatever_is_wrong() -> None:
    """Clauses: ORCL-LIMIT-2, ORCL-JUDGE-7."""
    of_limit = [c for c in rejected() if _class(c) is Fault.LIMIT]
    assert len(of_limit) >= 20
    for case in of_limit:
        for fault in Fault:
            declined = Declined(Rejection(fault))
            assert judge(case, declined, INTRODUCTION).status is Status.PASS
            strict = judge(case, declined, INTRODUCTION, strict_reasons=True)
            assert strict.status is Status.FAIL
        assert _judged(case, strict=True).status is Status.PASS
        assert isinstance(case.input, Raw)
    (other, *_) = (c for c in rejected() if _class(c) is Fault.INVALID)
    for fault in Fault:
        found = judge(other, Declined(Rejection(fault)), INTRODUCTION)
        assert (found.status is Status.PASS) is (fault is Fault.INVALID)


def _class(case: Case) -> Fault:
    assert not isinstance(case.reject, UnsetType)
    return case.reject.fault


def test_limits_are_declared_by_few_bytes() -> None:
    """Clauses: ORCL-LIMIT-1, FILE-COUNT-4."""
    assert len(_limited()) >= 60
    assert all(len(bytes(case.input)) < 1000 for case in _limited())
    files = [case for case in _limited() if case.op == "mesh.decode"]
    assert Counter(_class(case) for case in files).keys() == {
        Fault.LIMIT, Fault.MALFORMED, Fault.INVALID,
    }  # fmt: skip
    sizes = {case.size for case in files}
    assert {4, 900_000, 1 << 26} <= sizes


def test_what_is_declared_and_borne_is_the_size() -> None:
    """A number that readers may bear or not is asked of those that bear it. ORCL-LIMIT-2."""
    for case in _limited():
        for number in (900_000, 1 << 26):
            if f"-{number}-" in case.id:
                assert case.size == number
