"""What a move does to the numbers of simplices, by its formula.

A polynomial stands for a list of numbers: the coefficient of x^s is the number of simplices with s
vertices. Joins multiply, so that each move has a formula in the link that it works on.
"""

from typing import assert_never

from clers.complexes.simplicial import Complex
from clers.operators.moves.augmented import Augmented, around
from clers.operators.moves.move import (
    Bistellar,
    Collapse,
    Contract,
    Expand,
    Move,
    Split,
    Subdivide,
    Weld,
)
from clers.operators.moves.split import spanned

Polynomial = tuple[int, ...]
"""Coefficients, of x^0 first; the last is not zero."""


def effect(move: Move, k: Complex) -> tuple[int, ...]:
    """The changes of #0, #1, … by a move that applies to the complex. Clause: OPER-MOVE-6.

    The last is not zero; where nothing changes the list is empty.
    """
    match move:
        case Collapse(free, coface):
            change = negative(_sum(_power(len(free)), _power(len(coface))))
        case Expand(free, coface):
            change = _sum(_power(len(free)), _power(len(coface)))
        case Subdivide(simplex, _):
            link = _counted(around(k, frozenset(simplex)))
            change = _product(_subdivided(len(simplex)), link)
        case Weld(simplex, vertex):
            rest = frozenset(
                s for s in around(k, frozenset([vertex])) if not s & frozenset(simplex)
            )
            change = negative(_product(_subdivided(len(simplex)), _counted(rest)))
        case Bistellar(gone, come):
            change = _exchanged(len(gone), len(come))
        case Contract(keep, gone):
            link = _counted(around(k, frozenset([keep, gone])))
            change = negative(_product((0, 1, 1), link))
        case Split(_, _, _, shared):
            change = _product((0, 1, 1), _counted(spanned(shared)))
        case _:
            assert_never(move)
    return change[1:]


def _subdivided(size: int) -> Polynomial:
    """x ((1+x)^s − x^s) − x^s: the open star of a simplex alone."""
    frontier = _sum(_binomial(size), negative(_power(size)))
    return _sum(_product((0, 1), frontier), negative(_power(size)))


def _exchanged(gone: int, come: int) -> Polynomial:
    """x^t (1+x)^s − x^s (1+x)^t. Clause: OPER-BISTELLAR-4."""
    new = _product(_power(come), _binomial(gone))
    return _sum(new, negative(_product(_power(gone), _binomial(come))))


def _counted(simplices: Augmented) -> Polynomial:
    largest = max(map(len, simplices))
    return tuple(sum(len(s) == size for s in simplices) for size in range(largest + 1))


def _power(s: int) -> Polynomial:
    """x^s."""
    return (*(0,) * s, 1)


def _binomial(s: int) -> Polynomial:
    """(1 + x)^s."""
    result: Polynomial = (1,)
    for _ in range(s):
        result = _product(result, (1, 1))
    return result


def _sum(p: Polynomial, q: Polynomial) -> Polynomial:
    size = max(len(p), len(q))
    terms = [sum(r[i] for r in (p, q) if i < len(r)) for i in range(size)]
    while terms and terms[-1] == 0:
        terms.pop()
    return tuple(terms)


def negative(p: Polynomial) -> Polynomial:
    """The polynomial with all signs changed."""
    return tuple(-term for term in p)


def _product(p: Polynomial, q: Polynomial) -> Polynomial:
    if not p or not q:  # 0 has no terms
        return ()
    terms = [0] * (len(p) + len(q) - 1)
    for i, left in enumerate(p):
        for j, right in enumerate(q):
            terms[i + j] += left * right
    return tuple(terms)


def counts(k: Complex) -> tuple[int, ...]:
    """#0, #1, … of a complex. Clause: CPLX-COMPLEX-2."""
    return _counted(k.simplices | {frozenset[int]()})[1:]


def difference(after: tuple[int, ...], before: tuple[int, ...]) -> tuple[int, ...]:
    """The changes of all numbers, the last of them not zero. Clause: OPER-MOVE-6."""
    return _sum(after, negative(before))
