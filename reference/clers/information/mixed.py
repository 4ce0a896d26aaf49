"""Mixing: several models at once, each weighed by how well it has foretold so far."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import prod
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol
from clers.information.measure import probability
from clers.information.model import MAXIMUM_TOTAL, Model, cumulative, has_ended
from clers.information.static import END

UNIT: Final = 1 << 16
"""A unit that costs little: see INFO-MIX-4."""


@dataclass(frozen=True, slots=True)
class Mixed:
    """Models that have not ended, at least one, with their weights. Clause: INFO-MIX-2.

    From outside input build it with `mixed`.
    """

    parts: tuple[Model, ...]
    weights: tuple[int, ...]
    unit: int

    @property
    def cumulative(self) -> Sequence[int]:
        """The weighted mean of the tables, in units, rounded up. Clause: INFO-MIX-2."""
        tables = [part.cumulative for part in self.parts]
        common = prod(table[-1] for table in tables)
        scales = [w * (common // table[-1]) for w, table in zip(self.weights, tables, strict=True)]
        whole = sum(self.weights) * common
        size = max(len(table) for table in tables) - 1
        means = [0] * size
        for table, scale in zip(tables, scales, strict=True):
            for symbol in range(len(table) - 1):
                means[symbol] += scale * (table[symbol + 1] - table[symbol])
        return cumulative(self.unit * mean // whole + 1 if mean else 0 for mean in means)

    def after(self, symbol: int) -> Model:
        """Weights by how probable the symbol was to each part. Clause: INFO-MIX-3."""
        chances = [_chance(part.cumulative, symbol) for part in self.parts]
        common = prod(total for _, total in chances)
        shares = [
            w * f * (common // total) for w, (f, total) in zip(self.weights, chances, strict=True)
        ]
        whole = sum(shares)
        pairs = [
            (part.after(symbol), self.unit * share // whole + 1)
            for part, share in zip(self.parts, shares, strict=True)
            if share > 0
        ]
        return _of_open(pairs, self.unit)


def _chance(table: Sequence[int], symbol: int) -> tuple[int, int]:
    """Frequency and total; none of 1 beyond the end of the table."""
    if symbol < len(table) - 1:
        return table[symbol + 1] - table[symbol], table[-1]
    return 0, 1


def _of_open(pairs: Sequence[tuple[Model, int]], unit: int) -> Model:
    """The parts that have not ended, mixed; the end if all have. Clause: INFO-MIX-3."""
    kept = [(part, weight) for part, weight in pairs if not has_ended(part)]
    if not kept:
        return END
    return Mixed(tuple(part for part, _ in kept), tuple(weight for _, weight in kept), unit)


def mixed(
    parts: Sequence[Model], weights: Sequence[int], unit: int = UNIT
) -> Accepted[Model] | Rejected:
    """These models mixed, with these weights in the beginning. Clauses: INFO-MIX-2 … INFO-MIX-5."""
    for index, weight in enumerate(weights):
        if weight < 1:
            detail = f"weight {weight}"
            return Rejected(Reason.BAD_TABLE, Clause.INFO_MIX_5, AtSymbol(index), detail)
    good = len(parts) == len(weights) >= 1 and sum(weights) <= MAXIMUM_TOTAL
    if not good or not 1 <= unit <= MAXIMUM_TOTAL // 2:
        detail = f"{len(parts)} parts, {len(weights)} weights of sum {sum(weights)}, unit {unit}"
        return Rejected(Reason.BAD_TABLE, Clause.INFO_MIX_5, detail=detail)
    return Accepted(_of_open(list(zip(parts, weights, strict=True)), unit))


def mixture(parts: Sequence[Model], weights: Sequence[int], symbols: Sequence[int]) -> Fraction:
    """The probability of a message under the exact mixture: the definition. Clause: INFO-MIX-1."""
    chances = (probability(part, symbols) for part in parts)
    shares = (
        weight * found.value
        for weight, found in zip(weights, chances, strict=True)
        if isinstance(found, Accepted)
    )
    return sum(shares, Fraction(0)) / sum(weights)
