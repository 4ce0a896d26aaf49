"""The failures of a run, put together by signature: what both reports tell. ORCL-HTML-2."""

from dataclasses import dataclass
from shlex import join
from typing import Final

from msgspec import UnsetType

from clers.conformance.judging.judged import Judged, Status
from clers.oracle.reports.report import Report, Ruling

IN_FULL: Final = 20
"""Failures of one signature that are told in full. Clause: ORCL-HTML-2."""

LONGEST: Final = 400
"""Characters of what others say. Clause: ORCL-HTML-5."""


@dataclass(frozen=True, slots=True)
class Parted:
    """The first divergence in words."""

    place: str
    expected: str
    got: str


@dataclass(frozen=True, slots=True)
class Failure:
    """A failure in full; `clauses` and `flags` are names with texts. Clause: ORCL-HTML-2."""

    ruling: Ruling
    clauses: tuple[tuple[str, str], ...]
    flags: tuple[tuple[str, str], ...]
    parted: Parted | None
    why: str
    command: str


@dataclass(frozen=True, slots=True)
class Line:
    """A failure in a line."""

    id: str
    profile: str
    why: str


@dataclass(frozen=True, slots=True)
class Alike:
    """The failures of one signature: the first in full, the others by a line. ORCL-HTML-2."""

    signature: str
    status: Status
    count: int
    failures: tuple[Failure, ...]
    others: tuple[Line, ...]


def grouped(report: Report) -> tuple[Alike, ...]:
    """The failures by signature, in the order in which signatures first occur. ORCL-HTML-2."""
    alike: dict[str, list[Ruling]] = {}
    for ruling in report.failures():
        alike.setdefault(ruling.judged.signature, []).append(ruling)
    return tuple(_alike(report, name, rulings) for name, rulings in alike.items())


def _alike(report: Report, signature: str, rulings: list[Ruling]) -> Alike:
    return Alike(
        signature,
        rulings[0].judged.status,
        len(rulings),
        tuple(_failure(report, ruling) for ruling in rulings[:IN_FULL]),
        tuple(Line(r.judged.id, r.profile, cut(r.judged.why)) for r in rulings[IN_FULL:]),
    )


def _failure(report: Report, ruling: Ruling) -> Failure:
    judged, case = ruling.judged, ruling.case
    return Failure(
        ruling,
        tuple((name, report.texts.get(name, "")) for name in judged.clauses),
        tuple((name, report.notes.get(name, "")) for name in case.flags),
        _parted(judged),
        cut(judged.why),
        f"clers explain {judged.id} -a {join((join(report.command),))}",
    )


def _parted(judged: Judged) -> Parted | None:
    found = judged.divergence
    if isinstance(found, UnsetType):
        return None
    return Parted(cut(found.place), cut(found.expected), cut(found.got))


def cut(text: str) -> str:
    """The text, or its beginning with how much there is. Clause: ORCL-HTML-5."""
    return text if len(text) <= LONGEST else f"{text[:LONGEST]}… ({len(text)} characters)"


def headline(report: Report) -> str:
    """The run in a sentence."""
    failed, asked = len(report.failures()), len(report.rulings)
    skipped = report.counts().get(Status.SKIP, 0)
    rest = f", {skipped} of {asked} skipped" if skipped else ""
    if report.unfinished:
        return f"Not finished: {report.unfinished}. {failed} of {asked} cases failed{rest}."
    if failed:
        return f"{failed} of {asked} cases failed{rest}."
    return f"No case of {asked} failed{rest}."


def summary(report: Report) -> tuple[tuple[str, ...], tuple[tuple[str, ...], ...]]:
    """Heads, and a row for each profile and for all: how many cases came to what. ORCL-HTML-2."""
    counts = report.counts()
    seen = tuple(status for status in Status if counts.get(status, 0))
    rows = tuple(
        (name, str(sum(of.values())), *(str(of.get(status, 0)) for status in seen))
        for name, of in report.by_profile().items()
    )
    total = ("all", str(len(report.rulings)), *(str(counts[status]) for status in seen))
    return ("profile", "cases", *map(str, seen)), (*rows, total)


def facts(report: Report) -> tuple[tuple[str, str], ...]:
    """Who was asked what. Clause: ORCL-HTML-2."""
    said = report.adapter
    caps = said.caps
    able = (
        f"handles {'yes' if caps.handles else 'no'}, boundaries {caps.boundaries}, "
        f"components {'yes' if caps.components else 'no'}, "
        f"at most {caps.max_faces} faces and {caps.max_symbols} symbols"
    )
    return (
        ("adapter", f"{said.name} {said.version} ({said.language})"),
        ("command", join(report.command)),
        ("suite", report.suite),
        ("specification", report.specification),
        ("operations", ", ".join(said.ops)),
        ("capabilities", able),
        ("codes", ", ".join(caps.codes) or "none"),
        ("coders", ", ".join(caps.coders) or "none"),
        *((f"policy: {name}", text) for name, text in said.policy.items()),
    )
