"""An outcome beside what is right. Pure and total. Clauses: ORCL-JUDGE-1 … ORCL-JUDGE-10."""

from typing import assert_never

from msgspec import UNSET, UnsetType

from clers.conformance.cases.case import Case, operation_of, right_result
from clers.conformance.in_words import in_words
from clers.conformance.judging.isomorphic import Undecidable
from clers.conformance.judging.judged import Divergence, Judged, Status
from clers.conformance.judging.known import Known
from clers.conformance.judging.needs import needs
from clers.conformance.judging.rejections import element_of, line_of, of_rejection
from clers.conformance.judging.results import of_results
from clers.conformance.judging.signature import breakdown, signature
from clers.conformance.judging.steps import of_steps
from clers.conformance.lines import NoMessage
from clers.conformance.messages import Introduction, Rejection, Step
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
from clers.conformance.results import Result


def judge(
    case: Case, outcome: Outcome, said: Introduction, *, strict_reasons: bool = False
) -> Judged:
    """What a case came to, and of a failure the first divergence. Total.

    `said` is the adapter's answer to hello; with `strict_reasons` a rejection's reason, element and
    clause are judged too. Clauses: ORCL-JUDGE-1 … ORCL-JUDGE-10.
    """
    match outcome:
        case Answered(result, steps):
            return _answered(case, result, steps)
        case Declined(rejection, _):
            return _declined(case, rejection, strict_reasons)
        case Unsupported(cap):
            return _unsupported(case, cap, said)
        case Erred() | NoProcess():
            status = Status.ERROR
        case Crash():
            status = Status.CRASH
        case TimedOut():
            status = Status.TIMEOUT
        case ProtocolError():
            status = Status.PROTOCOL
        case Flaky():
            status = Status.FLAKY
        case _:
            assert_never(outcome)
    return _judged(case, status, in_words(outcome), breakdown(outcome))


def skipped(case: Case, lacking: str) -> Judged:
    """The judgement on a case that need not be asked. Clause: ORCL-JUDGE-6."""
    return _judged(case, Status.SKIP, f"{lacking} is not declared")


def _judged(case: Case, status: Status, why: str = "", kind: str = "") -> Judged:
    return Judged(
        id=case.id,
        op=case.op,
        clauses=case.clauses,
        status=status,
        why=why,
        signature=signature(case.op, status, kind),
    )


def _failed(case: Case, divergence: Divergence) -> Judged:
    return Judged(
        id=case.id,
        op=case.op,
        clauses=case.clauses,
        status=Status.FAIL,
        why=f"{divergence.place}: expected {divergence.expected}, got {divergence.got}",
        signature=signature(case.op, Status.FAIL, divergence.kind),
        divergence=divergence,
    )


def _answered(case: Case, result: Result, steps: tuple[Step, ...]) -> Judged:
    """Clauses: ORCL-JUDGE-2, ORCL-JUDGE-3, ORCL-JUDGE-7, ORCL-JUDGE-9, ORCL-JUDGE-10."""
    if not isinstance(case.reject, UnsetType):
        return _failed(case, _not_rejected(case.reject, result))
    right = right_result(case)
    request = operation_of(case)
    if isinstance(right, NoMessage) or isinstance(request, NoMessage):
        why = next(found.why for found in (right, request) if isinstance(found, NoMessage))
        return _judged(case, Status.ERROR, f"the case itself is none: {why}", "case")

    known = Known(case, request)
    parted = of_steps(known.walk() if steps else (), steps) or of_results(
        right, result, case.compare, known
    )
    match parted:
        case None:
            return _judged(case, Status.PASS)
        case Divergence():
            return _failed(case, parted)
        case Undecidable(why):
            return _judged(case, Status.ERROR, f"undecided: {why}", "undecided")
        case _:
            assert_never(parted)


def _not_rejected(right: Rejection, got: Result) -> Divergence:
    """A result where a rejection is right. Clause: ORCL-JUDGE-7."""
    at = right.at
    symbol, face, byte, stage = (at.get(key) for key in ("symbol", "face", "byte", "step"))
    return Divergence(
        kind=f"a result instead of {right.fault}",
        place=f"at {element_of(right)}" if at else "the whole input",
        expected=line_of(right),
        got=in_words(Answered(got)),
        symbol=symbol if isinstance(symbol, int) else UNSET,
        face=face if isinstance(face, int) else UNSET,
        byte=byte if isinstance(byte, int) else UNSET,
        stage=stage if isinstance(stage, int) else UNSET,
    )


def _declined(case: Case, got: Rejection, strict: bool) -> Judged:
    """Clauses: ORCL-JUDGE-7, ORCL-FAULT-3."""
    if not isinstance(case.reject, UnsetType):
        parted = of_rejection(case.reject, got, strict=strict)
        return _judged(case, Status.PASS) if parted is None else _failed(case, parted)
    return _failed(
        case,
        Divergence(
            kind=f"{got.fault} instead of a result",
            place="the whole input",
            expected="a result",
            got=line_of(got),
        ),
    )


def _unsupported(case: Case, cap: str, said: Introduction) -> Judged:
    """Clause: ORCL-JUDGE-6."""
    lacking = needs(case, said)
    if lacking is not None:
        return skipped(case, lacking)
    return _failed(
        case,
        Divergence(
            kind="unsupported though declared",
            place="the capabilities",
            expected="an answer: all that is needed was declared at hello",
            got=f"unsupported: {cap}",
        ),
    )
