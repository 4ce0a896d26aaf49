"""Laws of prefix codes: Kraft's inequality both ways, canonical codes, unique decodability."""

from fractions import Fraction
from functools import cache
from itertools import pairwise, product
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE, AtSymbol
from clers.information import canonical, prefix, unique
from clers.information.given_codes import (
    ANY_LENGTHS,
    ANY_WORDS,
    CODED,
    Coded,
    LengthsRequest,
    Words,
)


def begin_alike(one: str, other: str) -> bool:
    """One of two words is the beginning of the other."""
    return one[: len(other)] == other[: len(one)]


def _first_bad_word(words: tuple[str | None, ...]) -> int | None:
    """The symbol to blame. INFO-PREFIX-1, word for word."""
    for symbol, word in enumerate(words):
        if word is not None and any(digit not in "01" for digit in word):
            return symbol
    for symbol, word in enumerate(words):
        earlier = [other for other in words[:symbol] if other is not None]
        if word is not None and any(begin_alike(word, other) for other in earlier):
            return symbol
    return None


def _bad_words_are_rejected(given: Words) -> Verdict:
    """Clause: INFO-PREFIX-1."""
    got, first = prefix.prefix_code(given.words), _first_bad_word(given.words)
    if first is None:
        return same(Accepted(prefix.PrefixCode(given.words)), got)
    if isinstance(got, Accepted):
        return Fails("rejected", repr(got), AtSymbol(first))
    return same((Reason.BAD_TABLE, AtSymbol(first)), (got.reason, got.where))


def _words_decode(given: Coded) -> Verdict:
    """Clauses: INFO-PREFIX-2, INFO-PREFIX-4."""
    digits = "".join(given.code.words[symbol] or "" for symbol in given.symbols)
    return every(
        same(Accepted(digits), prefix.encode(given.code, given.symbols)),
        same(
            Accepted(given.symbols),
            prefix.decode(given.code, digits, len(given.symbols)),
        ),
    )


def _reading_is_strict(given: Coded) -> Verdict:
    """Clause: INFO-PREFIX-3: read by trying each word, and the first fault is named."""
    words = [(word, symbol) for symbol, word in enumerate(given.code.words) if word is not None]
    rest, symbols = given.digits, list[int]()
    got = prefix.decode(given.code, given.digits, len(given.symbols))
    for index in range(len(given.symbols)):
        found = [(word, symbol) for word, symbol in words if rest.startswith(word)]
        if found:
            rest = rest[len(found[0][0]) :]
            symbols.append(found[0][1])
            continue
        if isinstance(got, Accepted):
            return Fails("rejected", repr(got), AtSymbol(index))
        # The digits up to the first that leaves every word behind.
        met = next(
            (
                rest[:n]
                for n in range(len(rest) + 1)
                if not any(w.startswith(rest[:n]) for w, _ in words)
            ),
            "",
        )
        if met == "":
            reason = Reason.TRUNCATED_BITS
        else:
            reason = Reason.NOT_CANONICAL if met[-1] in "01" else Reason.BAD_NUMBER
        return same((reason, AtSymbol(index)), (got.reason, got.where))
    if rest == "":
        return same(Accepted(tuple(symbols)), got)
    if isinstance(got, Accepted):
        return Fails("trailing bits", repr(got), WHOLE)
    return same((Reason.TRAILING_BITS, WHOLE), (got.reason, got.where))


def _codes_satisfy_kraft(given: Coded) -> Verdict:
    """Clause: INFO-KRAFT-1."""
    lengths = [len(word) for word in given.code.words if word is not None]
    total = sum((Fraction(1, 2**length) for length in lengths), Fraction(0))
    return every(same(total, prefix.kraft(given.code.lengths)), same(True, total <= 1))


