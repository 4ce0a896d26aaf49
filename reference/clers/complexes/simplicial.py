"""Abstract simplicial complexes of any dimension, by sets: what chapter 3 means by its words.

Nothing here is fast. Every function is the sentence of its clause, so that the linear algorithms
of this package can be held against it.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import combinations

Simplex = frozenset[int]


@dataclass(frozen=True, slots=True)
class Complex:
    """A set of simplices that contains every non-empty face of each. Clause: CPLX-COMPLEX-1."""

    simplices: frozenset[Simplex]


def closure(simplices: Iterable[Iterable[int]]) -> Complex:
    """The least complex that contains the given simplices. Clause: CPLX-COMPLEX-1."""
    return Complex(
        frozenset(
            frozenset(face)
            for simplex in map(frozenset, simplices)
            for size in range(1, len(simplex) + 1)
            for face in combinations(simplex, size)
        )
    )


def of_dimension(k: Complex, m: int) -> tuple[Simplex, ...]:
    """The m-simplices, those with m+1 vertices, in lexicographic order. Clause: CPLX-COMPLEX-2."""
    return tuple(sorted((s for s in k.simplices if len(s) == m + 1), key=sorted))


def dimension(k: Complex) -> int:
    """The largest dimension of a simplex; −1 where there is none. Clause: CPLX-COMPLEX-2."""
    return max((len(s) for s in k.simplices), default=0) - 1


def euler(k: Complex) -> int:
    """χ, the alternating sum of the numbers of simplices. Clause: CPLX-COMPLEX-3."""
    return sum(1 if len(s) % 2 == 1 else -1 for s in k.simplices)


def star(k: Complex, simplex: Simplex) -> frozenset[Simplex]:
    """The open star: every simplex that contains the given one. Clause: CPLX-COMPLEX-4."""
    return frozenset(s for s in k.simplices if s >= simplex)


def link(k: Complex, simplex: Simplex) -> Complex:
    """The simplices off the given one that span a simplex with it.

    Clauses: CPLX-COMPLEX-4, CPLX-STAR-4.
    """
    whole = k.simplices
    return Complex(frozenset(s for s in whole if not s & simplex and s | simplex in whole))


def is_pure(k: Complex) -> bool:
    """Does every simplex lie in one of the largest dimension? Clause: CPLX-COMPLEX-5."""
    largest = of_dimension(k, dimension(k))
    return all(any(s <= big for big in largest) for s in k.simplices)


def boundary(k: Complex) -> Complex:
    """The closure of the (n−1)-simplices in exactly one n-simplex. Clause: CPLX-COMPLEX-5."""
    n = dimension(k)
    largest = of_dimension(k, n)
    return closure(s for s in of_dimension(k, n - 1) if sum(s < big for big in largest) == 1)


def pieces(k: Complex) -> tuple[Complex, ...]:
    """The connected components, by their lowest vertices.

    Clauses: CPLX-COMPLEX-6, CPLX-PART-3.
    """
    left = set(k.simplices)
    found: list[Complex] = []
    while left:
        first = min(left, key=min)
        piece, reached = {first}, set(first)
        while more := {s for s in left if s & reached} - piece:
            piece |= more
            reached.update(*more)
        left -= piece
        found.append(Complex(frozenset(piece)))
    return tuple(found)


def is_circle(k: Complex) -> bool:
    """A connected graph with two edges at each vertex. Clause: CPLX-SURFACE-1."""
    return _is_connected_graph(k) and _degrees(k) == {2}


def is_arc(k: Complex) -> bool:
    """A connected graph with χ = 1 and at most two edges at each vertex. Clause: CPLX-SURFACE-1."""
    return _is_connected_graph(k) and euler(k) == 1 and _degrees(k) <= {1, 2}


def _is_connected_graph(k: Complex) -> bool:
    return dimension(k) == 1 and len(pieces(k)) == 1


def _degrees(k: Complex) -> set[int]:
    edges = of_dimension(k, 1)
    return {sum(v < edge for edge in edges) for v in of_dimension(k, 0)}
