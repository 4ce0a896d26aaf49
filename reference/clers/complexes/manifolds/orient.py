"""Coherent orientations: one for all simplices, or a cycle of simplices that admits none."""

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import takewhile

from clers.complexes.manifolds.incidence import Walls, flaw_at_a_wall, walls
from clers.complexes.manifolds.orientation import OrientedSimplex, induced, joined, opposite
from clers.complexes.simplicial import Complex, Simplex, dimension, of_dimension
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Rejected
from clers.conventions.where import AtSimplex


@dataclass(frozen=True, slots=True)
class Oriented:
    """A coherent orientation of each n-simplex, in lexicographic order. Clause: CPLX-COHERENT-3."""

    simplices: tuple[OrientedSimplex, ...]


@dataclass(frozen=True, slots=True)
class OneSided:
    """n-simplices, each neighbour of the next and the last of the first. Clause: CPLX-COHERENT-4.

    An orientation that is carried around comes back as the opposite.
    """

    cycle: tuple[Simplex, ...]


def orient(k: Complex) -> Oriented | OneSided | Rejected:
    """A coherent orientation, or the cycle that refutes it. Linear.

    In each strongly connected part the lowest n-simplex is positive, one choice of two for each.
    Rejects what is not pure or has a wall in three. Clauses: CPLX-COHERENT-3 … CPLX-COHERENT-6,
    CPLX-COHERENT-8.
    """
    fault = flaw_at_a_wall(k)
    if fault is not None:
        where = AtSimplex(tuple(sorted(fault.simplex)))
        return Rejected(Reason.NOT_A_MANIFOLD, Clause.CPLX_COHERENT_8, where, fault.flaw)
    between = walls(k)
    found: dict[Simplex, OrientedSimplex] = {}
    parent: dict[Simplex, Simplex] = {}
    for start in of_dimension(k, dimension(k)):
        if start in found:
            continue
        found[start] = OrientedSimplex(tuple(sorted(start)), positive=True)
        queue = [start]
        for simplex in queue:  # which grows on the way
            for other, carried in _across(found[simplex], between):
                if other not in found:
                    found[other], parent[other] = carried, simplex
                    queue.append(other)
                elif found[other] != carried:
                    return OneSided(_cycle(parent, simplex, other))
    return Oriented(tuple(found[simplex] for simplex in of_dimension(k, dimension(k))))


def _across(of: OrientedSimplex, between: Walls) -> list[tuple[Simplex, OrientedSimplex]]:
    """The neighbours of an oriented simplex, each oriented so that the two are coherent."""
    here = frozenset(of.vertices)
    return [
        (other, joined(far, opposite(induced(of, apex))))
        for apex in of.vertices
        for wall in [here - {apex}]
        for other in between.get(wall, ())  # a point has no wall
        for far in other - here
    ]


def _cycle(parent: Mapping[Simplex, Simplex], a: Simplex, b: Simplex) -> tuple[Simplex, ...]:
    """From a up the tree to the last common ancestor, and down to b."""
    first, second = _from_the_root(parent, a), _from_the_root(parent, b)
    pairs = zip(first, second, strict=False)
    shared = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], pairs))
    return (*reversed(first[shared - 1 :]), *second[shared:])


def _from_the_root(parent: Mapping[Simplex, Simplex], simplex: Simplex) -> list[Simplex]:
    path = [simplex]
    while path[-1] in parent:
        path.append(parent[path[-1]])
    return path[::-1]
