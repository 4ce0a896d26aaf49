"""A run as one HTML file with pictures. Clauses: ORCL-HTML-1 … ORCL-HTML-5."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from msgspec import UnsetType

from clers.conventions.result import Rejected
from clers.oracle.explaining.pictured import Bounds, picture
from clers.oracle.reports.grouped import Alike, facts, grouped, headline, summary
from clers.oracle.reports.inline import inline
from clers.oracle.reports.report import Report
from clers.oracle.reports.templates_at import rendered

PICTURES: Final = 50
"""Pictures in a report, at most. Clause: ORCL-HTML-4."""

OF_A_KIND: Final = 5
"""Pictures of one signature, at most. Clause: ORCL-HTML-4."""

SMALL: Final = Bounds(faces=200, pixels=460)
"""What is pictured in a report. Clause: ORCL-HTML-4."""


@dataclass(frozen=True, slots=True)
class Figure:
    """A picture as it stands in the page, and the text in its place."""

    svg: str
    text: str


def html(report: Report) -> str:
    """The report as one HTML document, the same text for the same run. Clause: ORCL-HTML-3."""
    found = grouped(report)
    heads, rows = summary(report)
    return rendered(
        "report.html.jinja",
        {
            "title": f"{report.adapter.name} against the suite {report.suite}",
            "headline": headline(report),
            "good": not report.failures() and not report.unfinished,
            "facts": facts(report),
            "heads": heads,
            "rows": rows,
            "skips": tuple(report.skips().items()),
            "kinds": found,
            "figures": figures(report, found),
        },
    )


def figures(report: Report, found: tuple[Alike, ...]) -> Mapping[str, Figure]:
    """The pictures of a report, by the case's id. Clause: ORCL-HTML-4."""
    cases = {ruling.case.id: ruling.case for ruling in report.rulings}
    drawn: dict[str, Figure] = {}
    for alike in found:
        of_a_kind = 0
        for failure in alike.failures:
            if len(drawn) >= PICTURES or of_a_kind >= OF_A_KIND:
                break
            ruling = failure.ruling
            divergence = ruling.judged.divergence
            if isinstance(divergence, UnsetType):
                continue
            fault = ruling.case.fault
            parent = None if isinstance(fault, UnsetType) else cases.get(fault.parent)
            image = picture(ruling.case, divergence, parent=parent, bounds=SMALL)
            if isinstance(image, Rejected):
                continue
            text = f"The surface of {ruling.judged.id} at {divergence.place}"
            drawn[ruling.judged.id] = Figure(inline(image.value, f"f{len(drawn)}-", text), text)
            of_a_kind += 1
    return MappingProxyType(drawn)
