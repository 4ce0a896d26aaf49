"""Where a clause is cited, and what kind of place that is. Clause: CONV-CLAUSE-2."""

from dataclasses import dataclass
from enum import StrEnum

from clers.specification.identifier import mentions
from clers.specification.markdown import Page


class Kind(StrEnum):
    """What cites: only `CODE`, and `LAW` or `TEST`, make a clause covered."""

    CODE = "code"
    LAW = "law"
    TEST = "test"
    NOTE = "note"
    PROSE = "prose"


@dataclass(frozen=True, slots=True)
class Citation:
    """The id `clause` stands at a line of a file; `inside` is the definition or law around it."""

    clause: str
    kind: Kind
    path: str
    line: int
    inside: str = ""

    @property
    def place(self) -> str:
        """File, line and definition, as compilers print them."""
        inside = f" ({self.inside})" if self.inside else ""
        return f"{self.path}:{self.line}{inside}"


def in_page(page: Page, kind: Kind) -> tuple[Citation, ...]:
    """Every id in a page of prose; where a clause is stated, its own id too."""
    return tuple(
        Citation(mention.clause, kind, page.path, page.text.count("\n", 0, mention.offset) + 1)
        for mention in mentions(page.text)
    )
