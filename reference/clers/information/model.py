"""Probability models: a value that knows the table of the next symbol and the model after it.

A table is its cumulative frequencies 0 = c[0] ≤ c[1] ≤ … ≤ c[k]: symbol s, 0 ≤ s < k, has the
frequency c[s+1] - c[s] out of the total c[k]. Coders need nothing else of a model, so that an
alphabet of 2^16 equal symbols is `range(2**16 + 1)`, and costs no memory.
"""

from collections.abc import Iterable, Sequence
from itertools import accumulate, pairwise
from typing import Final, NamedTuple, Protocol

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol

MAXIMUM_TOTAL: Final = 1 << 30
"""The largest total of a table. Clause: INFO-MODEL-2."""


class Model(Protocol):
    """What is expected of the next symbol, and of those after it. Clauses: INFO-MODEL-1, -3, -4."""

    @property
    def cumulative(self) -> Sequence[int]:
        """The cumulative frequencies of the next symbol: k + 1 integers for k symbols."""
        ...

    def after(self, symbol: int) -> "Model":
        """The model of what follows `symbol`, which must have a positive frequency. Pure."""
        ...


class Slot(NamedTuple):
    """The part of a table that belongs to one symbol: `below` up to `upto` out of `total`."""

    below: int
    upto: int
    total: int

    @property
    def frequency(self) -> int:
        """How much of the total the symbol has."""
        return self.upto - self.below


def cumulative(frequencies: Iterable[int]) -> tuple[int, ...]:
    """The table that has these frequencies. Clause: INFO-MODEL-1."""
    return tuple(accumulate(frequencies, initial=0))


def differences(table: Iterable[int]) -> tuple[int, ...]:
    """The frequencies that a table has: `cumulative` undone. Clause: INFO-MODEL-1."""
    return tuple(upto - below for below, upto in pairwise(table))


def has_ended(model: Model) -> bool:
    """No symbol can follow: the message is over. Clause: INFO-MODEL-3."""
    return model.cumulative[-1] == 0


def slots(model: Model, symbols: Sequence[int]) -> Accepted[tuple[Slot, ...]] | Rejected:
    """The slot of each symbol of a message, or what is wrong with the first that has none.

    Clauses: INFO-MODEL-4, INFO-MODEL-5, INFO-MODEL-6.
    """
    found: list[Slot] = []
    for index, symbol in enumerate(symbols):
        table = model.cumulative
        if table[-1] > MAXIMUM_TOTAL:
            return over_maximum(index, table[-1])
        if not 0 <= symbol < len(table) - 1 or table[symbol] == table[symbol + 1]:
            return not_in_alphabet(index, symbol)
        found.append(Slot(table[symbol], table[symbol + 1], table[-1]))
        model = model.after(symbol)
    return Accepted(tuple(found))


def over_maximum(index: int, total: int) -> Rejected:
    """The table that symbol `index` meets is too large. Clause: INFO-MODEL-6."""
    detail = f"total {total} is over {MAXIMUM_TOTAL}"
    return Rejected(Reason.BAD_TABLE, Clause.INFO_MODEL_6, AtSymbol(index), detail)


def not_in_alphabet(index: int, symbol: int) -> Rejected:
    """The model does not allow symbol `index` to be this one. Clause: INFO-MODEL-5."""
    detail = f"symbol {symbol} has no frequency here"
    return Rejected(Reason.NOT_IN_ALPHABET, Clause.INFO_MODEL_5, AtSymbol(index), detail)
