"""What lies at what: walls, links and components of a complex, in time linear in its simplices.

`simplicial` says what these are; here they are found in one pass, for a fixed dimension.
"""

from collections.abc import Iterator

from clers.complexes.manifolds.kind import Flaw, NotManifold
from clers.complexes.simplicial import Complex, Simplex, closure, dimension, of_dimension

Walls = dict[Simplex, tuple[Simplex, ...]]
"""For each (n−1)-simplex the n-simplices that it lies in, in lexicographic order."""


def walls(k: Complex) -> Walls:
    """The walls of a complex and what lies on their sides. Clause: CPLX-MANIFOLD-8."""
    n = dimension(k)
    found: Walls = dict.fromkeys(of_dimension(k, n - 1), ())
    for simplex in of_dimension(k, n):
        for v in simplex:
            wall = simplex - {v}
            if wall:  # a point has no wall
                found[wall] += (simplex,)
    return found


def flaw_at_a_wall(k: Complex) -> NotManifold | None:
    """The first fault that needs no link: not pure, or a wall in three. Clause: CPLX-MANIFOLD-3."""
    covered = {simplex - {v} for simplex in k.simplices for v in simplex}
    full = dimension(k) + 1
    loose = [s for s in k.simplices - covered if len(s) < full]
    if loose:
        return NotManifold(min(loose, key=lambda s: (len(s), sorted(s))), Flaw.NOT_PURE)
    for wall, sides in walls(k).items():
        if len(sides) > 2:
            return NotManifold(wall, Flaw.CROWDED_WALL)
    return None


def rim(k: Complex) -> Complex:
    """The boundary of a pure complex, `simplicial.boundary`; closed if it is that of a manifold.

    Clauses: CPLX-COMPLEX-5, CPLX-MANIFOLD-9.
    """
    return closure(wall for wall, sides in walls(k).items() if len(sides) == 1)


def vertex_links(k: Complex) -> Iterator[tuple[int, Complex]]:
    """Each vertex of a pure complex with its link, in increasing order. Clause: CPLX-COMPLEX-4."""
    around: dict[int, list[Simplex]] = {v: [] for (v,) in of_dimension(k, 0)}
    for simplex in of_dimension(k, dimension(k)):
        for v in simplex:
            around[v].append(simplex - {v})
    return ((v, closure(outer)) for v, outer in around.items())


def components(k: Complex) -> tuple[Complex, ...]:
    """The connected components, by their lowest vertices, `simplicial.pieces`. CPLX-COMPLEX-6."""
    beside: dict[int, list[int]] = {v: [] for (v,) in of_dimension(k, 0)}
    for v, w in of_dimension(k, 1):
        beside[v].append(w)
        beside[w].append(v)
    lowest: dict[int, int] = {}
    for start in beside:
        stack = [start]
        while stack:
            v = stack.pop()
            if v not in lowest:
                lowest[v] = start
                stack += beside[v]
    parts: dict[int, list[Simplex]] = {start: [] for start in lowest.values()}
    for simplex in k.simplices:
        parts[lowest[min(simplex)]].append(simplex)
    return tuple(Complex(frozenset(part)) for part in parts.values())
