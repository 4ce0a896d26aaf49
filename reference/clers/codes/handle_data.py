"""Handle data as bits: sizes learnt on the way, and the digits below them as they are."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from clers.arithmetic import coder
from clers.arithmetic.bits import Bits
from clers.codes.closings import Closing
from clers.conventions.result import Accepted, Rejected
from clers.edgebreaker.stream import Kind, Side
from clers.information.adaptive import Adaptive
from clers.information.combined import CHUNK, joined, pieces, raw
from clers.information.model import MAXIMUM_TOTAL, Model, cumulative, has_ended

KINDS: Final = (Kind.HANDLE, Kind.BOUNDARY)
SIDES: Final = (Side.RIGHT, Side.LEFT)
"""Kinds and sides by their symbols. Clause: CODE-HAND-4."""

PASSED, KIND, SIDE, BETWEEN = range(4)


def sizes(symbols: int) -> int:
    """How many sizes a number from 1 to the number of symbols can have. Clause: CODE-HAND-4."""
    return max(1, symbols.bit_length())


def _fresh(size: int) -> Adaptive:
    """The add-half model. Clause: CODE-HAND-4."""
    return Adaptive(cumulative((1,) * size), 2, MAXIMUM_TOTAL)


@dataclass(frozen=True, slots=True)
class Entries:
    """The model of so many closings. Clause: CODE-HAND-4.

    `fields`: what was learnt of each; `at`: the field that is next; `digits`: what is left of the
    digits of a number, if they are next.
    """

    left: int
    fields: tuple[Adaptive, ...]
    at: int = PASSED
    digits: Model | None = None

    @property
    def cumulative(self) -> Sequence[int]:
        """The table of the next symbol."""
        if self.digits is not None:
            return self.digits.cumulative
        return self.fields[self.at].cumulative if self.left else (0,)

    def after(self, symbol: int) -> "Entries":
        """The digits after a size, or the next field."""
        if self.digits is not None:
            rest = self.digits.after(symbol)
            return self._next() if has_ended(rest) else replace(self, digits=rest)
        here, at = self.fields, self.at
        told = replace(self, fields=(*here[:at], here[at].after(symbol), *here[at + 1 :]))
        if at in (PASSED, BETWEEN) and symbol > 0:
            return replace(told, digits=raw(symbol))
        return told._next()

    def _next(self) -> "Entries":
        left = self.left - (self.at == BETWEEN)
        return Entries(left, self.fields, (self.at + 1) % 4)


def _model(count: int, symbols: int) -> Entries:
    size = sizes(symbols)
    return Entries(count, (_fresh(size), _fresh(2), _fresh(2), _fresh(size)))


def _number(value: int) -> tuple[int, ...]:
    """The size of value + 1 and the digits below its first. Clause: CODE-HAND-4."""
    size = (value + 1).bit_length() - 1
    return (size, *pieces(value + 1 - (1 << size), size)) if size else (0,)


def message(seen: Sequence[Closing], symbols: int) -> tuple[Model, tuple[int, ...]]:
    """What is coded for the closings of a word of so many symbols. Clause: CODE-HAND-4."""
    written: list[int] = []
    for closing in seen:
        written += _number(closing.passed)
        written += (KINDS.index(closing.kind), SIDES.index(closing.side))
        written += _number(closing.between)
    return _model(len(seen), symbols), tuple(written)


def encode(seen: Sequence[Closing], symbols: int) -> Accepted[Bits] | Rejected:
    """The bits of the closings of a word of so many symbols. Clauses: CODE-HAND-4, CODE-HAND-6."""
    return coder.encode(*message(seen, symbols))


def decode(bits: Bits, count: int, symbols: int) -> Accepted[tuple[Closing, ...]] | Rejected:
    """The closings of these bits, and no others. Linear in `count`. Clause: CODE-HAND-5."""
    longest = 4 + 2 * (sizes(symbols) // CHUNK + 1)
    decoded = coder.decode(_model(count, symbols), bits, count * longest)
    if isinstance(decoded, Rejected):
        return decoded
    message = iter(decoded.value)

    def number() -> int:
        size = next(message)
        return (1 << size) + joined([next(message) for _ in range(-(-size // CHUNK))]) - 1

    found: list[Closing] = []
    for _ in range(count):
        passed = number()
        kind, side = KINDS[next(message)], SIDES[next(message)]
        found.append(Closing(passed, kind, side, number()))
    return Accepted(tuple(found))
