"""The rule on leave: every *may* of a clause stands in the list of freedoms. Clause: TOOL-PAGE-3.

A word alone does not tell leave from possibility: "a vertex may have none" allows nobody anything.
So the list says of each such clause what it leaves free, and to whom; or that it leaves nothing.
"""

import re
from collections.abc import Iterator
from typing import Final

from clers.specification.finding import Finding
from clers.specification.identifier import mentions
from clers.specification.markdown import Page
from clers.specification.repository import Repository

FREEDOM: Final = "spec/freedom.md"
_HEADING: Final = re.compile(r"^## Every \*may\*$", re.MULTILINE)
_NEXT: Final = re.compile(r"^#{1,2} ", re.MULTILINE)
_FIRST_CELL: Final = re.compile(r"^\|([^|]*)\|", re.MULTILINE)
_NOT_WORDS: Final = re.compile(r"`[^`]*`|\$[^$]*\$")
_LEAVE: Final = re.compile(
    r"\b(?:may|might|free(?:ly|dom)?|optional(?:ly)?|advice|anywhere|at will|at random|preferred"
    r"|need not|not matter|(?:any|either|whatever) (?:order|way))\b",
    re.IGNORECASE,
)


def leave(text: str) -> tuple[str, ...]:
    """The words of a clause's text by which it may give leave, in small letters, each once."""
    words = _NOT_WORDS.sub(" ", " ".join(text.split()))
    return tuple(dict.fromkeys(word.lower() for word in _LEAVE.findall(words)))


def listed(page: Page) -> dict[str, int]:
    """The ids in the first column of the list's tables, each with its line (from 1)."""
    heading = _HEADING.search(page.text)
    if heading is None:
        return {}
    following = _NEXT.search(page.text, heading.end())
    stop = following.start() if following else len(page.text)
    found: dict[str, int] = {}
    for cell in _FIRST_CELL.finditer(page.text, heading.end(), stop):
        line = page.text.count("\n", 0, cell.start()) + 1
        found |= {mention.clause: line for mention in mentions(cell[1])}
    return found


def every_may(of: Repository) -> Iterator[Finding]:
    """Each clause with such a word is in the list, and each one listed has one. TOOL-PAGE-3."""
    page = next((page for page in of.pages if page.path == FREEDOM), None)
    named = listed(page) if page else {}
    giving: set[str] = set()
    for clause in of.clauses:
        words = leave(clause.text)
        if words:
            giving.add(clause.clause)
        if words and clause.clause not in named:
            text = f"says {', '.join(words)}, and {FREEDOM} does not name it under Every *may*"
            yield Finding("leave", clause.path, clause.line, clause.clause, text)
    for clause_id, line in named.items():
        if clause_id in of.ids - giving:
            yield Finding("leave", FREEDOM, line, clause_id, "is listed, and has no such word")
