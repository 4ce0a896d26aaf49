"""A run as Markdown. Clauses: ORCL-HTML-1, ORCL-HTML-2, ORCL-HTML-5."""

import re
from collections.abc import Iterator, Sequence

from clers.oracle.reports.grouped import (
    Alike,
    Failure,
    cut,
    facts,
    grouped,
    headline,
    summary,
)
from clers.oracle.reports.report import Report


def markdown(report: Report) -> str:
    """The report as a Markdown page (GitHub's), the same text for the same run.

    Clauses: ORCL-HTML-1, ORCL-HTML-2.
    """
    return "\n".join(_lines(report)) + "\n"


def _lines(report: Report) -> Iterator[str]:
    yield f"# {plain(report.adapter.name)} against the suite {plain(report.suite)}"
    yield ""
    yield plain(headline(report))
    yield ""
    yield from _table(("", ""), [(name, code(cut(text))) for name, text in facts(report)])
    yield ""
    yield "## Summary"
    yield ""
    heads, rows = summary(report)
    yield from _table(heads, rows)
    skips = report.skips()
    if skips:
        yield ""
        yield "## Skipped"
        yield ""
        rows = tuple((plain(why), str(count)) for why, count in skips.items())
        yield from _table(("why", "cases"), rows)
    found = grouped(report)
    if found:
        yield ""
        yield "## Failures"
    for alike in found:
        yield from _alike(alike)


def _alike(alike: Alike) -> Iterator[str]:
    yield ""
    yield f"### {plain(alike.signature)}: {alike.count}"
    for failure in alike.failures:
        yield from _failure(failure)
    if alike.others:
        yield ""
        rows = [(code(other.id), other.profile, code(other.why)) for other in alike.others]
        yield from _table(("case", "profile", "why"), rows)


def _failure(failure: Failure) -> Iterator[str]:
    judged = failure.ruling.judged
    yield ""
    yield f"#### {plain(judged.id)}"
    yield ""
    yield f"`{judged.op}`, profile {plain(failure.ruling.profile)}, **{judged.status}**"
    yield ""
    if failure.parted is None:
        yield f"- why: {code(failure.why)}"
    else:
        yield f"- first divergence: {code(failure.parted.place)}"
        yield f"- expected: {code(failure.parted.expected)}"
        yield f"- got: {code(failure.parted.got)}"
    for name, text in failure.clauses:
        yield f"- clause **{plain(name)}**" + (f": {' '.join(text.split())}" if text else "")
    for name, text in failure.flags:
        yield f"- flag **{plain(name)}**" + (f": {plain(text)}" if text else "")
    yield f"- more: {code(failure.command)}"


def _table(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> Iterator[str]:
    yield f"| {' | '.join(heads)} |"
    yield f"|{'---|' * len(heads)}"
    for row in rows:
        yield f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in row)} |"


def code(text: str) -> str:
    """Text on one line that is shown as it is, whatever marks it has. Clause: ORCL-HTML-5."""
    flat = " ".join(text.split())
    if not flat:
        return ""
    longest = max(map(len, re.findall("`+", flat)), default=0)
    fence = "`" * (longest + 1)
    space = " " if flat.startswith("`") or flat.endswith("`") else ""
    return f"{fence}{space}{flat}{space}{fence}"


def plain(text: str) -> str:
    """Text on one line, its marks escaped. Clause: ORCL-HTML-5."""
    return re.sub(r"([\\`*_{}\[\]<>#|~&])", r"\\\1", " ".join(text.split()))
