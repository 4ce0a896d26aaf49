"""The minutes of a run: its events, kept in the order of the cases, and what they come to."""

from enum import StrEnum
from typing import Final, assert_never

from clers.conformance.judging.judged import GOOD, Judged, Status
from clers.oracle.reports.report import Ruling
from clers.oracle.runs.events import Came, Event, Gap, Sang, Stopped
from clers.oracle.runs.selection import Selected

PLUMBING: Final = "echo"
"""The operation that shows nothing of an implementation. Clause: ORCL-CHECK-4."""


class Ending(StrEnum):
    """What a run comes to as a whole. Clauses: ORCL-CHECK-4, ORCL-CHECK-5, ORCL-CHECK-11."""

    CONFORMS = "conforms"
    DOES_NOT = "does not conform"
    UNSOUND = "was not judged: the oracle's own check failed"


class Minutes:
    """What is known of a run so far. Mutable: `take` is called with each event."""

    def __init__(self, selected: Selected) -> None:
        self._selected = selected
        self._came: dict[str, Came] = {}
        self.canaries: list[Judged] = []
        self.gaps: list[Gap] = []
        self.stopped = ""

    def take(self, event: Event) -> None:
        """Write down what came of a case, or why nothing does. Clause: ORCL-ORDER-2."""
        match event:
            case Came(raw, _):
                self._came[raw.id] = event
            case Sang(judged):
                self.canaries.append(judged)
            case Gap():
                self.gaps.append(event)
            case Stopped(why):
                self.stopped = why
            case _:
                assert_never(event)

    def interrupt(self) -> None:
        """The run was interrupted. Clause: ORCL-CHECK-9."""
        self.stopped = "interrupted"

    @property
    def rulings(self) -> tuple[Ruling, ...]:
        """What each case came to that has a result, in the order of the suite. ORCL-CHECK-1."""
        return tuple(
            Ruling(chosen.profile, chosen.case, self._came[chosen.case.id].held)
            for chosen in self._selected.chosen
            if chosen.case.id in self._came
        )

    @property
    def raw(self) -> tuple[Judged, ...]:
        """The same results before they were held against known failures. ORCL-BASELINE-3."""
        return tuple(came.raw for came in self._came.values())

    @property
    def missing(self) -> int:
        """How many cases have no result, by the manifest's count. Clause: ORCL-CHECK-5."""
        return self._selected.counted - len(self._came)

    @property
    def unfinished(self) -> str:
        """Why cases have no result; empty if all have. Clauses: ORCL-CHECK-9, ORCL-CHECK-5."""
        if self.stopped:
            return f"{self.missing} cases were not asked: {self.stopped}"
        if self.missing:
            lost = "; ".join(gap.why for gap in self.gaps) or "they are not in the files"
            counts = f"{len(self._came)} results, {self._selected.counted} cases by the manifest"
            return f"{counts}: {lost}"
        return ""

    @property
    def sung(self) -> tuple[str, ...]:
        """The canaries that passed, which none should. Clause: ORCL-CHECK-11."""
        return tuple(judged.id for judged in self.canaries if judged.status is Status.PASS)

    def ending(self) -> tuple[Ending, str]:
        """What the run comes to, and why if it does not conform.

        Clauses: ORCL-CHECK-4, ORCL-CHECK-5, ORCL-CHECK-9, ORCL-CHECK-11.
        """
        results = [came.held for came in self._came.values()]
        if self.stopped:
            return Ending.DOES_NOT, self.unfinished
        if self.missing:
            return Ending.UNSOUND, self.unfinished
        bad = sum(judged.status not in GOOD for judged in results)
        if bad:
            return Ending.DOES_NOT, f"{bad} of {len(results)} cases"
        if all(judged.status is Status.SKIP or judged.op == PLUMBING for judged in results):
            return Ending.DOES_NOT, "every case was skipped but those of echo"
        if self.sung:
            return Ending.UNSOUND, f"wrong vectors passed: {', '.join(self.sung)}"
        return Ending.CONFORMS, ""
