"""Static models: the same table for every symbol."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol
from clers.information.model import MAXIMUM_TOTAL, cumulative


@dataclass(frozen=True, slots=True)
class Static:
    """One table for ever. Clause: INFO-STATIC-1.

    From outside input build it with `static` or `uniform`, which check; for a table that is
    written in the source, `Static(cumulative((3, 1, 4)))` will do.
    """

    cumulative: Sequence[int]

    def after(self, symbol: int) -> "Static":
        """Itself."""
        del symbol
        return self


END: Final = Static((0,))
"""The model of the empty message: no symbol, total 0. Clause: INFO-MODEL-3."""


def static(frequencies: Sequence[int]) -> Accepted[Static] | Rejected:
    """A static model of these frequencies. Clauses: INFO-STATIC-1, INFO-STATIC-3."""
    fault = bad_frequencies(frequencies)
    return fault if fault is not None else Accepted(Static(cumulative(frequencies)))


def uniform(size: int) -> Accepted[Static] | Rejected:
    """Symbols 0 … size-1, all alike. Clauses: INFO-STATIC-2, INFO-STATIC-3."""
    if 1 <= size <= MAXIMUM_TOTAL:
        return Accepted(Static(range(size + 1)))
    detail = f"{size} symbols, must be 1 to {MAXIMUM_TOTAL}"
    return Rejected(Reason.BAD_TABLE, Clause.INFO_STATIC_3, detail=detail)


def bad_frequencies(frequencies: Sequence[int]) -> Rejected | None:
    """What is wrong with a table, if anything is. Clause: INFO-STATIC-3."""
    for symbol, frequency in enumerate(frequencies):
        if frequency < 0:
            detail = f"negative frequency {frequency}"
            return Rejected(Reason.BAD_TABLE, Clause.INFO_STATIC_3, AtSymbol(symbol), detail)
    total = sum(frequencies)
    if not 1 <= total <= MAXIMUM_TOTAL:
        detail = f"total {total}, must be 1 to {MAXIMUM_TOTAL}"
        return Rejected(Reason.BAD_TABLE, Clause.INFO_STATIC_3, detail=detail)
    return None
