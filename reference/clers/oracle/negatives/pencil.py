"""Bits as the specification defines them, computed the long way: no coder of ours is asked.

The codes here are those that a patient person could write: tables and long numbers, no automata.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Final

from clers.edgebreaker.stream import SYMBOLS

Slot = tuple[int, int, int]
"""The part of a table that a symbol has: from, up to, out of. Clause: ARITH-EXACT-1."""

QUARTER: Final = 1 << 30


def long_addition(slots: Iterable[Slot]) -> str:
    """The bits of a message by the definition without pending bits. Clause: ARITH-CARRY-1."""
    low, high, base, shifts = 0, 4 * QUARTER - 1, 0, 0
    for below, upto, total in slots:
        width = high - low + 1
        low, high = low + width * below // total, low + width * upto // total - 1
        while True:
            if high < 2 * QUARTER:
                away = 0
            elif low >= 2 * QUARTER:
                away = 2 * QUARTER
            elif low >= QUARTER and high < 3 * QUARTER:
                away = QUARTER
            else:
                break
            low, high = 2 * (low - away), 2 * (high - away) + 1
            base, shifts = 2 * (base + away), shifts + 1
    end = (base + (QUARTER if low < QUARTER else 2 * QUARTER)) // QUARTER
    return f"{end:0{shifts + 2}b}"


class Counts:
    """Frequencies that grow with each symbol. Clauses: INFO-ADAPT-1, INFO-ADAPT-2."""

    def __init__(self, frequencies: Sequence[int], increment: int, limit: int) -> None:
        self.frequencies = list(frequencies)
        self.increment = increment
        self.limit = limit

    def slot(self, symbol: int) -> Slot:
        """The slot of a symbol, which is then known to have come."""
        table = self.frequencies
        found = sum(table[:symbol]), sum(table[: symbol + 1]), sum(table)
        table[symbol] += self.increment
        if sum(table) > self.limit:
            table[:] = [f - f // 2 for f in table]
        return found


def plain(word: str, head: str) -> str:
    """Clause: CODE-PLAIN-1."""
    table = {"C": "0", "S": "100", "R": "101", "L": "110", "E": "111"}
    return "".join(table[symbol] for symbol in word[len(head) :])


def golden(word: str, head: str) -> str:
    """Clauses: CODE-GOLDEN-1, CODE-GOLDEN-2, CODE-GOLDEN-3."""
    fibonacci = [0, 1]
    while len(fibonacci) <= 24:
        fibonacci.append(fibonacci[-1] + fibonacci[-2])
    after_c = [fibonacci[24 - 1], 0, 0, fibonacci[24 - 3], fibonacci[24 - 4]]
    else_where = [fibonacci[24 - units] for units in (2, 4, 3, 4, 5)]

    def slots() -> Iterator[Slot]:
        for i in range(len(head), len(word)):
            table = after_c if word[:i].endswith("C") else else_where
            s = SYMBOLS.index(word[i])
            yield sum(table[:s]), sum(table[: s + 1]), sum(table)

    return long_addition(slots())


def adaptive(order: int, word: str, head: str) -> str:
    """Clauses: CODE-ADAPTIVE-1, INFO-CONTEXT-3."""
    models: dict[str, Counts] = {}

    def slots() -> Iterator[Slot]:
        for i in range(len(head), len(word)):
            past = word[max(0, i - order) : i]
            after_c = word[:i].endswith("C")
            fresh = Counts((1, 0, 0, 1, 1) if after_c else (1, 1, 1, 1, 1), 2, 4096)
            yield models.setdefault(past, fresh).slot(SYMBOLS.index(word[i]))

    return long_addition(slots())


def king_rossignac(word: str, head: str) -> str:
    """Clauses: CODE-KR-1, CODE-KR-2."""
    after_c = {"C": "0", "S": "10", "R": "11"}
    otherwise: tuple[Mapping[str, str], ...] = (
        {"C": "0", "S": "100", "R": "101", "L": "110", "E": "111"},
        {"C": "00", "S": "111", "R": "10", "L": "110", "E": "01"},
        {"C": "00", "S": "010", "R": "011", "L": "10", "E": "11"},
    )
    coded = [
        "".join(
            (after_c if word[:i].endswith("C") else table)[word[i]]
            for i in range(len(head), len(word))
        )
        for table in otherwise
    ]
    best = min(range(3), key=lambda i: len(coded[i]))
    return f"{best:02b}" + coded[best]


def huffman(word: str, head: str) -> str:
    """Clauses: CODE-HUFFMAN-1, CODE-HUFFMAN-2, INFO-HUFFMAN-1, INFO-KRAFT-3."""
    rest = word[len(head) :]
    lengths = dict.fromkeys(SYMBOLS, 0)
    trees = [(rest.count(x), SYMBOLS.index(x), x) for x in SYMBOLS if x in rest]
    number = len(SYMBOLS)
    if len(trees) == 1:
        lengths[rest[0]] = 1
    while len(trees) > 1:
        (one, _, left), (two, _, right), *trees = sorted(trees)
        trees.append((one + two, number, left + right))
        number += 1
        for x in left + right:
            lengths[x] += 1
    words: dict[str, str] = {}
    at = Fraction(0)
    for length, _, x in sorted((lengths[x], SYMBOLS.index(x), x) for x in SYMBOLS if lengths[x]):
        words[x] = f"{int(at * 2**length):0{length}b}"
        at += Fraction(1, 2**length)
    return "".join(f"{lengths[x]:03b}" for x in SYMBOLS) + "".join(words[x] for x in rest)


Closing = tuple[int, int, int, int]
"""Passed, kind (`handle` 0, `boundary` 1), side (`right` 0, `left` 1), between. CODE-HAND-1."""


def handles(closings: Sequence[Closing], symbols: int) -> str:
    """Clause: CODE-HAND-4."""
    sizes = max(1, symbols.bit_length())
    fields = [Counts((1,) * size, 2, QUARTER) for size in (sizes, 2, 2, sizes)]

    def slots() -> Iterator[Slot]:
        for closing in closings:
            for field, value in zip(fields, closing, strict=True):
                if field in (fields[0], fields[3]):
                    size = (value + 1).bit_length() - 1
                    yield field.slot(size)
                    if size:
                        digits = value + 1 - (1 << size)
                        yield digits, digits + 1, 1 << size
                else:
                    yield field.slot(value)

    return long_addition(slots())
