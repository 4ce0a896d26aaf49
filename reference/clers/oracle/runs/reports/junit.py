"""A run as JUnit XML, for systems that build and test. Clause: ORCL-REPORT-6."""

import re
from typing import Final
from xml.etree import ElementTree as Xml

from clers.conformance.judging.judged import Judged, Status
from clers.oracle.reports.report import Report

ELEMENT: Final = {
    Status.FAIL: "failure",
    Status.XPASS: "failure",
    Status.SKIP: "skipped",
    Status.XFAIL: "skipped",
    Status.CRASH: "error",
    Status.TIMEOUT: "error",
    Status.PROTOCOL: "error",
    Status.ERROR: "error",
    Status.FLAKY: "error",
}
"""What stands in a test case that did not pass. Clause: ORCL-REPORT-6."""

_FORBIDDEN: Final = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def junit(report: Report) -> bytes:
    """The file. Clauses: ORCL-REPORT-1, ORCL-REPORT-6."""
    root = Xml.Element("testsuites", name=_clean(f"{report.adapter.name}, {report.suite}"))
    totals = dict.fromkeys(("tests", "failures", "errors", "skipped"), 0)
    for profile in report.by_profile():
        judged = [ruling.judged for ruling in report.rulings if ruling.profile == profile]
        suite = Xml.SubElement(root, "testsuite", {"name": profile, **_counts(judged)})
        suite.extend(_case(profile, each) for each in judged)
        for key, number in _counts(judged).items():
            totals[key] += int(number)
    root.attrib.update({key: str(number) for key, number in totals.items()})
    Xml.indent(root)
    return b"<?xml version='1.0' encoding='utf-8'?>\n%b\n" % Xml.tostring(root, encoding="utf-8")


def _counts(judged: list[Judged]) -> dict[str, str]:
    elements = [ELEMENT.get(each.status, "") for each in judged]
    return {
        "tests": str(len(judged)),
        "failures": str(elements.count("failure")),
        "errors": str(elements.count("error")),
        "skipped": str(elements.count("skipped")),
    }


def _case(profile: str, judged: Judged) -> Xml.Element:
    case = Xml.Element("testcase", classname=f"{profile}.{judged.op}", name=judged.id)
    element = ELEMENT.get(judged.status)
    if element is None:
        return case
    said = Xml.SubElement(case, element, message=_clean(judged.why))
    if element != "skipped":
        said.set("type", str(judged.status))
        said.text = _clean(f"{judged.signature}\nclauses: {', '.join(judged.clauses)}")
    return case


def _clean(text: str) -> str:
    """What XML cannot have is replaced. Clause: ORCL-REPORT-6."""
    return _FORBIDDEN.sub("\ufffd", text)
