"""The plain code: one bit for C, three for each other symbol; 2T − 2 bits for a sphere."""

from typing import Final

from clers.arithmetic.bits import Bits, pack
from clers.codes.code import Code, Guarantee
from clers.codes.implied import stranger
from clers.complexes.topology import Component
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSymbol

CODEWORDS: Final = {"C": "0", "S": "100", "R": "101", "L": "110", "E": "111"}
"""Clause: CODE-PLAIN-1."""

_SYMBOL_OF: Final = {codeword: symbol for symbol, codeword in CODEWORDS.items()}


def encode(symbols: str) -> Accepted[Bits] | Rejected:
    """The bits of some symbols. Linear. Clauses: CODE-PLAIN-1, CODE-PLAIN-3."""
    fault = stranger(symbols, Clause.CODE_PLAIN_1)
    if fault is not None:
        return fault
    return Accepted(pack(int(bit) for x in symbols for bit in CODEWORDS[x]))


def decode(bits: Bits, count: int) -> Accepted[str] | Rejected:
    """The `count` symbols that these bits, all of them, stand for. Linear. Clause: CODE-PLAIN-2."""
    digits = bits.digits()
    symbols: list[str] = []
    at = 0
    while len(symbols) < count:
        width = 1 if digits[at : at + 1] == "0" else 3
        if at + width > len(digits):
            where = AtSymbol(len(symbols))
            detail = f"{bits.length} bits for {count} symbols"
            return Rejected(Reason.TRUNCATED_BITS, Clause.CODE_PLAIN_2, where, detail)
        symbols.append(_SYMBOL_OF[digits[at : at + width]])
        at += width
    if at < len(digits):
        detail = f"{len(digits) - at} bits more than {count} symbols need"
        return Rejected(Reason.TRAILING_BITS, Clause.CODE_PLAIN_2, detail=detail)
    return Accepted("".join(symbols))


def length(parts: tuple[Component, ...]) -> int:
    """The bits of a surface, by its counts: three a symbol, less two for each C. CODE-PLAIN-3."""
    symbols = sum(c.faces - (c.curves == 0) for c in parts)
    created = sum(c.vertices - (c.boundary_edges or 3) for c in parts)
    implied = not any(c.curves for c in parts)
    return 3 * symbols - 2 * created - implied


CODE: Final = Code(
    lambda symbols, shape: encode(symbols),
    lambda bits, count, shape: decode(bits, count),
    lambda bits: bits + 1,
    Guarantee("2T - 2 bits on spheres; by its counts on every surface", length),
)
"""Clauses: CODE-PLAIN-1 … CODE-PLAIN-3; CODE-NAME-3, CODE-NAME-4."""
