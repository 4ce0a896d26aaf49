"""Context automata: finitely many contexts, a fixed table in each, a fixed step to the next.

The states are made once and know each other, so that `after` is two look-ups and no allocation.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol
from clers.information.model import cumulative
from clers.information.static import bad_frequencies


@dataclass(frozen=True, slots=True)
class Automaton:
    """What an automaton is made of: nothing is checked yet. Clause: INFO-AUTOMATON-1.

    `frequencies[q][s]` is the frequency of symbol s in context q, 0 where s is not allowed there;
    `successors[q][s]` is the context after it (not looked at where s is not allowed).
    """

    frequencies: tuple[tuple[int, ...], ...]
    successors: tuple[tuple[int, ...], ...]


@dataclass(frozen=True, slots=True)
class Context:
    """An automaton in one of its contexts: a model. Clause: INFO-AUTOMATON-1."""

    automaton: Automaton
    number: int
    cumulative: tuple[int, ...] = field(compare=False, repr=False)
    successors: tuple[int, ...] = field(compare=False, repr=False)
    contexts: Sequence["Context"] = field(compare=False, repr=False)

    def after(self, symbol: int) -> "Context":
        """The context that the symbol leads to."""
        return self.contexts[self.successors[symbol]]


def contexts(automaton: Automaton) -> tuple[Context, ...]:
    """All contexts of an automaton that is known to be good, by number; for tables in the source.

    Clause: INFO-AUTOMATON-1.
    """
    made: list[Context] = []
    rows = zip(automaton.frequencies, automaton.successors, strict=True)
    for number, (row, successors) in enumerate(rows):
        # Each context holds the one list that will hold them all; nobody else ever changes it.
        made.append(Context(automaton, number, cumulative(row), successors, made))
    return tuple(made)


def start(automaton: Automaton, number: int = 0) -> Accepted[Context] | Rejected:
    """The automaton in context `number`, if its tables are good. Clause: INFO-AUTOMATON-2."""
    fault = _bad_automaton(automaton, number)
    return fault if fault is not None else Accepted(contexts(automaton)[number])


def _bad_automaton(automaton: Automaton, number: int) -> Rejected | None:
    """What is wrong with an automaton, if anything is. Clause: INFO-AUTOMATON-2."""
    size = len(automaton.frequencies)
    if len(automaton.successors) != size or not 0 <= number < size:
        detail = f"{size} tables, {len(automaton.successors)} rows of successors, start {number}"
        return Rejected(Reason.BAD_TABLE, Clause.INFO_AUTOMATON_2, detail=detail)
    for row, successors in zip(automaton.frequencies, automaton.successors, strict=True):
        fault = bad_frequencies(row)
        if fault is not None:
            return fault
        if len(successors) != len(row):
            detail = f"{len(row)} symbols, {len(successors)} successors"
            return Rejected(Reason.BAD_TABLE, Clause.INFO_AUTOMATON_2, detail=detail)
        for symbol, successor in enumerate(successors):
            if row[symbol] > 0 and not 0 <= successor < size:
                detail = f"successor {successor} of {size} contexts"
                return Rejected(Reason.BAD_TABLE, Clause.INFO_AUTOMATON_2, AtSymbol(symbol), detail)
    return None
