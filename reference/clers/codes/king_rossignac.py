"""King and Rossignac's code: the shortest of three prefix codes, and two bits that say which.

No two of the three are long on the same symbol, so that the shortest is at most their mean.
"""

from typing import Final

from clers.arithmetic.bits import Bits, pack
from clers.codes.code import Code, Guarantee, Shape
from clers.codes.counts import counts_of
from clers.complexes.topology import Component
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol

AFTER_C: Final = {"C": "0", "S": "10", "R": "11"}
"""The same in all three: L and E never follow C. Clause: CODE-KR-1."""

OTHERWISE: Final = (
    {"C": "0", "S": "100", "R": "101", "L": "110", "E": "111"},
    {"C": "00", "S": "111", "R": "10", "L": "110", "E": "01"},
    {"C": "00", "S": "010", "R": "011", "L": "10", "E": "11"},
)
"""Codes I, II and III, at the beginning of the word too. Clause: CODE-KR-1."""

SELECTOR: Final = 2
"""The bits before the codewords. Clause: CODE-KR-2."""

_LONGEST: Final = 3

_SYMBOL_AFTER_C: Final = {codeword: symbol for symbol, codeword in AFTER_C.items()}
_SYMBOL_OTHERWISE: Final = tuple(
    {codeword: symbol for symbol, codeword in table.items()} for table in OTHERWISE
)


def lengths(symbols: str, head: str) -> tuple[int, ...]:
    """The bits that the symbols after `head` take in each of the three codes, without selector.

    The symbols have neither CL nor CE. Clause: CODE-KR-4.
    """
    whole = head + symbols
    count = {x: symbols.count(x) for x in "CSRE"}
    count["L"] = len(symbols) - sum(count.values())
    after_c = {x: whole.count("C" + x) for x in "SR"}
    followed = count["C"] + head.count("C") - whole.endswith("C")
    after_c["C"] = followed - sum(after_c.values())
    fixed = sum(n * len(AFTER_C[x]) for x, n in after_c.items())
    free = [(x, count[x] - after_c.get(x, 0)) for x in OTHERWISE[0]]
    return tuple(fixed + sum(n * len(table[x]) for x, n in free) for table in OTHERWISE)


def chosen(symbols: str, head: str) -> int:
    """Which code is the shortest; the first of those. Clause: CODE-KR-2."""
    found = lengths(symbols, head)
    return found.index(min(found))


def encode(symbols: str, shape: Shape) -> Accepted[Bits] | Rejected:
    """The selector, then the codewords. Linear. Clauses: CODE-KR-1, CODE-KR-2."""
    after_c = shape.head == "C"
    for at, x in enumerate(symbols):
        if x not in (AFTER_C if after_c else OTHERWISE[0]):
            return Rejected(Reason.NOT_IN_ALPHABET, Clause.CODE_KR_1, AtSymbol(at))
        after_c = x == "C"
    which = chosen(symbols, shape.head)
    pairs = zip([shape.head, *symbols], symbols, strict=False)
    words = [(AFTER_C if before == "C" else OTHERWISE[which])[x] for before, x in pairs]
    return Accepted(pack(map(int, f"{which:0{SELECTOR}b}" + "".join(words))))


def decode(bits: Bits, count: int, shape: Shape) -> Accepted[str] | Rejected:
    """The `count` symbols of these bits, and no others. Linear. Clause: CODE-KR-3."""
    digits = bits.digits()
    if len(digits) < SELECTOR:
        return _truncated(0, bits, count)
    which = int(digits[:SELECTOR], 2)
    if which >= len(OTHERWISE):
        detail = f"there is no code {which}"
        return Rejected(Reason.NOT_CANONICAL, Clause.CODE_KR_3, detail=detail)
    symbols: list[str] = []
    at, after_c = SELECTOR, shape.head == "C"
    while len(symbols) < count:
        table = _SYMBOL_AFTER_C if after_c else _SYMBOL_OTHERWISE[which]
        words = (digits[at : at + width] for width in range(1, _LONGEST + 1))
        word = next((w for w in words if w in table), None)
        if word is None:
            return _truncated(len(symbols), bits, count)
        symbols.append(table[word])
        at, after_c = at + len(word), table[word] == "C"
    if at < len(digits):
        detail = f"{len(digits) - at} bits more than {count} symbols need"
        return Rejected(Reason.TRAILING_BITS, Clause.CODE_KR_3, detail=detail)
    found = "".join(symbols)
    if which != chosen(found, shape.head):
        detail = f"code {chosen(found, shape.head)} is shorter or comes first, {which} is used"
        return Rejected(Reason.NOT_CANONICAL, Clause.CODE_KR_3, detail=detail)
    return Accepted(found)


def _truncated(symbol: int, bits: Bits, count: int) -> Rejected:
    detail = f"{bits.length} bits for {count} symbols"
    return Rejected(Reason.TRUNCATED_BITS, Clause.CODE_KR_3, AtSymbol(symbol), detail)


def most_symbols(bits: int) -> int:
    """One bit a symbol at the least, after the selector; one may be implied. CODE-KR-7."""
    return max(bits - SELECTOR, 0) + 1


def sum_of_three(parts: tuple[Component, ...], cs: int) -> int:
    """What the three codes take together for the word of a surface with #CS = `cs`, all coded.

    Clause: CODE-KR-5.
    """
    counts = counts_of(parts)
    return 8 * counts.symbols - 5 * counts.created + counts.split - cs


def bound(parts: tuple[Component, ...], cs: int = 0) -> int:
    """The most bits that a surface can take, selector and all. Clauses: CODE-KR-6, CODE-KR-8."""
    closed = all(part.curves == 0 for part in parts)
    saved = sum(len(table["C"]) for table in OTHERWISE) if closed else 0
    return (sum_of_three(parts, cs) - saved) // len(OTHERWISE) + SELECTOR


CODE: Final = Code(
    encode,
    decode,
    most_symbols,
    Guarantee("at most 11T/6 − 1 bits for a sphere of T triangles", bound),
)
