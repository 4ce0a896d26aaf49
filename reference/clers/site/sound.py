"""What is wrong with a site: links that break, clauses without their place. TOOL-SITE-8."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from posixpath import normpath
from typing import Final
from urllib.parse import unquote

from clers.site.entries import entries_of
from clers.site.places import ENTRIES
from clers.site.reading import Reading, reading
from clers.specification.finding import Finding

_ELSEWHERE: Final = re.compile(r"(?:https?:)?//|mailto:|data:")


@dataclass(frozen=True, slots=True)
class Site:
    """The files of a site by path, and the page on which each clause is stated."""

    files: Mapping[str, bytes]
    clauses: Mapping[str, str]


def faults(site: Site) -> tuple[Finding, ...]:
    """Everything wrong with a site, in the order of its pages. Clauses: TOOL-SITE-8, -9."""
    pages = {
        path: reading(data) for path, data in sorted(site.files.items()) if path.endswith(".html")
    }
    return (
        *(finding for path in pages for finding in _of_page(site, pages, path)),
        *_of_search(site, pages),
        *_of_clauses(site, pages),
    )


def _at(path: str, line: int, text: str, clause: str = "") -> Finding:
    return Finding("site", path, line, clause, text)


def _of_page(site: Site, pages: Mapping[str, Reading], path: str) -> Iterator[Finding]:
    page = pages[path]
    yield from (_at(path, line, text) for line, text in page.faults)
    for target, line in page.loads:
        if _ELSEWHERE.match(target):
            yield _at(path, line, f"loads {target} from elsewhere")
    for target, line in (*page.links, *page.loads):
        why = None if _ELSEWHERE.match(target) else _broken(site, pages, path, target)
        if why:
            yield _at(path, line, f"link to {target}: {why}")


def _broken(site: Site, pages: Mapping[str, Reading], here: str, target: str) -> str | None:
    """Why an address leads nowhere, or None."""
    file, _, anchor = target.partition("#")
    folder = here.rpartition("/")[0]
    there = normpath(f"{folder}/{unquote(file)}" if folder else unquote(file)) if file else here
    if there not in site.files:
        return "no such file"
    if anchor and there in pages and unquote(anchor) not in pages[there].ids:
        return "no such anchor"
    return None


def _of_search(site: Site, pages: Mapping[str, Reading]) -> Iterator[Finding]:
    if ENTRIES not in site.files:
        yield _at(ENTRIES, 1, "is not there")
        return
    entries = entries_of(site.files[ENTRIES])
    for line, entry in enumerate(entries, 2):
        why = _broken(site, pages, "index.html", entry.href)
        if why:
            yield _at(ENTRIES, line, f"link to {entry.href}: {why}")
    for clause in sorted(site.clauses.keys() - {entry.title for entry in entries}):
        yield _at(ENTRIES, 1, "the search does not know it", clause)


def _of_clauses(site: Site, pages: Mapping[str, Reading]) -> Iterator[Finding]:
    places: dict[str, list[str]] = {clause: [] for clause in site.clauses}
    for where, page in pages.items():
        for clause in page.ids.keys() & places.keys():
            places[clause].append(where)
    for clause, path in site.clauses.items():
        found = places[clause]
        if found != [path]:
            named = ", ".join(found) or "no page"
            yield _at(path, 1, f"its anchor is on {named}, and not on this page alone", clause)
