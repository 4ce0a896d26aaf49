"""Minimax codes: tables for contexts of several symbols, by which all spheres cost about the same.

The contexts know which symbols no sphere's word goes on with; the tables are those whose worst case
is least, in whole numbers; certificates prove what they cost.
"""

from dataclasses import dataclass
from fractions import Fraction
from math import floor
from typing import Final

from clers.arithmetic import coder
from clers.arithmetic.bits import Bits
from clers.codes import minimax_tables as given
from clers.codes.code import Code, Guarantee, Shape
from clers.codes.implied import NUMBER, letters, numbers
from clers.complexes.topology import Component
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.information.automaton import Automaton, Context, contexts


@dataclass(frozen=True, slots=True)
class Minimax:
    """A code with contexts of `order` symbols, and what it promises for spheres.

    `shortest[q]` is the first of the shortest words that lead to context q; a sphere of T triangles
    takes `rate`·T + `constant` bits at most. Clauses: CODE-MINIMAX-1 … CODE-MINIMAX-6.
    """

    order: int
    shortest: tuple[str, ...]
    automaton: Automaton
    rate: Fraction
    constant: Fraction


MINIMAX_3: Final = Minimax(
    3,
    given.SHORTEST_3,
    Automaton(given.FREQUENCIES_3, given.SUCCESSORS_3),
    Fraction("1.70696"),
    Fraction("-0.98"),
)
"""Four contexts. Clauses: CODE-MINIMAX-2, CODE-MINIMAX-6."""

MINIMAX_8: Final = Minimax(
    8,
    given.SHORTEST_8,
    Automaton(given.FREQUENCIES_8, given.SUCCESSORS_8),
    Fraction("1.67613"),
    Fraction("-0.30"),
)
"""37 contexts. Clauses: CODE-MINIMAX-3, CODE-MINIMAX-6."""

ALL: Final = (MINIMAX_3, MINIMAX_8)


_BEGIN: Final = {of.order: contexts(of.automaton)[0] for of in ALL}


def model(of: Minimax, head: str) -> Context:
    """The model that begins after the implied symbols. Clause: CODE-MINIMAX-4."""
    begin = _BEGIN[of.order]
    return begin.after(NUMBER[head]) if head else begin


def encode(of: Minimax, symbols: str, shape: Shape) -> Accepted[Bits] | Rejected:
    """The bits of the symbols after the implied ones. Linear.

    Clauses: CODE-MINIMAX-4, CODE-MINIMAX-5; their number: CODE-MINIMAX-6.
    """
    found = numbers(symbols, Clause.CODE_MINIMAX_4)
    if isinstance(found, Rejected):
        return found
    coded = coder.encode(model(of, shape.head), found.value)
    match coded:
        case Accepted():
            return coded
        case Rejected():  # the symbols are known, so this one has frequency 0 in its context
            detail = "no sphere's word goes on like this"
            return Rejected(Reason.NOT_REPRESENTABLE, Clause.CODE_MINIMAX_5, coded.where, detail)


def decode(of: Minimax, bits: Bits, count: int, shape: Shape) -> Accepted[str] | Rejected:
    """The `count` symbols of these bits, and no others. Linear. Clause: CODE-MINIMAX-4."""
    found = coder.decode_bytes(model(of, shape.head), bits, count)
    return and_then(found, lambda coded: Accepted(letters(coded)))


def most_symbols(bits: int) -> int:
    """Half a bit a symbol at the least; one may be implied. Clause: CODE-MINIMAX-7."""
    return 2 * bits + 1


def bound(of: Minimax, parts: tuple[Component, ...]) -> int | None:
    """The most bits for spheres; None if a component is none. Clause: CODE-MINIMAX-6."""
    if any(part.curves or part.genus for part in parts):
        return None
    return floor(of.rate * sum(part.faces for part in parts) + of.constant)


def code(of: Minimax) -> Code:
    """The code as a value. Clauses: CODE-MINIMAX-4 … CODE-MINIMAX-7."""
    line = f"{float(of.rate)}·T − {float(-of.constant)}"
    return Code(
        lambda symbols, shape: encode(of, symbols, shape),
        lambda bits, count, shape: decode(of, bits, count, shape),
        most_symbols,
        Guarantee(
            f"at most {line} bits for spheres of T triangles; other surfaces may be refused",
            lambda parts: bound(of, parts),
        ),
    )
