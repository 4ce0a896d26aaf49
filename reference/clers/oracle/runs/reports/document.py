"""A run as one JSON document. Clause: ORCL-REPORT-3."""

from collections.abc import Mapping

from msgspec import Struct

from clers.conformance.judging.judged import Judged, Status
from clers.conformance.messages import Introduction
from clers.oracle.reports.report import Report
from clers.oracle.runs.baseline import Stale
from clers.oracle.runs.minutes import Ending, Minutes


class Profile(Struct, frozen=True):
    """How many cases of a profile came to what."""

    profile: str
    counts: Mapping[Status, int]


class Document(Struct, frozen=True):
    """What `--json` prints. Clause: ORCL-REPORT-3."""

    suite: str
    specification: str
    command: tuple[str, ...]
    adapter: Introduction
    conforms: bool
    ending: Ending
    why: str
    cases: int
    missing: int
    counts: Mapping[Status, int]
    profiles: tuple[Profile, ...]
    lacking: Mapping[str, int]
    canaries: tuple[Judged, ...]
    stale: tuple[Stale, ...]
    results: tuple[Judged, ...]


def document(report: Report, minutes: Minutes, stale: tuple[Stale, ...]) -> Document:
    """The whole run. Clause: ORCL-REPORT-3."""
    ending, why = minutes.ending()
    return Document(
        suite=report.suite,
        specification=report.specification,
        command=report.command,
        adapter=report.adapter,
        conforms=ending is Ending.CONFORMS,
        ending=ending,
        why=why,
        cases=len(report.rulings),
        missing=minutes.missing,
        counts=report.counts(),
        profiles=tuple(Profile(name, counts) for name, counts in report.by_profile().items()),
        lacking=report.skips(),
        canaries=tuple(minutes.canaries),
        stale=stale,
        results=tuple(
            ruling.judged for ruling in report.rulings if ruling.judged.status is not Status.PASS
        ),
    )
