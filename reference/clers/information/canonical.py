"""The canonical prefix code of given lengths: what RFC 1951, section 3.2.2 builds from them."""

from collections.abc import Sequence
from fractions import Fraction
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol
from clers.information.prefix import PrefixCode, kraft

LONGEST: Final = 64
"""The greatest length of a word of a canonical code. Clause: INFO-KRAFT-2."""


def canonical(lengths: Sequence[int | None]) -> Accepted[PrefixCode] | Rejected:
    """The canonical code of these lengths. Clauses: INFO-KRAFT-2, INFO-KRAFT-3."""
    fault = _bad_lengths(lengths)
    if fault is not None:
        return fault
    words: list[str | None] = [None] * len(lengths)
    number, size = 0, 0
    for length, symbol in _in_order(lengths):
        number <<= length - size
        size = length
        words[symbol] = f"{number:0{length}b}" if length else ""
        number += 1
    return Accepted(PrefixCode(tuple(words)))


def by_sums(lengths: Sequence[int | None]) -> Accepted[PrefixCode] | Rejected:
    """The same code, each word as the digits of a sum of fractions: the definition.

    Clauses: INFO-KRAFT-2, INFO-KRAFT-3.
    """
    fault = _bad_lengths(lengths)
    if fault is not None:
        return fault
    words: dict[int, str] = {}
    before = Fraction(0)
    for length, symbol in _in_order(lengths):
        digits = [int(before * 2**place) % 2 for place in range(1, length + 1)]
        words[symbol] = "".join(map(str, digits))
        before += Fraction(1, 2**length)
    return Accepted(PrefixCode(tuple(words.get(symbol) for symbol in range(len(lengths)))))


def _in_order(lengths: Sequence[int | None]) -> list[tuple[int, int]]:
    """Length and symbol, by length and then by symbol."""
    return sorted((length, symbol) for symbol, length in enumerate(lengths) if length is not None)


def _bad_lengths(lengths: Sequence[int | None]) -> Rejected | None:
    """What is wrong with lengths, if anything is. Clause: INFO-KRAFT-2."""
    for symbol, length in enumerate(lengths):
        if length is not None and not 0 <= length <= LONGEST:
            detail = f"length {length}, must be 0 to {LONGEST}"
            return Rejected(Reason.BAD_TABLE, Clause.INFO_KRAFT_2, AtSymbol(symbol), detail)
    total = kraft(lengths)
    if total > 1:
        return Rejected(Reason.BAD_TABLE, Clause.INFO_KRAFT_2, detail=f"Kraft's sum is {total}")
    return None
