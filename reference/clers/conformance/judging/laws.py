"""The laws of judging: what is right passes, one change fails and is found, nothing is left out."""

from dataclasses import dataclass
from typing import Final

import msgspec

from clers.conformance.cases.case import Case
from clers.conformance.judging.by_reference import answered
from clers.conformance.judging.judge import judge
from clers.conformance.judging.judged import Divergence, Status
from clers.conformance.judging.needs import needs
from clers.conformance.laws import WANTED, Wanted
from clers.conformance.messages import Introduction
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
from clers.conformance.serve import INTRODUCTION
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Given, Law, every, same
from clers.conventions.verdict import Holds, Verdict


@dataclass(frozen=True, slots=True)
class Changed:
    """A case, an answer with one thing changed, and where: a kind of place, and its numbers."""

    case: Case
    outcome: Answered
    kind: str
    at: tuple[tuple[str, int], ...]


@dataclass(frozen=True, slots=True)
class Faced:
    """A case, whatever came of it, and what the adapter had declared."""

    case: Case
    outcome: Outcome
    said: Introduction
    strict: bool


CHANGED: Final = Given(
    "changed-answers", "right answers with one thing changed, and the place of the change", Changed
)
FACED: Final = Given("any-outcomes", "cases with outcomes of every kind, most of them bad", Faced)

STATUSES: Final[dict[type[Outcome], frozenset[Status]]] = {
    Answered: frozenset((Status.PASS, Status.FAIL)),
    Declined: frozenset((Status.PASS, Status.FAIL)),
    Unsupported: frozenset((Status.SKIP, Status.FAIL)),
    Erred: frozenset((Status.ERROR,)),
    NoProcess: frozenset((Status.ERROR,)),
    Crash: frozenset((Status.CRASH,)),
    TimedOut: frozenset((Status.TIMEOUT,)),
    ProtocolError: frozenset((Status.PROTOCOL,)),
    Flaky: frozenset((Status.FLAKY,)),
}
"""What each outcome may come to. Clause: ORCL-JUDGE-10."""


def _right(wanted: Wanted) -> Verdict:
    """What the reference does is right by the case that the reference makes."""
    found = answered(wanted.operation)
    if found is None:
        return Holds()
    judged = judge(*found, INTRODUCTION, strict_reasons=True)
    return same((Status.PASS, "", ""), (judged.status, judged.why, judged.signature))


def _found(changed: Changed) -> Verdict:
    """The change is the first divergence."""
    judged = judge(changed.case, changed.outcome, INTRODUCTION)
    if not isinstance(judged.divergence, Divergence):
        return same(changed.kind, str(judged.status))
    places = msgspec.structs.asdict(judged.divergence)
    return every(
        same(Status.FAIL, judged.status),
        same(True, judged.divergence.kind.startswith(changed.kind)),
        same(changed.at, tuple((key, places[key]) for key, _ in changed.at)),
        same(False, judged.divergence.expected == judged.divergence.got),
    )


def _total(faced: Faced) -> Verdict:
    """One of the verdicts that the outcome may come to, with all that belongs to it."""
    judged = judge(faced.case, faced.outcome, faced.said, strict_reasons=faced.strict)
    good = judged.status in (Status.PASS, Status.SKIP)
    return every(
        same(True, judged.status in STATUSES[type(faced.outcome)]),
        same((faced.case.id, faced.case.op), (judged.id, judged.op)),
        same(faced.case.clauses, judged.clauses),
        same(good, not judged.signature),
        same(judged.status is Status.FAIL, isinstance(judged.divergence, Divergence)),
        same(judged.status is not Status.PASS, bool(judged.why)),
    )


def _numberless(faced: Faced) -> Verdict:
    judged = judge(faced.case, faced.outcome, faced.said, strict_reasons=faced.strict)
    return same("", "".join(c for c in judged.signature if c.isnumeric()))


def _declared(faced: Faced) -> Verdict:
    """An adapter is excused from what it does not declare, and from nothing else."""
    judged = judge(faced.case, Unsupported("anything"), faced.said)
    excused = needs(faced.case, faced.said) is not None
    return same(Status.SKIP if excused else Status.FAIL, judged.status)


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "right-answers-pass",
        Clause.ORCL_JUDGE_2,
        "what the reference answers passes as the answer to the case that it makes",
        WANTED,
        _right,
    ),
    Law(
        "changes-are-found-where-they-are",
        Clause.ORCL_JUDGE_4,
        "an answer with one thing changed fails, and the first divergence is that very place",
        CHANGED,
        _found,
    ),
    Law(
        "every-outcome-has-a-verdict",
        Clause.ORCL_JUDGE_10,
        "each outcome comes to a status of its own; a failure, and nothing else, has a divergence",
        FACED,
        _total,
    ),
    Law(
        "signatures-have-no-numbers",
        Clause.ORCL_JUDGE_5,
        "no signature has a digit in it",
        FACED,
        _numberless,
    ),
    Law(
        "what-is-declared-is-owed",
        Clause.ORCL_JUDGE_6,
        "unsupported is excused where the case needs what is not declared, and only there",
        FACED,
        _declared,
    ),
)
"""The laws of this page."""
