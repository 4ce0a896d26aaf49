"""What the site shows of a repository, and where. Clauses: TOOL-SITE-1, TOOL-SITE-5."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Final
from urllib.parse import unquote

from clers.site.places import clause_at, href, page_at, picture_at, source_at
from clers.specification.links import inside
from clers.specification.markdown import Page, anchors, links, page
from clers.specification.repository import Repository
from clers.specification.theorems import FOLDER

PICTURES: Final = (".svg", ".png")
_ELSEWHERE: Final = re.compile(r"[a-z][a-z0-9+.-]*:|//", re.IGNORECASE)
_ERRATUM: Final = re.compile(r"^erratum-([1-9][0-9]*)(?=-|$)")


@dataclass(frozen=True, slots=True)
class Plan:
    """The pages, sources and pictures by path; the place (page and anchor) of each id."""

    pages: Mapping[str, Page]
    sources: Mapping[str, str]
    pictures: Mapping[str, bytes]
    ids: Mapping[str, tuple[str, str]]

    def place(self, path: str) -> str | None:
        """Where a file of the repository stands in the site; None if it is not in it."""
        if path in self.pages:
            return page_at(path)
        if path in self.pictures:
            return picture_at(path)
        return source_at(path) if path in self.sources else None

    def of_id(self, here: str, clause: str) -> str | None:
        """The address of a clause or erratum, seen from a page; None if there is none."""
        place = self.ids.get(clause)
        return href(here, *place) if place else None

    def of_link(self, here: str, of: Page, target: str) -> str:
        """The address that a Markdown link has in the site; its own if it leads nowhere there."""
        if _ELSEWHERE.match(target):
            return target
        file, _, anchor = target.partition("#")
        path = inside(of, unquote(file)) if file else of.path
        place = self.place(path) if path else None
        return target if place is None else href(here, place, unquote(anchor))


def _linked(of: Page) -> Iterator[str]:
    """The paths of the files that a page links to."""
    for link in links(of):
        file = "" if _ELSEWHERE.match(link.target) else link.target.partition("#")[0]
        path = inside(of, unquote(file)) if file else None
        if path:
            yield path


def _text(file: Path) -> str | None:
    try:
        return file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError):  # a folder, or no text: the link to it is broken
        return None


def plan(of: Repository) -> Plan:
    """All pages, and what they link to; the files that cite clauses; the Coq files."""
    pages = {known.path: known for known in of.pages}
    sources: dict[str, str] = {}
    pictures: dict[str, bytes] = {}
    cited = {site.path for site in of.citations if not site.path.endswith(".md")}
    proofs = {file.relative_to(of.root).as_posix() for file in (of.root / FOLDER).rglob("*.v")}
    waiting = sorted(cited | proofs | {path for known in of.pages for path in _linked(known)})
    while waiting:
        path = waiting.pop()
        if path in pages or path in sources or path in pictures:
            continue
        if path.endswith(PICTURES):
            if (of.root / path).is_file():
                pictures[path] = (of.root / path).read_bytes()
        elif (text := _text(of.root / path)) is not None:
            if path.endswith(".md"):
                pages[path] = page(path, text)
                waiting += _linked(pages[path])
            else:
                sources[path] = text
    return Plan(pages, dict(sorted(sources.items())), pictures, _ids(of, pages))


def _ids(of: Repository, pages: Mapping[str, Page]) -> dict[str, tuple[str, str]]:
    found = {clause.clause: (page_at(clause.path), clause.clause) for clause in of.clauses}
    errata = pages.get("spec/errata.md")
    for anchor in sorted(anchors(errata)) if errata else ():
        number = _ERRATUM.match(anchor)
        if number:
            found[f"ERRATUM-{number[1]}"] = (page_at("spec/errata.md"), anchor)
    return found


def dossier_of(here: str, clause: str, part: str) -> str:
    """The address of a part of a clause's own page. Clause: TOOL-SITE-4."""
    return href(here, clause_at(clause), part)
