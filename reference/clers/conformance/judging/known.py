"""What the reference knows of a request, worked out only where an answer diverges."""

from collections.abc import Sequence
from dataclasses import dataclass

from clers.conformance.cases.case import Case
from clers.conformance.judging.groups import Group, groups_of
from clers.conformance.judging.steps import walk_of
from clers.conformance.messages import Operation, Step


@dataclass(frozen=True, slots=True)
class Known:
    """A case and its request. Clauses: ORCL-DIVERGE-1, ORCL-DIVERGE-2, ORCL-DIVERGE-3."""

    case: Case
    request: Operation

    def walk(self) -> Sequence[Step]:
        """The walk on the way to the right answer."""
        return walk_of(self.case, self.request)

    def groups(self) -> Sequence[Group]:
        """Which of the right bits belong to which symbol."""
        return groups_of(self.request)
