"""The laws of judging, and that each of them can fail."""

import msgspec
import pytest

from clers.conformance.cases.case import Case
from clers.conformance.judging.by_reference import answered
from clers.conformance.judging.judged import Divergence, Judged, Status
from clers.conformance.judging.laws import LAWS, Changed, Faced
from clers.conformance.laws import Wanted
from clers.conformance.messages import Introduction
from clers.conformance.outcome import Answered, Outcome, Unsupported
from clers.conformance.payloads import Faces
from clers.conformance.samples import SAMPLES
from clers.conformance.serve import INTRODUCTION
from clers.conventions.law import AnyLaw
from clers.conventions.verdict import Fails, Holds
from laws import run


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_law(law: AnyLaw) -> None:
    """Clauses: ORCL-JUDGE-2, ORCL-JUDGE-4, ORCL-JUDGE-5, ORCL-JUDGE-6, ORCL-JUDGE-10."""
    run(law)


LAW = {law.name: law for law in LAWS}
FOUND = answered(SAMPLES["word.decode"])
assert FOUND is not None
CASE, RIGHT = FOUND
WRONG = Answered(Faces(faces=((0, 1, 2), (3, 2, 1), (0, 1, 3), (2, 3, 0)), vertices=4))
CHANGED = Changed(CASE, WRONG, "face", (("face", 2),))
FAILED = Faced(CASE, WRONG, INTRODUCTION, strict=False)
PASSED = Faced(CASE, RIGHT, INTRODUCTION, strict=False)
LACKING = Faced(CASE, Unsupported("x"), INTRODUCTION, strict=False)
DIVERGENCE = Divergence(kind="face", place="face 2", expected="a", got="b", face=2)
PASS = Judged(id=CASE.id, op=CASE.op, clauses=(), status=Status.PASS)
FAIL = Judged(
    id=CASE.id, op=CASE.op, clauses=(), status=Status.FAIL, why="w", signature="s",
    divergence=DIVERGENCE,
)  # fmt: skip


def _with(judged: Judged, **changes: object) -> object:
    """A judge who says the same of everything."""

    def judge(_: Case, __: Outcome, ___: Introduction, *, strict_reasons: bool = False) -> Judged:
        return msgspec.structs.replace(judged, **changes)

    return judge


@pytest.mark.parametrize(
    ("law", "example", "fault"),
    [
        ("right-answers-pass", Wanted(SAMPLES["echo"]), _with(FAIL)),
        ("right-answers-pass", Wanted(SAMPLES["echo"]), _with(PASS, why="but")),
        ("right-answers-pass", Wanted(SAMPLES["echo"]), _with(PASS, signature="but")),
        ("changes-are-found-where-they-are", CHANGED, _with(PASS)),
        ("changes-are-found-where-they-are", CHANGED, _with(FAIL, status=Status.ERROR)),
        (
            "changes-are-found-where-they-are",
            CHANGED,
            _with(FAIL, divergence=msgspec.structs.replace(DIVERGENCE, kind="vertex")),
        ),
        (
            "changes-are-found-where-they-are",
            CHANGED,
            _with(FAIL, divergence=msgspec.structs.replace(DIVERGENCE, face=1)),
        ),
        (
            "changes-are-found-where-they-are",
            CHANGED,
            _with(FAIL, divergence=msgspec.structs.replace(DIVERGENCE, got="a")),
        ),
        ("every-outcome-has-a-verdict", FAILED, _with(FAIL, status=Status.CRASH)),
        ("every-outcome-has-a-verdict", FAILED, _with(FAIL, id="other-aaaaaaaa")),
        ("every-outcome-has-a-verdict", FAILED, _with(FAIL, op="echo")),
        ("every-outcome-has-a-verdict", FAILED, _with(FAIL, clauses=("EB-WORD-1",))),
        ("every-outcome-has-a-verdict", FAILED, _with(FAIL, signature="")),
        ("every-outcome-has-a-verdict", FAILED, _with(FAIL, divergence=msgspec.UNSET)),
        ("every-outcome-has-a-verdict", FAILED, _with(FAIL, why="")),
        ("every-outcome-has-a-verdict", PASSED, _with(PASS, why="but")),
        ("every-outcome-has-a-verdict", PASSED, _with(PASS, signature="s")),
        ("every-outcome-has-a-verdict", PASSED, _with(PASS, divergence=DIVERGENCE)),
        ("signatures-have-no-numbers", FAILED, _with(FAIL, signature="face 2")),
        ("what-is-declared-is-owed", LACKING, _with(PASS)),
    ],
)
def test_a_law_of_judging_can_fail(
    law: str, example: object, fault: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    """CONV-LAW-4: each law, on a judge with one fault."""
    assert LAW[law].check(example) == Holds()
    monkeypatch.setattr("clers.conformance.judging.laws.judge", fault)
    assert isinstance(LAW[law].check(example), Fails)
