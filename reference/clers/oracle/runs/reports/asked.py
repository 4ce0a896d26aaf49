"""Reports that are asked for: of what kind, and into which file. ORCL-REPORT-4, ORCL-REPORT-7."""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from clers.conventions.result import Accepted, Rejected
from clers.meshfile.atomic import write_bytes
from clers.oracle.reports.html import html
from clers.oracle.reports.markdown import markdown
from clers.oracle.reports.report import Report
from clers.oracle.runs.reports.junit import junit

STREAMED: Final = "jsonl"
"""The kind that is written line by line. Clause: ORCL-REPORT-5."""

WHOLE: Final[Mapping[str, Callable[[Report], bytes]]] = {
    "junit": junit,
    "md": lambda report: markdown(report).encode(),
    "html": lambda report: html(report).encode(),
}
"""The kinds that are written when the run is over. Clause: ORCL-REPORT-7."""

KINDS: Final = (STREAMED, *WHOLE)
_BETWEEN: Final = re.compile(f",(?=(?:{'|'.join(KINDS)})=)")


@dataclass(frozen=True, slots=True)
class AskedFor:
    """A report and its file. Clause: ORCL-REPORT-4."""

    kind: str
    path: Path


@dataclass(frozen=True, slots=True)
class NoReport:
    """What was asked for is no report, and why. Clause: ORCL-REPORT-4."""

    why: str


def asked_for(texts: Sequence[str]) -> tuple[AskedFor, ...] | NoReport:
    """The reports that options name: `KIND=FILE`, or several with `,` between. ORCL-REPORT-4."""
    found: list[AskedFor] = []
    for text in (part for whole in texts for part in _BETWEEN.split(whole)):
        kind, is_one, path = text.partition("=")
        if not is_one or not path or kind not in KINDS:
            return NoReport(f"{text!r} is not KIND=FILE with a KIND of {', '.join(KINDS)}")
        found.append(AskedFor(kind, Path(path)))
    return tuple(found)


def write(asked: AskedFor, report: Report) -> Accepted[Path] | Rejected:
    """Write a report whole or not at all; a streamed one is there. Clause: ORCL-REPORT-7."""
    if asked.kind == STREAMED:
        return Accepted(asked.path)
    return write_bytes(asked.path, WHOLE[asked.kind](report))
