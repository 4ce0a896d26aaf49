"""Models that are automata, as the flat tables with which they are coded fastest."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

from librt.vecs import vec
from mypy_extensions import i64

from clers.information.automaton import Automaton, Context
from clers.information.model import MAXIMUM_TOTAL, Model, cumulative
from clers.kernels.automaton import Tables


@dataclass(frozen=True, slots=True)
class Started:
    """The tables of an automaton, and the context that it is in."""

    tables: Tables
    context: int


def tables_of(model: Model) -> Started | None:
    """The tables of a model that is an automaton of this kind: see `_tables`."""
    if not isinstance(model, Context):
        return None
    tables = _tables(model.automaton)
    return None if tables is None else Started(tables, model.number)


@cache
def _tables(automaton: Automaton) -> Tables | None:
    """All tables, if they are of one size, no larger than a byte, and each has a good total."""
    size = len(automaton.frequencies[0])
    rows = [cumulative(row) for row in automaton.frequencies]
    if size > 256 or any(len(row) != size + 1 or not 0 < row[-1] <= MAXIMUM_TOTAL for row in rows):
        return None
    after = [to for row in automaton.successors for to in (*row, 0)]
    return Tables(size, vec[i64](x for row in rows for x in row), vec[i64](after))


def as_bytes(symbols: Sequence[int]) -> bytes | None:
    """The symbols in a byte each, if they fit."""
    try:
        return bytes(symbols)
    except ValueError:
        return None
