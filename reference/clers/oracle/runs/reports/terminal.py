"""A run for people: blocks of failures, a table of profiles, what was lacking. ORCL-REPORT-2."""

from collections.abc import Iterator
from typing import Final

from clers.oracle.reports.grouped import Alike, grouped
from clers.oracle.reports.report import Report
from clers.oracle.runs.minutes import Ending, Minutes

BLOCKS: Final = 20
"""Blocks that are printed. Clause: ORCL-REPORT-2."""

BEGINNING: Final = 60
"""Characters of a clause that are shown."""


def blocks(report: Report) -> Iterator[str]:
    """A block for each signature of failure, line by line. Clause: ORCL-REPORT-2."""
    alike = grouped(report)
    for each in alike[:BLOCKS]:
        yield from _block(each)
    if len(alike) > BLOCKS:
        yield f"… and {len(alike) - BLOCKS} more kinds of failure: see --report html=FILE"
        yield ""


def _block(alike: Alike) -> Iterator[str]:
    first = alike.failures[0]
    judged, parted = first.ruling.judged, first.parted
    clauses = " ".join(_quoted(*clause) for clause in first.clauses[:1])
    yield f"{str(alike.status).upper()} {judged.id}  {judged.op}  {clauses}".rstrip()
    if parted is None:
        yield f"  {first.why}"
    else:
        said = f"expected {parted.expected}, got {parted.got}"
        yield f"  first divergence: {parted.place}: {said}"
    if alike.count > 1:
        yield f"  and {alike.count - 1} more like it"
    yield f"  more: {first.command}"
    yield ""


def _quoted(clause: str, text: str) -> str:
    """A clause with how it begins."""
    if not text:
        return clause
    short = text if len(text) <= BEGINNING else f"{text[: BEGINNING - 1].rstrip()}…"
    return f'{clause} "{short}"'


def tail(report: Report, minutes: Minutes) -> Iterator[str]:
    """What follows the table; the last line says whether the run conforms. ORCL-REPORT-2."""
    for why, count in report.skips().items():
        yield f"skipped {count}: {why}"
    if minutes.canaries:
        yield f"canaries: {len(minutes.sung)} of {len(minutes.canaries)} wrong vectors passed"
    ending, why = minutes.ending()
    counts = ", ".join(f"{count} {status}" for status, count in report.counts().items())
    who = f"{report.adapter.name} {report.adapter.version}"
    yield f"{who} {ending}: {counts if ending is Ending.CONFORMS else why}"
