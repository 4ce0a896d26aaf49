"""Adaptive codes: each symbol by the k before it, with frequencies that are counted on the way."""

from typing import Final

from clers.arithmetic import coder
from clers.arithmetic.bits import Bits
from clers.codes.code import NOTHING, Code
from clers.codes.implied import NUMBER, letters, numbers
from clers.conventions.clause import Clause
from clers.conventions.result import Accepted, Rejected, and_then
from clers.information.adaptive import Adaptive
from clers.information.model import Model, cumulative

INCREMENT: Final = 2
"""What a symbol adds; each begins with 1, that is with half a count. Clause: CODE-ADAPTIVE-1."""

LIMIT: Final = 4096
"""The total over which all are halved. Clause: CODE-ADAPTIVE-1."""

ELSEWHERE: Final = Adaptive(cumulative((1, 1, 1, 1, 1)), INCREMENT, LIMIT)
AFTER_C: Final = Adaptive(cumulative((1, 0, 0, 1, 1)), INCREMENT, LIMIT)
"""What is expected first; L and E never follow a C. Clause: CODE-ADAPTIVE-1."""


def fresh(context: tuple[int, ...]) -> Adaptive:
    """The model of a context that did not occur yet. Clause: CODE-ADAPTIVE-1."""
    return AFTER_C if context[-1:] == (NUMBER["C"],) else ELSEWHERE


class _Once:
    """The model of order k as a thing that is used up: each `after` spoils the one before.

    A coder asks a model only forwards, so that the contexts may share one dictionary. The law
    `adaptive-definition` compares with the models of chapter 1.
    """

    __slots__ = ("context", "here", "learnt", "order")

    def __init__(self, order: int, head: tuple[int, ...]) -> None:
        self.order = order
        self.learnt: dict[tuple[int, ...], Adaptive] = {}
        self.context = head
        self.here = fresh(head)

    @property
    def cumulative(self) -> tuple[int, ...]:
        """The table of the context."""
        return self.here.cumulative

    def after(self, symbol: int) -> Model:
        """Itself, one symbol later."""
        self.learnt[self.context] = self.here.after(symbol)
        self.context = (*self.context, symbol)[-self.order :]
        found = self.learnt.get(self.context)
        self.here = fresh(self.context) if found is None else found
        return self


def encode(order: int, symbols: str, head: str) -> Accepted[Bits] | Rejected:
    """The bits of the symbols after `head`. Linear. Clauses: CODE-ADAPTIVE-1, CODE-ADAPTIVE-2."""
    model = _Once(order, tuple(NUMBER[x] for x in head))
    found = numbers(symbols, Clause.CODE_ADAPTIVE_1)
    return and_then(found, lambda coded: coder.encode(model, coded))


def decode(order: int, bits: Bits, count: int, head: str) -> Accepted[str] | Rejected:
    """The `count` symbols after `head`. Linear. Clauses: CODE-ADAPTIVE-1, CODE-ADAPTIVE-2."""
    found = coder.decode(_Once(order, tuple(NUMBER[x] for x in head)), bits, count)
    return and_then(found, lambda coded: Accepted(letters(coded)))


def most_symbols(bits: int) -> int:
    """No symbol has more than LIMIT - 2 of LIMIT, so it costs 1/1420 bit. Clause: CODE-NAME-3."""
    return 1420 * bits + 2


def code(order: int) -> Code:
    """The adaptive code of this order, from 1 on. Clause: CODE-ADAPTIVE-1."""
    return Code(
        lambda symbols, shape: encode(order, symbols, shape.head),
        lambda bits, count, shape: decode(order, bits, count, shape.head),
        most_symbols,
        NOTHING,
    )
