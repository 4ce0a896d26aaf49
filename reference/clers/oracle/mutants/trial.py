"""A mutant beside the cases: the first that brings it to light, or none."""

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Final

from clers.conformance.bounds import Bounds
from clers.conformance.cases.case import Case, operation_of
from clers.conformance.judging.judge import judge, skipped
from clers.conformance.judging.judged import GOOD, Judged, Status
from clers.conformance.judging.needs import needs
from clers.conformance.lines import NoMessage
from clers.conformance.messages import Introduction
from clers.conformance.outcome import Erred, NoProcess
from clers.conformance.session import Session, asked

ADAPTER: Final = (sys.executable, "-m", "clers.oracle.mutants.adapter")
"""The reference; with a mistake, if that is named after it. Clause: ORCL-MUTANT-2."""

BOUNDS: Final = Bounds(memory=4 << 30)


class Fate(StrEnum):
    """What became of a mutant; of a lost one nothing is known. Clauses: ORCL-MUTANT-3, -7."""

    KILLED = "killed"
    SURVIVED = "survived"
    STILLBORN = "stillborn"
    UNREACHED = "unreached"
    LOST = "lost"


@dataclass(frozen=True, slots=True)
class Tried:
    """The fate of a mutant; the case that killed it and what came of that; how many were asked.

    Of a stillborn one `why` is what its process said. Clause: ORCL-MUTANT-3.
    """

    fate: Fate
    asked: int
    by: str = ""
    status: str = ""
    why: str = ""


def tried(words: Sequence[str], cases: Sequence[Case]) -> Tried:
    """Ask a mutant case by case, until one shows its mistake. Clauses: ORCL-MUTANT-2, -3.

    `words` are the arguments of the adapter of mutants.
    """
    with Session((*ADAPTER, *words), BOUNDS) as mutant, Session(ADAPTER, BOUNDS) as reference:
        said = mutant.introduction()
        if isinstance(said, NoProcess):
            return Tried(Fate.STILLBORN, 0, why=said.why)
        for number, case in enumerate(cases, 1):
            judged = _asked(mutant, said, number, case)
            if judged.status not in GOOD and _passes(reference, number, case):
                return Tried(Fate.KILLED, number, case.id, judged.status, judged.why)
        return Tried(Fate.SURVIVED, len(cases))


def _asked(session: Session, said: Introduction, number: int, case: Case) -> Judged:
    lacking = needs(case, said)
    if lacking is not None:
        return skipped(case, lacking)
    request = operation_of(case, "full" if case.trace and case.op in said.caps.trace else "none")
    if isinstance(request, NoMessage):
        return judge(case, Erred(request.why), said)
    return judge(case, session.ask(asked(number, request)), said)


def _passes(reference: Session, number: int, case: Case) -> bool:
    """A case that the reference does not pass kills nobody. Clause: ORCL-MUTANT-3."""
    said = reference.introduction()
    return (
        not isinstance(said, NoProcess)
        and _asked(reference, said, number, case).status is Status.PASS
    )
