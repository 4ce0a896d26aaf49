"""Euler attachments as sequences of simplicial expansions, and the tutorial's orders of them."""

from collections.abc import Container, Iterator, Sequence

from clers.complexes.simplicial import Complex, closure
from clers.operators.attachments.attachment import (
    Attachment,
    Vertices,
    added,
    attachment,
    common,
    in_order,
)
from clers.operators.moves.move import Expand


def expansions(glued: Attachment) -> tuple[Expand, ...] | None:
    """The expansions that an Euler attachment consists of; None if there are none.

    The next is always at the first simplex, by dimension and then by vertices, that lacks one facet
    only. For m ≤ 6 nothing is missed so. Clauses: OPER-SIMPLEX-1, OPER-SIMPLEX-2.
    """
    missing = sorted(map(in_order, added(glued)), key=lambda s: (len(s), s))
    left = set(missing)
    found: list[Expand] = []
    while left:
        ready = next((pair for pair in _ready(missing, left)), None)
        if ready is None:
            return None
        found.append(ready)
        left -= {ready.free, ready.coface}
    return tuple(found)


def _ready(missing: Sequence[Vertices], left: Container[Vertices]) -> Iterator[Expand]:
    for coface in missing:
        if coface in left:
            free = [facet for facet in facets(coface) if facet in left]
            if len(free) == 1:
                yield Expand(free[0], coface)


def facets(simplex: Vertices) -> tuple[Vertices, ...]:
    """The faces with one vertex less, in lexicographic order; none of a vertex."""
    if len(simplex) == 1:
        return ()
    return tuple(simplex[:i] + simplex[i + 1 :] for i in reversed(range(len(simplex))))


def has_order(glued: Attachment) -> bool:
    """Is it a simplex attachment in the tutorial's words, of the order m? Clause: OPER-SIMPLEX-3.

    An expansion of a facet and the simplex, preceded by at most m − 1 attachments of order m − 1.
    """
    m = len(glued.simplex) - 1
    if m == 1:
        return len(glued.along) == 1
    frontier = [frozenset(facet) for facet in facets(glued.simplex)]
    all_but_two = 2 ** (m + 1) - 1 - 2
    reached = {common(glued).simplices}
    for _ in range(m):
        if any(len(there) == all_but_two for there in reached):
            return True
        # a facet that is there has no order again: it would be glued along its whole frontier
        reached = {
            there | closure([facet]).simplices
            for there in reached
            for facet in frontier
            if has_order(attachment(Complex(there), facet))
        }
    return False
