"""The golden code: every sphere of T triangles has the same ideal length, (5T/2 − 2)·log2 φ bits.

Two contexts, after a C and elsewhere, with probabilities that are powers of the golden ratio. In
units of log2 φ a symbol costs a whole number, and the sum over a word depends on the surface only.
"""

from math import floor, log2, sqrt
from typing import Final

from clers.arithmetic import coder
from clers.arithmetic.bits import Bits
from clers.codes.code import Code, Guarantee
from clers.codes.implied import implied, letters, numbers
from clers.complexes.topology import Component
from clers.conventions.clause import Clause
from clers.conventions.result import Accepted, Rejected, and_then
from clers.edgebreaker.stream import SYMBOLS
from clers.information.automaton import Automaton, Context, contexts

UNIT: Final = log2((1 + sqrt(5)) / 2)
"""log2 φ, in bits."""

UNITS_ELSEWHERE: Final = {"C": 2, "L": 4, "E": 3, "R": 4, "S": 5}
UNITS_AFTER_C: Final = {"C": 1, "R": 3, "S": 4}
"""What each symbol costs in units; L and E never follow C. Clause: CODE-GOLDEN-1."""

FIBONACCI: Final = 24
"""The tables are Fibonacci numbers out of the 24th, 46368. Clause: CODE-GOLDEN-2."""


def fibonacci(n: int) -> int:
    """F(1) = F(2) = 1, F(n) = F(n-1) + F(n-2)."""
    a, b = 0, 1
    for _ in range(n):
        a, b = b, a + b
    return a


def _frequencies(units: dict[str, int]) -> tuple[int, ...]:
    return tuple(fibonacci(FIBONACCI - units[x]) if x in units else 0 for x in SYMBOLS)


AUTOMATON: Final = Automaton(
    frequencies=(_frequencies(UNITS_ELSEWHERE), _frequencies(UNITS_AFTER_C)),
    successors=((1, 0, 0, 0, 0), (1, 0, 0, 0, 0)),
)
ELSEWHERE, AFTER_C = contexts(AUTOMATON)


def model(head: str) -> Context:
    """The model that begins after the implied symbols. Clause: CODE-GOLDEN-3."""
    return AFTER_C if head.endswith("C") else ELSEWHERE


def encode(symbols: str, head: str) -> Accepted[Bits] | Rejected:
    """The bits of the symbols that follow `head`. Linear.

    Clauses: CODE-GOLDEN-1 … CODE-GOLDEN-3; their number: CODE-GOLDEN-6, CODE-GOLDEN-7.
    """
    found = numbers(symbols, Clause.CODE_GOLDEN_1)
    return and_then(found, lambda coded: coder.encode(model(head), coded))


def decode(bits: Bits, count: int, head: str) -> Accepted[str] | Rejected:
    """The `count` symbols that follow `head`. Linear. Clauses: CODE-GOLDEN-1 … -3."""
    found = coder.decode_bytes(model(head), bits, count)
    return and_then(found, lambda coded: Accepted(letters(coded)))


def units(word: str) -> int:
    """The ideal length of a word, all symbols coded, in units of log2 φ. Clause: CODE-GOLDEN-4.

    The word of a surface: CL and CE do not occur in it.
    """
    pairs = zip(" " + word, word, strict=False)
    return sum((UNITS_AFTER_C if before == "C" else UNITS_ELSEWHERE)[x] for before, x in pairs)


def units_of(component: Component) -> int:
    """The same number, from the surface alone. Clause: CODE-GOLDEN-5."""
    t, g, b = component.faces, component.genus, component.curves
    if b == 0:
        return 5 * t // 2 - 2 + 8 * g
    return (5 * t + 3 * component.boundary_edges) // 2 - 8 + 8 * g + 4 * b


def _bound(parts: tuple[Component, ...]) -> int:
    """The most bits that a surface of these components takes. Clauses: CODE-GOLDEN-5, -6."""
    head = implied(sum(c.curves > 0 for c in parts))
    symbols = sum(c.faces - (c.curves == 0) for c in parts) - len(head)
    ideal = sum(map(units_of, parts)) - units(head)
    return floor(ideal * UNIT + 2 + symbols / 15000)


CODE: Final = Code(
    lambda symbols, shape: encode(symbols, shape.head),
    lambda bits, count, shape: decode(bits, count, shape.head),
    lambda bits: floor(bits / UNIT) + 2,
    Guarantee("at most 11T/6 bits on spheres; by its counts on every surface", _bound),
)
"""Clauses: CODE-GOLDEN-1 … CODE-GOLDEN-7; CODE-NAME-3, CODE-NAME-4."""
