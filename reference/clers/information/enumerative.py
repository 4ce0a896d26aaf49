"""Enumeration: a word as its number among all words with the same counts."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import factorial

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol
from clers.information.model import cumulative as table_of
from clers.information.model import not_in_alphabet


def rearrangements(counts: Sequence[int]) -> int:
    """How many words have these counts. Clauses: INFO-ENUM-1, INFO-ENUM-5."""
    number = factorial(sum(counts))
    for count in counts:
        number //= factorial(count)
    return number


def width(counts: Sequence[int]) -> int:
    """The number of digits of the enumerative code. Clause: INFO-ENUM-4."""
    return (rearrangements(counts) - 1).bit_length()


def rank(size: int, symbols: Sequence[int]) -> Accepted[int] | Rejected:
    """How many rearrangements of a word over 0 … size-1 come before it.

    Clauses: INFO-ENUM-1, INFO-ENUM-2, INFO-ENUM-3.
    """
    left = [0] * size
    for index, symbol in enumerate(symbols):
        if not 0 <= symbol < size:
            return not_in_alphabet(index, symbol)
        left[symbol] += 1
    words, before = rearrangements(left), 0
    for index, symbol in enumerate(symbols):
        rest = len(symbols) - index
        before += words * sum(left[:symbol]) // rest
        words = words * left[symbol] // rest
        left[symbol] -= 1
    return Accepted(before)


def unrank(counts: Sequence[int], number: int) -> Accepted[tuple[int, ...]] | Rejected:
    """The word of this rank. Clauses: INFO-ENUM-2, INFO-ENUM-4."""
    fault = _bad_counts(counts)
    if fault is not None:
        return fault
    words, left = rearrangements(counts), list(counts)
    if not 0 <= number < words:
        detail = f"there are fewer than {number + 1} words" if number > 0 else "a negative rank"
        return Rejected(Reason.NOT_CANONICAL, Clause.INFO_ENUM_4, detail=detail)
    symbols: list[int] = []
    for rest in range(sum(counts), 0, -1):
        symbol = 0
        while number >= (share := words * left[symbol] // rest):
            number -= share
            symbol += 1
        words = share
        left[symbol] -= 1
        symbols.append(symbol)
    return Accepted(tuple(symbols))


def encode(size: int, symbols: Sequence[int]) -> Accepted[str] | Rejected:
    """The rank in binary digits. Clause: INFO-ENUM-4."""
    found = rank(size, symbols)
    if isinstance(found, Rejected):
        return found
    digits = width([symbols.count(symbol) for symbol in range(size)])
    return Accepted(f"{found.value:0{digits}b}" if digits else "")


def decode(counts: Sequence[int], digits: str) -> Accepted[tuple[int, ...]] | Rejected:
    """The word with these counts that these digits encode. Clause: INFO-ENUM-4."""
    fault = _bad_counts(counts)
    if fault is not None:
        return fault
    for place, digit in enumerate(digits):
        if digit not in ("0", "1"):
            detail = f"{digit!r} is no digit"
            return Rejected(Reason.BAD_NUMBER, Clause.INFO_ENUM_4, AtSymbol(place), detail)
    size = width(counts)
    if len(digits) != size:
        reason = Reason.TRUNCATED_BITS if len(digits) < size else Reason.TRAILING_BITS
        detail = f"{len(digits)} digits, must be {size}"
        return Rejected(reason, Clause.INFO_ENUM_4, detail=detail)
    return unrank(counts, int(digits or "0", 2))


def _bad_counts(counts: Sequence[int]) -> Rejected | None:
    for symbol, count in enumerate(counts):
        if count < 0:
            detail = f"negative count {count}"
            return Rejected(Reason.BAD_TABLE, Clause.INFO_ENUM_4, AtSymbol(symbol), detail)
    return None


@dataclass(frozen=True, slots=True)
class Urn:
    """The symbols still to come, by their counts: none comes back. Clause: INFO-ENUM-6."""

    counts: tuple[int, ...]

    @property
    def cumulative(self) -> Sequence[int]:
        """The counts as frequencies."""
        return table_of(self.counts)

    def after(self, symbol: int) -> "Urn":
        """One less of that symbol."""
        less = self.counts[symbol] - 1
        return Urn((*self.counts[:symbol], less, *self.counts[symbol + 1 :]))
