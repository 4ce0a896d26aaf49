"""Asking a finding's request again. Clauses: ORCL-REPLAY-1, ORCL-REPLAY-2."""

from dataclasses import dataclass
from enum import StrEnum

from msgspec import UnsetType

from clers.conformance.cases.case import operation_of
from clers.conformance.judging.judged import GOOD
from clers.conformance.judging.needs import needs
from clers.conformance.lines import NoMessage
from clers.oracle.finding import Finding, asked_of
from clers.oracle.fuzz.checks import Asker, Check, Tried, judged_for, one_against_the_other
from clers.oracle.fuzz.families import check_of


class Came(StrEnum):
    """What came of asking again. Clause: ORCL-REPLAY-2."""

    PASSES = "passes"
    FAILS_ALIKE = "fails alike"
    FAILS_OTHERWISE = "fails otherwise"
    NOT_ASKED = "not asked"


@dataclass(frozen=True, slots=True)
class Replayed:
    """A finding asked again: what it came to, and in comparison with before. ORCL-REPLAY-2."""

    came: Came
    tried: Tried | None
    why: str = ""


def check_for(finding: Finding, first: Asker, second: Asker | None) -> Check | str:
    """How such a finding is judged, or why it cannot be. Clause: ORCL-REPLAY-1."""
    if not isinstance(finding.against, UnsetType):
        if second is None:
            return "it was found against a second adapter: --against"
        return one_against_the_other(first, second)
    check = check_of(first, finding.case.op, finding.law)
    return check or f"the law {finding.law} needs operations that are not declared"


def replay(finding: Finding, first: Asker, second: Asker | None = None) -> Replayed:
    """Send the literal request and judge the answer. Clauses: ORCL-REPLAY-1, ORCL-REPLAY-2.

    Where a law or a second adapter is the judge, the same operation is asked of them.
    """
    if not finding.law and isinstance(finding.against, UnsetType):
        return _literally(finding, first)
    check = check_for(finding, first, second)
    operation = operation_of(finding.case)
    if isinstance(check, str) or isinstance(operation, NoMessage):
        return Replayed(Came.NOT_ASKED, None, check if isinstance(check, str) else "no request")
    tried = check(operation)
    if tried is None:
        return Replayed(Came.NOT_ASKED, None, "what it requires is not declared, or not answered")
    return Replayed(_came(finding, tried), tried)


def _literally(finding: Finding, first: Asker) -> Replayed:
    lacking = needs(finding.case, first.said)
    if lacking is not None:
        return Replayed(Came.NOT_ASKED, None, f"{lacking} is not declared")
    request = asked_of(finding)
    outcome = first.ask(request)
    judged = judged_for(finding.case, outcome, first.said)
    tried = Tried(finding.case, request, outcome, judged)
    return Replayed(_came(finding, tried), tried)


def _came(finding: Finding, tried: Tried) -> Came:
    if tried.judged.status in GOOD:
        return Came.PASSES
    same = tried.judged.signature == finding.judged.signature
    return Came.FAILS_ALIKE if same else Came.FAILS_OTHERWISE
