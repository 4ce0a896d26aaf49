"""Prefix codes: a word of binary digits for each symbol, none the beginning of another."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol
from clers.information.model import not_in_alphabet

Lengths = tuple[int | None, ...]
"""The length of each symbol's word; None for a symbol that has no word."""


@dataclass(frozen=True, slots=True)
class PrefixCode:
    """The word of each symbol as a string of "0" and "1"; None where it has none.

    Clause: INFO-PREFIX-1. From outside input build it with `prefix_code`.
    """

    words: tuple[str | None, ...]

    @property
    def lengths(self) -> Lengths:
        """The length of each word."""
        return tuple(None if word is None else len(word) for word in self.words)


def prefix_code(words: Sequence[str | None]) -> Accepted[PrefixCode] | Rejected:
    """These words as a code, if none begins another. Clause: INFO-PREFIX-1."""
    for symbol, word in enumerate(words):
        if word is not None and not set(word) <= {"0", "1"}:
            return _bad_word(symbol, f"{word!r} is not made of 0 and 1")
    whole: set[str] = set()
    begun: set[str] = set()
    for symbol, word in enumerate(words):
        if word is None:
            continue
        beginnings = {word[:end] for end in range(len(word) + 1)}
        if word in begun or beginnings & whole:
            return _bad_word(symbol, f"{word!r} and an earlier word begin alike")
        whole.add(word)
        begun |= beginnings
    return Accepted(PrefixCode(tuple(words)))


def _bad_word(symbol: int, detail: str) -> Rejected:
    return Rejected(Reason.BAD_TABLE, Clause.INFO_PREFIX_1, AtSymbol(symbol), detail)


def kraft(lengths: Sequence[int | None]) -> Fraction:
    """The sum of 2^-length over the symbols that have one.

    Clauses: INFO-KRAFT-1, INFO-KRAFT-4.
    """
    known = [length for length in lengths if length is not None]
    longest = max(known, default=0)
    return Fraction(sum(1 << longest - length for length in known), 1 << longest)


def encode(code: PrefixCode, symbols: Sequence[int]) -> Accepted[str] | Rejected:
    """The words of a message, one after another. Clauses: INFO-PREFIX-2, INFO-PREFIX-4."""
    out: list[str] = []
    for index, symbol in enumerate(symbols):
        word = code.words[symbol] if 0 <= symbol < len(code.words) else None
        if word is None:
            return not_in_alphabet(index, symbol)
        out.append(word)
    return Accepted("".join(out))


def decode(code: PrefixCode, digits: str, count: int) -> Accepted[tuple[int, ...]] | Rejected:
    """The `count` symbols that these digits, and no others, encode.

    Linear in digits and symbols. Clauses: INFO-PREFIX-2, INFO-PREFIX-3, INFO-PREFIX-4.
    """
    symbol_of = {word: symbol for symbol, word in enumerate(code.words) if word is not None}
    if "" in symbol_of:  # the only word
        return _all_read(digits, 0, (symbol_of[""],) * max(count, 0))
    beginnings = {word[:end] for word in symbol_of for end in range(1, len(word))}
    symbols: list[int] = []
    at = 0
    for index in range(count):
        end = at + 1
        while digits[at:end] in beginnings and end < len(digits):
            end += 1
        word = digits[at:end]
        if word not in symbol_of:
            return _no_word(index, word, beginnings)
        symbols.append(symbol_of[word])
        at = end
    return _all_read(digits, at, tuple(symbols))


def _no_word(index: int, word: str, beginnings: set[str]) -> Rejected:
    """What is wrong where symbol `index` should be. Clause: INFO-PREFIX-3."""
    where, clause = AtSymbol(index), Clause.INFO_PREFIX_3
    if word[-1:] not in ("", "0", "1"):
        return Rejected(Reason.BAD_NUMBER, clause, where, f"{word[-1]!r} is no digit")
    if word == "" or word in beginnings:
        return Rejected(Reason.TRUNCATED_BITS, clause, where, "the digits end within a word")
    return Rejected(Reason.NOT_CANONICAL, clause, where, f"no word begins with {word}")


def _all_read(
    digits: str, at: int, symbols: tuple[int, ...]
) -> Accepted[tuple[int, ...]] | Rejected:
    """The symbols, if the digits end where they do. Clause: INFO-PREFIX-3."""
    if at == len(digits):
        return Accepted(symbols)
    detail = f"{len(digits) - at} digits follow the last word"
    return Rejected(Reason.TRAILING_BITS, Clause.INFO_PREFIX_3, detail=detail)
