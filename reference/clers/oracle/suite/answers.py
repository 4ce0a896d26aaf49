"""Every case answered by the reference, and judged like anybody's answer. Clause: ORCL-SUITE-4."""

from collections.abc import Iterator, Mapping

from clers.conformance.cases.case import Case, operation_of
from clers.conformance.cases.faults import fault_in
from clers.conformance.judging.judge import judge
from clers.conformance.judging.judged import Status
from clers.conformance.lines import NoMessage, result_in
from clers.conformance.messages import EventReply, OkReply, RejectReply, Step, UnsupportedReply
from clers.conformance.outcome import Answered, Declined, Erred, Outcome, Unsupported
from clers.conformance.serve import INTRODUCTION, serve
from clers.conventions.clause import Clause
from clers.oracle.suite.files import CANARIES
from clers.oracle.suite.problem import Problem


def outcome_of(case: Case) -> Outcome:
    """What the reference answers to a case, its steps if the case has a trace."""
    request = operation_of(case, "full" if case.trace else "none")
    if isinstance(request, NoMessage):
        return Erred(request.why)
    *events, last = serve(request)
    steps: tuple[Step, ...] = tuple(e.ev for e in events if isinstance(e, EventReply))
    match last:
        case OkReply(ok=ok):
            result = result_in(case.op, ok)
            return Erred(result.why) if isinstance(result, NoMessage) else Answered(result, steps)
        case RejectReply(reject=rejection):
            return Declined(rejection, steps)
        case UnsupportedReply(unsupported=lacking):
            return Unsupported(lacking.cap)
        case _:
            return Erred(str(last))


def of_answer(file: str, case: Case, suite: Mapping[str, Case]) -> Iterator[Problem]:
    """Is the case answered right, and does its fault undo? `suite` by id.

    Clauses: ORCL-SUITE-4, ORCL-FAULT-1, ORCL-FAULT-2.
    """
    outcome = outcome_of(case)
    judged = judge(case, outcome, INTRODUCTION, strict_reasons=True)
    if judged.status is not Status.PASS:
        what = f"the reference does not answer it right: {judged.why}"
        yield Problem(file, what, Clause.ORCL_SUITE_4, case.id)
    elif isinstance(outcome, Answered) and outcome.steps != case.trace:
        yield Problem(file, "the reference's walk is not its trace", Clause.ORCL_SUITE_4, case.id)
    fault = fault_in(case, suite)
    if fault and judged.status is Status.PASS:
        yield Problem(file, fault, Clause.ORCL_FAULT_2, case.id)


def of_canary(case: Case) -> Iterator[Problem]:
    """A canary is answered wrong, whoever answers right. Clause: ORCL-SUITE-7."""
    judged = judge(case, outcome_of(case), INTRODUCTION)
    if judged.status is not Status.FAIL:
        what = f"the reference comes to {judged.status}, and must fail"
        yield Problem(CANARIES, what, Clause.ORCL_SUITE_7, case.id)
