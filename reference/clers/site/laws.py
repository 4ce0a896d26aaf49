"""Laws of the site: what is linked stays the same text, and whatever breaks is found."""

import re
from dataclasses import dataclass
from html import unescape
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Given, Law, every, same
from clers.conventions.verdict import Verdict
from clers.site.mentions import linked
from clers.site.sound import Site, faults
from clers.site.sources import numbered

_TAG: Final = re.compile(r"<[^>]*>")
_LINE: Final = re.compile(r'<span id="L(\d+)"><a href="#L\1">\1</a>')


@dataclass(frozen=True, slots=True)
class Mentioning:
    """HTML, and how many ids stand in it outside links and formulas that are known clauses'."""

    html: str
    known: frozenset[str]
    mentions: int


@dataclass(frozen=True, slots=True)
class Source:
    """A source file: its path and text."""

    path: str
    text: str


@dataclass(frozen=True, slots=True)
class Break:
    """A sound site, and the same with one thing broken: what it is, and on which page."""

    sound: Site
    broken: Site
    what: str
    page: str


MENTIONING: Final = Given("texts with ids", "HTML with ids of clauses, known and not", Mentioning)
SOURCES: Final = Given("source files", "texts of strings, comments, keywords and ids", Source)
BREAKS: Final = Given("sites with a break", "a sound site, and it with one thing broken", Break)


def _address(known: frozenset[str], clause: str) -> str | None:
    return f"page.html#{clause}" if clause in known else None


def _mentions(of: Mentioning) -> Verdict:
    html = linked(of.html, lambda clause: _address(of.known, clause))
    return every(
        same(_TAG.sub("", of.html), _TAG.sub("", html)),
        same(of.mentions, html.count('<a class="id" ')),
    )


def _sources(of: Source) -> Verdict:
    html = numbered(of.path, of.text, lambda clause: _address(frozenset({"EB-WORD-1"}), clause))
    lines = of.text.removesuffix("\n").split("\n")
    shown = unescape(_TAG.sub("", _LINE.sub("", html)))
    return every(
        same(of.text.removesuffix("\n"), shown),
        same(list(range(1, len(lines) + 1)), [int(found[1]) for found in _LINE.finditer(html)]),
    )


def _breaks(of: Break) -> Verdict:
    return every(
        same((), faults(of.sound)),
        same((of.what, True), (of.what, of.page in {found.path for found in faults(of.broken)})),
    )


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "site-links-every-mention",
        Clause.TOOL_SITE_3,
        "Linking keeps the text, and links each id of a clause outside links and formulas once.",
        MENTIONING,
        _mentions,
    ),
    Law(
        "site-sources-keep-their-text",
        Clause.TOOL_SITE_5,
        "The page of a source file has its text, line for line, each with its anchor.",
        SOURCES,
        _sources,
    ),
    Law(
        "site-breaks-are-found",
        Clause.TOOL_SITE_8,
        "A sound site has no fault, and one with anything broken has it on the page it is on.",
        BREAKS,
        _breaks,
    ),
)
