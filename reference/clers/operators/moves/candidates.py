"""Moves chosen by numbers, so that any list of numbers is a list of moves.

For each number the first move from there on that applies is taken, so that few numbers do nothing.
"""

from collections.abc import Callable, Iterator, Sequence
from typing import Final

from clers.complexes.simplicial import Complex, Simplex, link, of_dimension, star
from clers.conventions.result import Accepted
from clers.operators.moves.apply import apply
from clers.operators.moves.augmented import in_order
from clers.operators.moves.collapse import free_pairs
from clers.operators.moves.move import Bistellar, Collapse, Contract, Move, Split, Subdivide
from clers.operators.moves.split import spanning


def simplices(k: Complex) -> list[Simplex]:
    """All simplices, those of the highest dimension first."""
    return sorted(k.simplices, key=lambda s: (-len(s), sorted(s)))


def new_vertex(k: Complex) -> int:
    """The number after the largest vertex; 0 where there is none."""
    return 1 + max((v for simplex in k.simplices for v in simplex), default=-1)


def subdivisions(k: Complex) -> Iterator[Move]:
    """A subdivision of each simplex that is no vertex. Clause: OPER-STELLAR-1."""
    new = new_vertex(k)
    return (Subdivide(in_order(s), new) for s in simplices(k) if len(s) > 1)


def flips(k: Complex) -> Iterator[Move]:
    """For each simplex that is not maximal, the bistellar move to the vertices of its link.

    Clause: OPER-BISTELLAR-1.
    """
    for a in simplices(k):
        b = frozenset[int]().union(*link(k, a).simplices)
        if b:
            yield Bistellar(in_order(a), in_order(b))


def contractions(k: Complex) -> Iterator[Move]:
    """Each edge, contracted to its lower end. Clause: OPER-CONTRACT-1."""
    return (Contract(*in_order(edge)) for edge in of_dimension(k, 1))


def splits(k: Complex) -> Iterator[Move]:
    """At each edge: the star of one end in the link of the other moves. Clause: OPER-CONTRACT-4."""
    new = new_vertex(k)
    for edge in of_dimension(k, 1):
        for v in in_order(edge):
            near = link(k, frozenset([v]))
            other = edge - {v}
            moved = star(near, other)
            yield Split(v, new, spanning(moved), spanning(link(near, other).simplices))


def collapses(k: Complex) -> Iterator[Move]:
    """All collapses that apply. Clause: OPER-COLLAPSE-1."""
    return (Collapse(in_order(free), in_order(of)) for free, of in free_pairs(k))


Kind = Callable[[Complex], Iterator[Move]]

KINDS: Final[tuple[Kind, ...]] = (contractions, flips, subdivisions, splits)
"""Kinds of moves that keep manifolds (OPER-MOVE-7), those that make a complex smaller first."""


def chosen(k: Complex, choice: int, kinds: Sequence[Kind] = KINDS) -> Move | None:
    """The move that a number chooses: first the kind, then where. None where none applies."""
    found = _first(k, choice, kinds)
    return None if found is None else found[0]


def _first(k: Complex, choice: int, kinds: Sequence[Kind]) -> tuple[Move, Complex] | None:
    """The first move from the chosen place on that applies, and what it leads to."""
    moves = list(kinds[choice % len(kinds)](k))
    start = choice // len(kinds) % max(len(moves), 1)
    for move in moves[start:] + moves:
        after = apply(move, k)
        if isinstance(after, Accepted):
            return move, after.value
    return None


def vary(
    k: Complex, choices: Sequence[int], most: int = 12, kinds: Sequence[Kind] = KINDS
) -> Complex:
    """The complex after the moves that these numbers choose; with at most so many vertices.

    Homeomorphic to the given one, where that is a combinatorial manifold. Clause: OPER-MOVE-7.
    """
    for choice in choices:
        found = _first(k, choice, kinds)
        if found is not None and len(of_dimension(found[1], 0)) <= most:
            k = found[1]
    return k
