"""A page of the site as a strict reader sees it: its anchors, its addresses, its faults.

Clauses: TOOL-SITE-8, TOOL-SITE-9.
"""

import re
from collections import Counter
from dataclasses import dataclass, field
from typing import Final
from xml.parsers import expat

LANDMARKS: Final = ("html", "title", "header", "main", "h1")
"""Each page has one of each. Clause: TOOL-SITE-9."""

_VOID: Final = frozenset({b"meta", b"link", b"img", b"input", b"br", b"hr", b"wbr", b"mspace"})
_SELF_CLOSED: Final = re.compile(rb"<([a-z][a-z0-9]*)(?:\s[^<>]*)?/>")


@dataclass(slots=True)
class Reading:
    """What a page has: ids, addresses followed and addresses loaded with their lines, faults.

    `within` is the number of links around the place that is read.
    """

    ids: Counter[str] = field(default_factory=Counter)
    links: list[tuple[str, int]] = field(default_factory=list)
    loads: list[tuple[str, int]] = field(default_factory=list)
    faults: list[tuple[int, str]] = field(default_factory=list)
    within: int = 0
    elements: Counter[str] = field(default_factory=Counter)


def reading(page: bytes) -> Reading:
    """Read a page with an XML parser, which forgives nothing; to the first fault of form.

    What is well-formed XML, and writes an element without an end only where HTML does, is the same
    document for both.
    """
    found, parser = Reading(), expat.ParserCreate()
    parser.buffer_text = True

    def start(name: str, attributes: dict[str, str]) -> None:
        _element(found, name, attributes, parser.CurrentLineNumber)

    def end(name: str) -> None:
        found.within -= name == "a"

    parser.StartElementHandler = start
    parser.EndElementHandler = end
    try:
        parser.Parse(page, True)
    except expat.ExpatError as error:
        found.faults.append((error.lineno, f"is not well-formed: {expat.ErrorString(error.code)}"))
        return found
    for closed in _SELF_CLOSED.finditer(page):
        if closed[1] not in _VOID:
            line = page.count(b"\n", 0, closed.start()) + 1
            found.faults.append((line, f"<{closed[1].decode()}> is closed as HTML does not"))
    for name in LANDMARKS:
        if found.elements[name] != 1:
            found.faults.append((1, f"has {found.elements[name]} <{name}>"))
    for id_, times in found.ids.items():
        if times > 1:
            found.faults.append((1, f"has the id {id_} {times} times"))
    return found


def _element(found: Reading, name: str, attributes: dict[str, str], line: int) -> None:
    found.elements[name] += 1
    if name == "a":
        if found.within:
            found.faults.append((line, "has a link within a link"))
        found.within += 1
    if "id" in attributes:
        found.ids[attributes["id"]] += 1
    for key in ("href", "src"):
        if key in attributes:
            (found.links if name == "a" else found.loads).append((attributes[key], line))
    if name == "html" and not attributes.get("lang"):
        found.faults.append((line, "does not say its language"))
    if name == "img" and not attributes.get("alt"):
        found.faults.append((line, "a picture has no words in its place"))
    if name in ("input", "nav") and not attributes.get("aria-label"):
        found.faults.append((line, f"<{name}> has no name for those who do not see it"))
