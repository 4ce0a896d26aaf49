"""What a check finds wrong: the places that disagree, none preferred. Clause: CONV-CLAUSE-3."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from clers.specification.repository import Repository


@dataclass(frozen=True, slots=True)
class Finding:
    """A fault: the rule that is broken, where, which clause it is about (or none), in words."""

    rule: str
    path: str
    line: int
    clause: str
    text: str

    @property
    def sentence(self) -> str:
        """One line, as compilers print them."""
        about = f"{self.clause}: " if self.clause else ""
        return f"{self.path}:{self.line}: {about}{self.text} [{self.rule}]"


Rule = Callable[[Repository], Iterator[Finding]]
