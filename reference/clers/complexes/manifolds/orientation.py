"""Oriented simplices: orderings of the vertices, of which those of one parity are the same."""

from dataclasses import dataclass
from itertools import combinations

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtVertex


@dataclass(frozen=True, slots=True)
class OrientedSimplex:
    """A simplex with one of its two orientations. Clause: CPLX-COHERENT-1.

    `vertices` increase. `positive`: their increasing order is one of the orderings meant, otherwise
    an exchange of two leads to one. Built by `oriented`.
    """

    vertices: tuple[int, ...]
    positive: bool


def oriented(ordering: tuple[int, ...]) -> Accepted[OrientedSimplex] | Rejected:
    """The orientation that an ordering stands for; not empty, no vertex twice. CPLX-COHERENT-1."""
    if not ordering:
        return Rejected(Reason.EMPTY_SIMPLEX, Clause.CPLX_COHERENT_1)
    for i, v in enumerate(ordering):
        if v in ordering[:i]:
            return Rejected(Reason.REPEATED_VERTEX, Clause.CPLX_COHERENT_1, AtVertex(v))
    return Accepted(_of(ordering))


def _of(ordering: tuple[int, ...]) -> OrientedSimplex:
    """Even permutations have an even number of pairs in the wrong order."""
    wrong = sum(a > b for a, b in combinations(ordering, 2))
    return OrientedSimplex(tuple(sorted(ordering)), wrong % 2 == 0)


def opposite(of: OrientedSimplex) -> OrientedSimplex:
    """The other orientation of the same simplex. Clause: CPLX-COHERENT-1."""
    return OrientedSimplex(of.vertices, not of.positive)


def ordering(of: OrientedSimplex) -> tuple[int, ...]:
    """The least ordering meant: increasing, or with the last two exchanged. CPLX-COHERENT-1.

    A point has one ordering only, which stands for both of its orientations.
    """
    v = of.vertices
    return v if of.positive else (*v[:-2], *v[:-3:-1])


def joined(apex: int, wall: OrientedSimplex) -> OrientedSimplex:
    """The simplex ordered as the apex first, then the wall. Clause: CPLX-COHERENT-2."""
    turned = sum(v < apex for v in wall.vertices) % 2 == 1
    return OrientedSimplex(tuple(sorted((apex, *wall.vertices))), wall.positive != turned)


def induced(of: OrientedSimplex, apex: int) -> OrientedSimplex:
    """The wall opposite to a vertex, so that apex and wall make up the simplex. CPLX-COHERENT-2.

    Induced on the boundary of a manifold it is coherent again: CPLX-COHERENT-9.
    A vertex that the simplex has not takes nothing away.
    """
    wall = tuple(v for v in of.vertices if v != apex)
    turned = sum(v < apex for v in wall) % 2 == 1
    return OrientedSimplex(wall, of.positive != turned)


def next_vertex(of: OrientedSimplex, v: int) -> Accepted[int] | Rejected:
    """The vertex after another around an oriented triangle. Clause: CPLX-COHERENT-7."""
    return _turned(of, v, 1)


def previous_vertex(of: OrientedSimplex, v: int) -> Accepted[int] | Rejected:
    """The vertex before another around an oriented triangle. Clause: CPLX-COHERENT-7."""
    return _turned(of, v, 2)


def _turned(of: OrientedSimplex, v: int, steps: int) -> Accepted[int] | Rejected:
    around = ordering(of)
    if len(around) != 3 or v not in around:
        return Rejected(Reason.OPERATOR_NOT_APPLICABLE, Clause.CPLX_COHERENT_7, AtVertex(v))
    return Accepted(around[(around.index(v) + steps) % 3])
