"""A run of a suite against an adapter, as a value: all that a report is written from."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field

from clers.conformance.cases.case import Case
from clers.conformance.judging.judged import GOOD, Judged, Status
from clers.conformance.messages import Introduction


@dataclass(frozen=True, slots=True)
class Ruling:
    """A case of a profile, and what it came to. Clause: ORCL-HTML-1."""

    profile: str
    case: Case
    judged: Judged


@dataclass(frozen=True, slots=True)
class Report:
    """What was run, against whom, and what came of each case, in the suite's order.

    No times and no places of the machine are in it: equal runs have equal reports.
    `adapter` is the answer to hello, `command` the words of the adapter's command line, `notes` say
    of each flag what it means; `texts` are those of the clauses. `unfinished` says why cases are
    missing, or is empty.
    Clause: ORCL-HTML-1.
    """

    suite: str
    specification: str
    adapter: Introduction
    command: tuple[str, ...]
    rulings: tuple[Ruling, ...]
    notes: Mapping[str, str] = field(default_factory=dict)
    unfinished: str = ""
    texts: Mapping[str, str] = field(default_factory=dict)

    def counts(self) -> Mapping[Status, int]:
        """How many cases came to each status; none of those that did not occur."""
        return Counter(ruling.judged.status for ruling in self.rulings)

    def by_profile(self) -> Mapping[str, Mapping[Status, int]]:
        """The same for each profile, in the order in which profiles first occur."""
        found: dict[str, Counter[Status]] = {}
        for ruling in self.rulings:
            found.setdefault(ruling.profile, Counter())[ruling.judged.status] += 1
        return found

    def failures(self) -> tuple[Ruling, ...]:
        """What is not good, in order. Clause: ORCL-JUDGE-1."""
        return tuple(ruling for ruling in self.rulings if ruling.judged.status not in GOOD)

    def skips(self) -> Mapping[str, int]:
        """Why cases were skipped, and how many for each reason."""
        skipped = (r.judged for r in self.rulings if r.judged.status is Status.SKIP)
        return Counter(judged.why for judged in skipped)
