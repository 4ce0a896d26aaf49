"""Runs: how often each symbol follows at once."""

from collections.abc import Sequence
from itertools import chain, groupby, repeat
from typing import NamedTuple

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol


class Run(NamedTuple):
    """A symbol and how often it comes. Clause: INFO-RUN-1."""

    symbol: int
    length: int


def runs(symbols: Sequence[int]) -> tuple[Run, ...]:
    """The runs of a message. Clause: INFO-RUN-1."""
    return tuple(Run(symbol, sum(1 for _ in run)) for symbol, run in groupby(symbols))


def joined(parts: Sequence[Run], count: int) -> Accepted[tuple[int, ...]] | Rejected:
    """The message of `count` symbols that has these runs. Clause: INFO-RUN-2."""
    last: int | None = None
    for index, (symbol, length) in enumerate(parts):
        if length < 1 or symbol == last:
            detail = f"length {length}" if length < 1 else f"symbol {symbol} as before"
            return Rejected(Reason.NOT_CANONICAL, Clause.INFO_RUN_2, AtSymbol(index), detail)
        last = symbol
    total = sum(length for _, length in parts)
    if total != count:
        detail = f"{total} symbols in runs, {count} declared"
        return Rejected(Reason.COUNT_MISMATCH, Clause.INFO_RUN_2, detail=detail)
    return Accepted(tuple(chain.from_iterable(repeat(*run) for run in parts)))
