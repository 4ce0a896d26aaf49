"""Checks: one request, asked and judged, by the reference or against a second adapter."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import count

import msgspec
from msgspec import UNSET, Raw

from clers.codes.registry import CodeName
from clers.conformance.cases.case import Case
from clers.conformance.in_words import in_words
from clers.conformance.judging.judge import judge
from clers.conformance.judging.judged import GOOD, Judged, Status
from clers.conformance.judging.needs import needs
from clers.conformance.messages import Caps, Introduction, Operation
from clers.conformance.outcome import (
    Answered,
    Declined,
    NoProcess,
    Outcome,
    Unsupported,
)
from clers.conformance.session import Asked, asked
from clers.oracle.fuzz.asking import Ask
from clers.oracle.fuzz.question import question


@dataclass(frozen=True, slots=True)
class Opposed:
    """What a second adapter said, and how the reference judges both. Clause: ORCL-AGAINST-2."""

    outcome: Outcome
    first: Judged
    second: Judged


@dataclass(frozen=True, slots=True)
class Tried:
    """A request that was asked, and what it came to. Clause: ORCL-FUZZ-2."""

    case: Case
    asked: Asked
    outcome: Outcome
    judged: Judged
    law: str = ""
    against: Opposed | None = None

    @property
    def good(self) -> bool:
        """Is there nothing to find?"""
        return self.judged.status in GOOD

    @property
    def gone(self) -> str:
        """Why there is nobody to ask any more; empty if there is. Clause: ORCL-RUN-6."""
        others = (self.against.outcome,) if self.against else ()
        return next(
            (each.why for each in (self.outcome, *others) if isinstance(each, NoProcess)), ""
        )


Check = Callable[[Operation], Tried | None]
"""Ask and judge; none where the request need not be asked. Clause: ORCL-FUZZ-2."""


@dataclass(frozen=True, slots=True)
class Asker:
    """Whom to ask, what it says of itself, and the next request's id."""

    ask: Ask
    said: Introduction
    ids: Iterator[int]

    def request(self, operation: Operation) -> Asked:
        """The operation under an id not used before, traced if the adapter traces it."""
        name = asked(0, operation).operation
        trace = "full" if name in self.said.caps.trace else "none"
        return asked(next(self.ids), msgspec.structs.replace(operation, trace=trace))


def asker(ask: Ask, said: Introduction) -> Asker:
    """Whom to ask, from its first request on."""
    return Asker(ask, said, count(1))


def afresh(of: Asker) -> Asker:
    """The same adapter, its requests numbered from 1 again. Clause: ORCL-FUZZ-3."""
    return asker(of.ask, of.said)


def by_reference(of: Asker) -> Check:
    """Judge by what the reference answers. Clause: ORCL-FUZZ-2."""

    def check(operation: Operation) -> Tried | None:
        case = question(operation)
        if case is None or needs(case, of.said) is not None:
            return None
        request = of.request(operation)
        outcome = of.ask(request)
        return Tried(case, request, outcome, judged_for(case, outcome, of.said))

    return check


def is_asked(case: Case | None, said: Introduction) -> Case | None:
    """The case, if its input is good and the adapter bears it. Clause: ORCL-FUZZ-7."""
    if case is None or needs(case, said) is not None or case.reject is not UNSET:
        return None
    return case


def judged_for(case: Case, outcome: Outcome, said: Introduction) -> Judged:
    """The verdict; but of a bad input nobody can say exactly what it requires. ORCL-FUZZ-2."""
    judged = judge(case, outcome, said)
    if isinstance(outcome, Unsupported) and case.reject is not UNSET and not _whole(said.caps):
        return msgspec.structs.replace(judged, status=Status.SKIP, signature="", divergence=UNSET)
    return judged


def _whole(caps: Caps) -> bool:
    """Are all capabilities declared, so that nothing can be lacking?"""
    return (
        caps.handles
        and caps.components
        and caps.boundaries == "many"
        and set(caps.codes) >= set(map(str, CodeName))
    )


def one_against_the_other(first: Asker, second: Asker) -> Check:
    """Judge the second's answer by the first's. Clauses: ORCL-AGAINST-1, ORCL-AGAINST-2."""

    def check(operation: Operation) -> Tried | None:
        case = question(operation)
        if case is None or needs(case, first.said) or needs(case, second.said):
            return None
        request = first.request(operation)
        here = first.ask(request)
        there = second.ask(second.request(operation))
        if isinstance(here, Unsupported) or isinstance(there, Unsupported):
            return None
        opposed = Opposed(there, judge(case, here, first.said), judge(case, there, second.said))
        return Tried(case, request, here, _compared(case, here, there, second.said), "", opposed)

    return check


def _compared(case: Case, here: Outcome, there: Outcome, said: Introduction) -> Judged:
    """Where the second parts from the first. Clause: ORCL-AGAINST-1."""
    match here:
        case Answered(result):
            expected = msgspec.structs.replace(
                case, ok=Raw(msgspec.json.encode(result)), reject=UNSET, trace=()
            )
        case Declined(rejection):
            expected = msgspec.structs.replace(case, ok=UNSET, reject=rejection)
        case _:
            both = judge(case, there, said)
            alone = judge(case, here, said)
            if both.status is alone.status:
                return msgspec.structs.replace(both, status=Status.PASS, why="", signature="")
            return _renamed(alone, f"the first: {in_words(here)}; the second: {in_words(there)}")
    there = Answered(there.result) if isinstance(there, Answered) else there
    judged = judge(expected, there, said)
    return judged if judged.status in GOOD else _renamed(judged, judged.why)


def _renamed(judged: Judged, why: str) -> Judged:
    return msgspec.structs.replace(judged, why=why, signature=f"against: {judged.signature}")
