"""Facets of complexes that need a table or a rule: mathematical data, from where is said at each.

All are checked by what they must be: f-vector, links, homology, fundamental group.
"""

from itertools import combinations, permutations
from typing import Final

Facets = tuple[tuple[int, ...], ...]


def simplex(n: int) -> Facets:
    """The one facet of the n-ball: all of 0 … n."""
    return (tuple(range(n + 1)),)


def sphere(n: int) -> Facets:
    """The n-sphere as the boundary of a simplex: all but one of 0 … n+1."""
    return tuple(combinations(range(n + 2), n + 1))


def cross_polytope(n: int) -> Facets:
    """The (n−1)-sphere with one of 2i, 2i+1 for each i below n: the octahedron for n = 3."""
    words = [tuple(2 * i + (word >> i & 1) for i in range(n)) for word in range(1 << n)]
    return tuple(words)


def torus(n: int) -> Facets:
    """The n-torus on N = 2^(n+1) − 1 vertices, invariant under i ↦ i + 1 modulo N.

    A facet holds the partial sums, from any start, of 1, 2, 4, … 2^n in some order, their whole sum
    being N. W. Kühnel and G. Lassmann, Combinatorial d-tori with a large symmetry group (1988);
    for n = 2 it is Möbius' torus, on seven vertices.
    """
    count = (1 << n + 1) - 1
    facets = set[tuple[int, ...]]()
    for steps in permutations([1 << i for i in range(n + 1)]):
        for start in range(count):
            sums = [(start + sum(steps[:i])) % count for i in range(n + 1)]
            facets.add(tuple(sorted(sums)))
    return tuple(sorted(facets))


def suspension(of: Facets) -> Facets:
    """Two new vertices, each joined to every facet: the double cone."""
    top = max(v for facet in of for v in facet) + 1
    return tuple((*facet, v) for v in (top, top + 1) for facet in of)


def disc_glued_along(word: tuple[int, ...]) -> Facets:
    """A polygon, its i-th vertex word[i], with a ring of vertices inside and one in the middle.

    Sides with the same ends are glued; the ring keeps everything else apart.
    """
    size, low = len(word), max(word) + 1
    ring = range(low, low + size)
    facets: list[tuple[int, ...]] = []
    for i in range(size):
        j = (i + 1) % size
        facets += [
            (word[i], word[j], ring[i]),
            (word[j], ring[i], ring[j]),
            (ring[i], ring[j], low + size),
        ]
    return tuple(facets)


def _read(table: str) -> Facets:
    """Facets as words of digits, A for 10 and so on."""
    return tuple(tuple(int(digit, 36) for digit in word) for word in table.split())


PROJECTIVE_PLANE: Final = _read("012 023 034 045 015 124 235 134 245 135")
"""Half of the icosahedron, opposite vertices made one: six vertices, each two joined."""

KLEIN_BOTTLE: Final = _read("""
    012 015 024 036 037 046 057 126 135 137 146 147 235 236 245 457
""")
"""One of the six Klein bottles on eight vertices, the fewest possible."""

DUNCE_HAT: Final = _read("""
    013 016 017 023 024 025 045 067 124 126 127 134 237 256 345 357 567
""")
"""A triangle with its three sides made one, two run forwards and one backwards: 0 → 1 → 2 → 0.

E. C. Zeeman, On the dunce hat (1964); eight vertices are the fewest possible.
"""

POINCARE_SPHERE: Final = _read("""
    0138 013E 015D 015E 018D 023B 023E 0269 026B 029E 038B 045C 045D 047A 047C 04AD 05CE 0679
    067A 06AB 079C 08AB 08AD 09CE 1249 124A 1269 126C 12AC 138C 13AC 13AE 147A 147B 149B 159B
    159D 15BE 168C 168D 169D 17AE 17BE 234D 234E 23BD 249E 24AD 26BC 2ACD 2BCD 3456 345D 346E
    356A 359A 359D 36AE 378B 378C 379C 379D 37BD 39AC 456C 468C 468E 478B 478C 489B 489E 56AB
    56BC 59AB 5BCE 679D 67AE 67DE 68DE 7BDE 89AB 89AF 89EF 8ADF 8DEF 9ACF 9CEF ACDF BCDE CDEF
""")
"""Poincaré's homology sphere on sixteen vertices.

A. Björner and F. H. Lutz, Simplicial manifolds, bistellar flips and a 16-vertex triangulation of
the Poincaré homology 3-sphere (2000).
"""

COMPLEX_PROJECTIVE_PLANE: Final = _read("""
    01267 01268 01278 01345 01348 01356 01368 01457 01478 01567 02345 02346 02357 02367 02458
    02468 02578 03468 03567 04578 12345 12347 12358 12378 12456 12467 12568 13478 13568 14567
    23467 23578 24568 34678 35678 45678
""")
"""The complex projective plane on nine vertices, the fewest possible.

W. Kühnel and T. F. Banchoff, The 9-vertex complex projective plane (1983).
"""
