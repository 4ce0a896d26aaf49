"""Checkers of certificates: they read the definition aloud and share no step with `orient`.

An orientation is checked wall by wall, a one-sided cycle by carrying an ordering around it.
"""

from clers.complexes.manifolds.orient import OneSided, Oriented
from clers.complexes.manifolds.orientation import OrientedSimplex, oriented
from clers.complexes.simplicial import Complex, Simplex, dimension, of_dimension, star
from clers.conventions.result import Accepted


def is_coherent(k: Complex, given: Oriented) -> bool:
    """Is each n-simplex oriented once, and coherent with each neighbour? Clause: CPLX-COHERENT-2.

    A wall (v_1, …, v_n) in two n-simplices, of apexes v and w, is coherent if one of them is
    oriented as (v, v_1, …, v_n) and the other is opposed to (w, v_1, …, v_n).
    """
    n = dimension(k)
    named = [frozenset(simplex.vertices) for simplex in given.simplices]
    if len(named) != len(set(named)) or set(named) != set(of_dimension(k, n)):
        return False
    of = dict(zip(named, given.simplices, strict=True))
    return all(
        _agrees(of[sides[0]], wall) != _agrees(of[sides[1]], wall)
        for wall in of_dimension(k, n - 1)
        for sides in [neighbours_at(k, wall)]
        if len(sides) == 2
    )


def neighbours_at(k: Complex, wall: Simplex) -> tuple[Simplex, ...]:
    """The n-simplices at a wall. Clause: CPLX-COHERENT-2."""
    return tuple(sorted(star(k, wall) - {wall}, key=sorted))


def is_one_sided(k: Complex, given: OneSided) -> bool:
    """Does an ordering, carried around the cycle, come back odd? Clause: CPLX-COHERENT-4.

    Across a wall in exactly two n-simplices (v, v_1, …, v_n) becomes the opposite of
    (w, v_1, …, v_n): (w, v_1, …, v_n) with two vertices exchanged.
    """
    n = dimension(k)
    cycle = given.cycle
    if not cycle or len(set(cycle)) < len(cycle) or not set(cycle) <= set(of_dimension(k, n)):
        return False
    start = carried = tuple(cycle[0])
    for here, there in zip(cycle, (*cycle[1:], cycle[0]), strict=True):
        wall = here & there
        if len(neighbours_at(k, wall)) != 2:  # which only walls have
            return False
        (leaving,), (coming,) = here - wall, there - wall
        exchanged = tuple(coming if v == leaving else v for v in carried)
        carried = (*exchanged[:-2], exchanged[-1], exchanged[-2])
    return oriented(carried) != oriented(start)


def _agrees(of: OrientedSimplex, wall: Simplex) -> bool:
    """Is the simplex oriented as its apex, then the wall in the order it is listed?"""
    (apex,) = frozenset(of.vertices) - wall
    return oriented((apex, *wall)) == Accepted(of)
