"""Adaptive models: each coded symbol raises its own frequency (tutorial, section 3(c))."""

from collections.abc import Sequence
from dataclasses import dataclass

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.information.model import MAXIMUM_TOTAL, cumulative, differences
from clers.information.static import bad_frequencies


@dataclass(frozen=True, slots=True)
class Adaptive:
    """The table so far, what a symbol adds, and the total that must not be passed.

    Clauses: INFO-ADAPT-1, INFO-ADAPT-2, INFO-LEARN-4. From outside input build it with `adaptive`.
    """

    cumulative: tuple[int, ...]
    increment: int
    limit: int

    def after(self, symbol: int) -> "Adaptive":
        """The symbol's frequency raised; all halved if the total passed the limit."""
        table, step = self.cumulative, self.increment
        raised = table[: symbol + 1] + tuple([c + step for c in table[symbol + 1 :]])
        if raised[-1] > self.limit:
            raised = _halved(raised)
        return Adaptive(raised, step, self.limit)


def adaptive(
    frequencies: Sequence[int], increment: int, limit: int
) -> Accepted[Adaptive] | Rejected:
    """An adaptive model that starts with these frequencies. Clause: INFO-ADAPT-3."""
    fault = bad_frequencies(frequencies)
    if fault is not None:
        return fault
    enough = max(sum(frequencies), increment + len(frequencies))
    if increment < 1 or not enough <= limit <= MAXIMUM_TOTAL:
        detail = f"increment {increment}, limit {limit}, must be {enough} to {MAXIMUM_TOTAL}"
        return Rejected(Reason.BAD_TABLE, Clause.INFO_ADAPT_3, detail=detail)
    return Accepted(Adaptive(cumulative(frequencies), increment, limit))


def _halved(table: tuple[int, ...]) -> tuple[int, ...]:
    """Every frequency f becomes f - ⌊f/2⌋, so that none vanishes. Clause: INFO-ADAPT-2."""
    return cumulative(f - f // 2 for f in differences(table))


def recount(start: Adaptive, history: Sequence[int]) -> tuple[int, ...]:
    """The frequencies after a history, counted and not updated: the definition of `after`.

    Clauses: INFO-ADAPT-1, INFO-ADAPT-2. Quadratic; for laws.
    """
    base = list(differences(start.cumulative))
    since = 0
    for upto in range(1, len(history) + 1):
        counted = _counted(base, start.increment, history[since:upto])
        if sum(counted) > start.limit:
            base, since = [(f + 1) // 2 for f in counted], upto
    return tuple(_counted(base, start.increment, history[since:]))


def _counted(base: list[int], increment: int, history: Sequence[int]) -> list[int]:
    """What each symbol had, and the increment for each time it came."""
    return [f + increment * history.count(s) for s, f in enumerate(base)]