def _lengths_have_a_code(given: LengthsRequest) -> Verdict:
    """Clauses: INFO-KRAFT-2, INFO-KRAFT-3."""
    bad = [s for s, n in enumerate(given.lengths) if n is not None and not 0 <= n <= 64]
    got = canonical.canonical(given.lengths)
    if bad or prefix.kraft(given.lengths) > 1:
        where = AtSymbol(bad[0]) if bad else WHOLE
        if isinstance(got, Accepted):
            return Fails("rejected", repr(got), where)
        return same((Reason.BAD_TABLE, where), (got.reason, got.where))
    if isinstance(got, Rejected):
        return Fails("a code", got.line(), WHOLE)
    words = got.value.words
    taken = sorted((len(w), s, w) for s, w in enumerate(words) if w is not None)
    rising = all(begin_alike(a, b) is False and a < b for (*_, a), (*_, b) in pairwise(taken))
    return every(
        same(given.lengths, got.value.lengths),
        same(Accepted(got.value), prefix.prefix_code(words)),
        same(True, rising),
        same(canonical.by_sums(given.lengths), got),
    )


def _complete_codes_read_everything(given: Coded) -> Verdict:
    """Clause: INFO-KRAFT-4: over all strings of as many digits as the longest word has."""
    words = [word for word in given.code.words if word is not None]
    longest = max((len(word) for word in words), default=0)
    if longest > 9:
        return Holds()  # too many strings
    strings = ("".join(digits) for digits in product("01", repeat=longest))
    readable = all(any(text.startswith(word) for word in words) for text in strings)
    return same(readable, prefix.kraft(given.code.lengths) == 1)


@cache
def _messages(symbols: int, most: int) -> tuple[tuple[int, ...], ...]:
    """All messages of at most so many symbols."""
    return tuple(m for n in range(most + 1) for m in product(range(symbols), repeat=n))


def _ambiguities_are_found(given: Words) -> Verdict:
    """Clauses: INFO-UNIQUE-1, INFO-KRAFT-1: a witness, or no clash among all short messages."""
    words = [word for word in given.words if word is not None]
    found = unique.ambiguity(words)
    if found is not None:
        one, other = ("".join(words[s] for s in message) for message in found)
        return same((True, one), (found[0] != found[1], other))
    codes = [
        "".join(words[s] for s in m) for m in _messages(len(words), 5 if len(words) < 5 else 3)
    ]
    total = sum((Fraction(1, 2 ** len(word)) for word in words), Fraction(0))
    return same((len(codes), True), (len(set(codes)), total <= 1 or not _binary(words)))


def _binary(words: list[str]) -> bool:
    return all(digit in "01" for word in words for digit in word)


LAWS_OF_CODES: Final[tuple[AnyLaw, ...]] = (
    Law(
        "bad-words-are-rejected",
        Clause.INFO_PREFIX_1,
        "words are a prefix code exactly if they are digits and none begins another",
        ANY_WORDS,
        _bad_words_are_rejected,
    ),
    Law(
        "prefix-words-decode",
        Clause.INFO_PREFIX_2,
        "the words of a message, put together, decode to the message",
        CODED,
        _words_decode,
    ),
    Law(
        "prefix-reading-is-strict",
        Clause.INFO_PREFIX_3,
        "any digits are read as words one by one, or the first place is named where none is",
        CODED,
        _reading_is_strict,
    ),
    Law(
        "prefix-codes-satisfy-kraft",
        Clause.INFO_KRAFT_1,
        "the sum of 2^-length over the words of a prefix code is 1 at most",
        CODED,
        _codes_satisfy_kraft,
    ),
    Law(
        "kraft-lengths-have-a-canonical-code",
        Clause.INFO_KRAFT_3,
        "lengths have a code exactly if Kraft's sum allows; its words are sums before, in order",
        ANY_LENGTHS,
        _lengths_have_a_code,
    ),
    Law(
        "complete-codes-read-everything",
        Clause.INFO_KRAFT_4,
        "each string as long as the longest word begins with a word exactly if the sum is 1",
        CODED,
        _complete_codes_read_everything,
    ),
    Law(
        "ambiguities-are-found",
        Clause.INFO_UNIQUE_1,
        "words have a witness of ambiguity, or no two short messages agree and Kraft's sum fits",
        ANY_WORDS,
        _ambiguities_are_found,
    ),
)
