"""Simplices with the empty one among them: then joins, links and frontiers obey one formula.

The frontier of a vertex is empty, and so is the link of a maximal simplex. Both must still be
something to join with, which the set of the empty simplex alone is.
"""

from collections.abc import Iterable
from itertools import combinations
from typing import Final

from clers.complexes.simplicial import Complex, Simplex, link

EMPTY: Final[Simplex] = frozenset()
"""The simplex without vertices, of dimension −1."""

Augmented = frozenset[Simplex]
"""A complex and the empty simplex."""


def proper_faces(simplex: Simplex) -> Augmented:
    """The frontier of a simplex, and the empty simplex. Clause: OPER-MOVE-1."""
    return frozenset(
        frozenset(face) for size in range(len(simplex)) for face in combinations(simplex, size)
    )


def around(k: Complex, simplex: Simplex) -> Augmented:
    """The link of a simplex, and the empty simplex. Clause: OPER-MOVE-1."""
    return link(k, simplex).simplices | {EMPTY}


def joined(first: Iterable[Simplex], second: Augmented) -> Augmented:
    """The unions of one simplex of each: the join, where no vertex is in both. OPER-MOVE-1."""
    return frozenset(left | right for left in first for right in second)


def complex_of(given: Augmented) -> Complex:
    """The simplices but the empty one."""
    return Complex(given - {EMPTY})


def in_order(simplex: Simplex) -> tuple[int, ...]:
    """The vertices of a simplex as operands and rejections name them."""
    return tuple(sorted(simplex))


def first_of(simplices: Iterable[Simplex]) -> Simplex | None:
    """The simplex with fewest vertices, then least in lexicographic order; None of none."""
    return min(simplices, key=lambda simplex: (len(simplex), sorted(simplex)), default=None)
