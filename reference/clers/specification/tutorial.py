"""The rule on the page about the tutorial: every place of it is somewhere. Clause: TOOL-PAGE-4."""

import re
from collections.abc import Iterator
from typing import Final

from clers.specification.finding import Finding
from clers.specification.identifier import mentions
from clers.specification.markdown import Page
from clers.specification.places import PLACES
from clers.specification.repository import Repository

TUTORIAL: Final = "spec/tutorial.md"
ERRATA: Final = "spec/errata.md"
_CLAUSE: Final = "TOOL-PAGE-4"
_ROW: Final = re.compile(r"\|(.*)\|\s*")
_HEADING: Final = re.compile(r"\|(?:\s*place\s*\||[\s|:-]+$)")
_ERRATUM: Final = re.compile(r"\bERRATUM-(\d+)\b")
_ENTRY: Final = re.compile(r"^### ERRATUM-(\d+)\.", re.MULTILINE)
_LEFT_OUT: Final = re.compile(r"\bleft out\b(?!: \S)")


def rows(page: Page) -> Iterator[tuple[int, str, str]]:
    """Line (from 1), first cell and last cell of each row below a heading."""
    for at, text in enumerate(page.text.splitlines(), 1):
        row = _ROW.fullmatch(text)
        if row and not _HEADING.match(text):
            cells = [cell.strip() for cell in row[1].split("|")]
            yield at, cells[0], cells[-1]


def every_place(of: Repository) -> Iterator[Finding]:
    """Each place of the tutorial has one row, which says where it is here. Clause: TOOL-PAGE-4."""
    pages = {page.path: page for page in of.pages}
    if TUTORIAL in pages:
        errata = pages.get(ERRATA)
        numbers = frozenset(_ENTRY.findall(errata.text)) if errata else frozenset[str]()
        yield from _faults(pages[TUTORIAL], numbers)
    elif _CLAUSE in of.ids:
        yield Finding("tutorial", TUTORIAL, 1, _CLAUSE, "there is no such page")


def _faults(page: Page, errata: frozenset[str]) -> Iterator[Finding]:
    waiting, named = set(PLACES), set[str]()
    for line, place, where in rows(page):
        told = _ERRATUM.findall(where)
        named.update(told)
        faults = [
            *([] if place in waiting else [f"{place} is no place, or has a row already"]),
            *(f"there is no erratum {number}" for number in told if number not in errata),
            *(["left out, and no reason after a colon"] if _LEFT_OUT.search(where) else []),
        ]
        if not told and "left out" not in where and not any(mentions(where)):
            faults.append(f"{place}: no clause, no erratum, and not left out")
        waiting.discard(place)
        for text in faults:
            yield Finding("tutorial", page.path, line, "", text)
    for place in sorted(waiting):
        yield Finding("tutorial", page.path, 1, "", f"{place} has no row")
    for number in sorted(errata - named, key=int):
        yield Finding("tutorial", page.path, 1, "", f"no row names erratum {number}")
