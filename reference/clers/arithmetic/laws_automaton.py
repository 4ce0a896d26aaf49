"""Automata are coded by a kernel over flat tables; as models like any other they give the same."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from clers.arithmetic.coder import decode, decode_bytes, encode, read
from clers.arithmetic.given import BY_AUTOMATON, ByAutomaton
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, and_then
from clers.conventions.verdict import Verdict
from clers.information.model import Model


@dataclass(frozen=True, slots=True)
class Unknown:
    """A model of which one knows nothing but its tables. Clause: INFO-MODEL-1."""

    model: Model

    @property
    def cumulative(self) -> Sequence[int]:
        """The table of the next symbol."""
        return self.model.cumulative

    def after(self, symbol: int) -> "Unknown":
        """What follows is not known better."""
        return Unknown(self.model.after(symbol))


def _alike(given: ByAutomaton) -> Verdict:
    known, unknown = given.start, Unknown(given.start)
    count = len(given.symbols)
    message = decode(unknown, given.bits, count)
    in_bytes = and_then(message, lambda symbols: Accepted(bytes(symbols)))
    return every(
        same(encode(unknown, given.symbols), encode(known, given.symbols)),
        same(read(unknown, given.bits, count), read(known, given.bits, count)),
        same(message, decode(known, given.bits, count)),
        same(in_bytes, decode_bytes(known, given.bits, count)),
        same(in_bytes, decode_bytes(unknown, given.bits, count)),
    )


LAWS_OF_AUTOMATA: Final[tuple[AnyLaw, ...]] = (
    Law(
        "coder-automata-are-models",
        Clause.INFO_AUTOMATON_1,
        "an automaton's bits, readings and rejections are those of any model with its tables",
        BY_AUTOMATON,
        _alike,
    ),
)
