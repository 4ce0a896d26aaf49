"""Clauses as the chapters state them. Clauses: CONV-CLAUSE-1, CONV-CLAUSE-6."""

import hashlib
import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from clers.specification.identifier import SHAPE
from clers.specification.markdown import Page, Quote, quotes

_CHAPTER: Final = re.compile(r"(?:.*/)?(\d\d)-[^/]*\.md")
_OPENING: Final = re.compile(rf"\*\*({SHAPE})\.\*\*\s*")
_LIKE_OPENING: Final = re.compile(r"^\*\*[A-Za-z]+-[\w-]*[^*]*\*\*", re.MULTILINE)
_UNTESTABLE: Final = re.compile(r"(?<!`)\buntestable:[ \t]*\n?[ \t]*(.*)")


@dataclass(frozen=True, slots=True)
class ClauseText:
    """A clause: its id, its words without the id, and where it stands (`line` from 1)."""

    clause: str
    text: str
    chapter: int
    path: str
    line: int

    @property
    def untestable(self) -> str | None:
        """The written reason why no law or test can reach it; empty if the reason is missing."""
        found = _UNTESTABLE.search(self.text)
        return found[1].strip(" .*_") if found else None

    @property
    def hash(self) -> str:
        """SHA-256 of the text, each run of white space made one space. Clause: CONV-CLAUSE-4."""
        return hashlib.sha256(" ".join(self.text.split()).encode()).hexdigest()


@dataclass(frozen=True, slots=True)
class Misshapen:
    """A quote, or a line within one, that opens like a clause and is none."""

    opening: str
    path: str
    line: int


def chapter_number(path: str) -> int | None:
    """The number of the chapter in `spec/NN-name.md`; None for other pages."""
    found = _CHAPTER.fullmatch(path)
    return int(found[1]) if found else None


def clauses(chapter: int, page: Page) -> Iterator[ClauseText | Misshapen]:
    """The clauses of a chapter in their order, and what only looks like one."""
    for quote in quotes(page):
        found = _OPENING.match(quote.text)
        if found:
            body = quote.text[found.end() :]
            yield ClauseText(found[1], body, chapter, page.path, quote.line)
        yield from _misshapen(page.path, quote, skip=found is not None)


def _misshapen(path: str, quote: Quote, *, skip: bool) -> Iterator[Misshapen]:
    for like in list(_LIKE_OPENING.finditer(quote.text))[int(skip) :]:
        yield Misshapen(like[0], path, quote.line + quote.text.count("\n", 0, like.start()))
