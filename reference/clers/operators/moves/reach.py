"""Triangulations up to isomorphism, and which of them flips reach.

For complexes that a walk across walls explores: simplices of the largest dimension n, joined across
simplices of dimension n−1 that lie in two of them at most.
"""

from collections.abc import Mapping
from itertools import permutations

from clers.complexes.simplicial import Complex, Simplex, dimension, of_dimension
from clers.conventions.result import Accepted
from clers.operators.moves.bistellar import bistellar
from clers.operators.moves.candidates import flips
from clers.operators.moves.move import Bistellar

Form = tuple[tuple[int, ...], ...]
"""Facets under new names, each in order, listed as a walk meets them."""


def canonical(k: Complex) -> Form:
    """The least form; the same for two complexes exactly if they are isomorphic. OPER-FLIPS-1."""
    return min(_forms(k), default=())


def automorphisms(k: Complex) -> int:
    """The number of ways to rename the vertices that keep the complex. Clause: OPER-FLIPS-2."""
    forms = _forms(k) or [()]
    return forms.count(min(forms))


def _forms(k: Complex) -> list[Form]:
    """The form from each ordered facet."""
    facets = of_dimension(k, dimension(k))
    at: dict[Simplex, list[Simplex]] = {}
    for facet in facets:
        for v in facet:
            at.setdefault(facet - {v}, []).append(facet)
    return [_form(at, root) for facet in facets for root in permutations(sorted(facet))]


def _form(at: Mapping[Simplex, list[Simplex]], root: tuple[int, ...]) -> Form:
    """Breadth first; across its walls in the order of the vertices that the walk gave a facet."""
    name = {v: i for i, v in enumerate(root)}
    queue, seen = [root], {frozenset(root)}
    for facet in queue:
        for i, v in enumerate(facet):
            for other in at[frozenset(facet) - {v}]:
                if other not in seen:
                    seen.add(other)
                    (w,) = other - frozenset(facet)
                    name.setdefault(w, len(name))
                    queue.append((*facet[:i], w, *facet[i + 1 :]))
    return tuple(tuple(sorted(name[v] for v in facet)) for facet in queue)


def neighbours(k: Complex) -> list[Complex]:
    """What one flip that keeps the numbers of vertices and of facets makes of a complex.

    On a surface: the flip of an edge. Clauses: OPER-BISTELLAR-3, OPER-FLIPS-3.
    """
    found: list[Complex] = []
    for move in flips(k):
        if isinstance(move, Bistellar) and len(move.gone) == len(move.come):
            after = bistellar(k, move)
            if isinstance(after, Accepted):
                found.append(after.value)
    return found


def reachable(k: Complex) -> frozenset[Form]:
    """The canonical forms of all that such flips lead to. Clauses: OPER-FLIPS-3, OPER-FLIPS-4."""
    found, todo = {canonical(k)}, [k]
    while todo:
        for other in neighbours(todo.pop()):
            form = canonical(other)
            if form not in found:
                found.add(form)
                todo.append(other)
    return frozenset(found)


def labelled(k: Complex) -> frozenset[Complex]:
    """All that such flips lead to, under the names that the vertices have. Clause: OPER-FLIPS-3."""
    found, todo = {k}, [k]
    while todo:
        for other in neighbours(todo.pop()):
            if other not in found:
                found.add(other)
                todo.append(other)
    return frozenset(found)
