"""Clause ids in running text, single and in ranges. Clauses: CONV-CLAUSE-1, CONV-CLAUSE-8."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

SHAPE: Final = r"[A-Z]+(?:-[A-Z]+)+-[1-9][0-9]*"
_BETWEEN: Final = r"`?\s+to\s+`?|`?\s*(?:…|\.\.\.?|–)\s*`?"
_MENTION: Final = re.compile(
    rf"(?<![\w-])(?P<first>{SHAPE})(?:(?:{_BETWEEN})(?P<last>{SHAPE}))?(?![\w-])"
)
_ATTRIBUTE: Final = re.compile(r"[A-Z]+(?:_[A-Z]+)+_[1-9][0-9]*")


@dataclass(frozen=True, slots=True)
class Mention:
    """The id `clause` stands at `offset` (in characters) of a text, alone or within a range."""

    clause: str
    offset: int


def prefix(clause: str) -> str:
    """The chapter's part of an id, its first word."""
    return clause.partition("-")[0]


def series(clause: str) -> str:
    """The id without its number: chapter and topic."""
    return clause.rpartition("-")[0]


def number(clause: str) -> int:
    """The number at the end of an id; 0 if there is none."""
    tail = clause.rpartition("-")[2]
    return int(tail) if tail.isascii() and tail.isdecimal() else 0


def order(clause: str) -> tuple[str, int]:
    """Sort ids by series, then by number: 9 before 10."""
    return series(clause), number(clause)


def member(clause: str) -> str:
    """The id as a member of the generated enumeration, with `_` for `-`."""
    return clause.replace("-", "_")


def of_member(name: str) -> str | None:
    """The id a member's name stands for, if it has the form of one."""
    return name.replace("_", "-") if _ATTRIBUTE.fullmatch(name) else None


def mentions(text: str) -> Iterator[Mention]:
    """Every id in the text, left to right. Clause: CONV-CLAUSE-8.

    Two ids of one series joined by `to`, `…`, `...` or `–` are a range and mention every id from
    the first to the last, whether or not such clauses exist. Two ids joined like a range but of
    two series, or backwards, are two single mentions.
    """
    for match in _MENTION.finditer(text):
        first, last = match["first"], match["last"]
        yield Mention(first, match.start("first"))
        if last is None:
            continue
        if series(first) == series(last) and number(first) < number(last):
            for within in range(number(first) + 1, number(last)):
                yield Mention(f"{series(first)}-{within}", match.start("first"))
        yield Mention(last, match.start("last"))
