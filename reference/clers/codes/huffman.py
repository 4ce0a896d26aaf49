"""The Huffman code: one prefix code for the symbols of the word, made for it and stored before it.

What [34] of the tutorial does with one symbol at a time, for comparison.
"""

from typing import Final

from clers.arithmetic.bits import Bits, pack
from clers.codes import plain
from clers.codes.code import Code, Guarantee, Shape
from clers.codes.implied import NUMBER, stranger
from clers.complexes.topology import Component
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.edgebreaker.stream import SYMBOLS
from clers.information import prefix
from clers.information.canonical import canonical
from clers.information.huffman import huffman_lengths
from clers.information.prefix import Lengths

WIDTH: Final = 3
"""Binary digits of a length in the table. Clause: CODE-HUFFMAN-1."""

TABLE: Final = WIDTH * len(SYMBOLS)


def _lengths(symbols: str) -> Lengths:
    """The length of each symbol's codeword, None if it does not occur. Clause: CODE-HUFFMAN-2."""
    counts = tuple(map(symbols.count, SYMBOLS))
    match huffman_lengths(counts):
        case Accepted(lengths) if max(length or 0 for length in lengths) > 0:
            return lengths
        case _:  # one symbol or none: a word of one digit keeps the number of symbols honest
            return tuple(1 if count else None for count in counts)


def encode(symbols: str, shape: Shape) -> Accepted[Bits] | Rejected:
    """The table of lengths, then the codewords.

    Linear. Clauses: CODE-HUFFMAN-1, CODE-HUFFMAN-2, CODE-HUFFMAN-4.
    """
    del shape
    fault = stranger(symbols, Clause.CODE_HUFFMAN_1)
    if fault is not None:
        return fault
    lengths = _lengths(symbols)
    table = "".join(f"{length or 0:0{WIDTH}b}" for length in lengths)
    numbers = [NUMBER[x] for x in symbols]
    digits = and_then(canonical(lengths), lambda code: prefix.encode(code, numbers))
    return and_then(digits, lambda found: Accepted(pack(map(int, table + found))))


def decode(bits: Bits, count: int, shape: Shape) -> Accepted[str] | Rejected:
    """The `count` symbols of these bits, and no others. Linear. Clause: CODE-HUFFMAN-3."""
    del shape
    digits = bits.digits()
    if len(digits) < TABLE:
        detail = f"{bits.length} bits, the table has {TABLE}"
        return Rejected(Reason.TRUNCATED_BITS, Clause.CODE_HUFFMAN_3, detail=detail)
    numbers = [int(digits[at : at + WIDTH], 2) for at in range(0, TABLE, WIDTH)]
    lengths = tuple(number or None for number in numbers)
    words = and_then(canonical(lengths), lambda code: prefix.decode(code, digits[TABLE:], count))
    if isinstance(words, Rejected):
        return words
    symbols = "".join(SYMBOLS[s] for s in words.value)
    if _lengths(symbols) != lengths:
        detail = "the table is not the one that these symbols are given"
        return Rejected(Reason.NOT_CANONICAL, Clause.CODE_HUFFMAN_3, detail=detail)
    return Accepted(symbols)


def most_symbols(bits: int) -> int:
    """One bit a symbol at the least, after the table; one is implied. Clause: CODE-NAME-3."""
    return max(bits - TABLE, 0) + 1


def _bound(parts: tuple[Component, ...]) -> int:
    """No longer than plain, but for the table. Clause: CODE-HUFFMAN-4."""
    return TABLE + plain.length(parts)


CODE: Final = Code(
    encode,
    decode,
    most_symbols,
    Guarantee(f"at most {TABLE} bits more than plain on every surface", _bound),
)
