"""An answer to a request, judged as the reference's case has it."""

import msgspec

from clers.conformance.cases.case import Case
from clers.conformance.judging.by_reference import answered
from clers.conformance.judging.judge import judge
from clers.conformance.judging.judged import Divergence, Judged
from clers.conformance.messages import Operation, Step
from clers.conformance.outcome import Answered
from clers.conformance.results import Result
from clers.conformance.serve import INTRODUCTION


def case_of(request: Operation) -> Case:
    """The case that a request is, by the reference."""
    found = answered(request)
    assert found is not None
    return found[0]


def right_of(request: Operation) -> Answered:
    """What the reference answers."""
    found = answered(request)
    assert found is not None
    assert isinstance(found[1], Answered)
    return found[1]


def judged_of(request: Operation, result: Result, steps: tuple[Step, ...] = ()) -> Judged:
    """The judgement on a result."""
    return judge(case_of(request), Answered(result, steps), INTRODUCTION)


def divergence_of(request: Operation, result: Result, steps: tuple[Step, ...] = ()) -> Divergence:
    """Where a wrong result diverges first."""
    found = judged_of(request, result, steps).divergence
    assert isinstance(found, Divergence)
    return found


def numbers_of(found: Divergence) -> dict[str, int]:
    """The numbers of a place, by name."""
    words = ("kind", "place", "expected", "got", "triangle")
    return {
        key: value
        for key, value in msgspec.structs.asdict(found).items()
        if key not in words and value is not msgspec.UNSET
    }
