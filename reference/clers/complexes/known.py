"""Complexes known from the literature, with facts about them: what a checker can be held against.

Each fact is from a book, from the paper that is named, or worked out by hand; none was printed by
the code that it judges.
"""

from dataclasses import dataclass, replace
from math import comb
from typing import Final

from clers.complexes.known_facets import (
    COMPLEX_PROJECTIVE_PLANE,
    DUNCE_HAT,
    KLEIN_BOTTLE,
    POINCARE_SPHERE,
    PROJECTIVE_PLANE,
    Facets,
    cross_polytope,
    disc_glued_along,
    simplex,
    sphere,
    suspension,
    torus,
)
from clers.complexes.simplicial import Complex, closure

Groups = tuple[tuple[int, tuple[int, ...]], ...]
"""Homology over Z, from dimension 0: for each the rank, and the orders of the cyclic summands."""


@dataclass(frozen=True, slots=True)
class Known:
    """A complex and what is known of it. Clause: CPLX-KNOWN-1.

    `f_vector[m]`, `gf2[m]`, `q[m]`, `z[m]` are about dimension m: the number of simplices, the
    Betti numbers over GF(2) and Q, the homology over Z. `boundary` is the f-vector of the boundary,
    None where the complex is not pure; `manifold` is with or without boundary; `orientable` is None
    where it is no manifold. `contractible` and `collapsible` mean to a point.
    """

    name: str
    facets: Facets
    f_vector: tuple[int, ...]
    gf2: tuple[int, ...]
    q: tuple[int, ...]
    z: Groups
    boundary: tuple[int, ...] | None
    manifold: bool
    orientable: bool | None
    contractible: bool = False
    collapsible: bool = False

    @property
    def complex(self) -> Complex:
        """The closure of the facets."""
        return closure(self.facets)

    @property
    def dimension(self) -> int:
        """The largest dimension of a simplex."""
        return len(self.f_vector) - 1

    @property
    def euler(self) -> int:
        """The alternating sum of the f-vector."""
        return sum(self.f_vector[::2]) - sum(self.f_vector[1::2])

    @property
    def pure(self) -> bool:
        """Is each simplex in one of the largest dimension?"""
        return self.boundary is not None


def _free(*betti: int) -> Groups:
    return tuple((b, ()) for b in betti)


def _plain(
    name: str,
    facets: Facets,
    f_vector: tuple[int, ...],
    betti: tuple[int, ...],
    boundary: tuple[int, ...] | None,
) -> Known:
    """No manifold and not contractible, without torsion."""
    return Known(name, facets, f_vector, betti, betti, _free(*betti), boundary, False, None)


def _oriented(
    name: str,
    facets: Facets,
    f_vector: tuple[int, ...],
    betti: tuple[int, ...],
    boundary: tuple[int, ...] = (),
) -> Known:
    """An orientable manifold, without torsion; closed if nothing else is said."""
    return replace(_plain(name, facets, f_vector, betti, boundary), manifold=True, orientable=True)


def _to_a_point(of: Known) -> Known:
    return replace(of, contractible=True, collapsible=True)


def _sphere(n: int) -> Known:
    """All proper faces of the (n+1)-simplex; the 0-sphere is two points."""
    counts = tuple(comb(n + 2, m + 1) for m in range(n + 1))
    betti = (2,) if n == 0 else (1, *(0,) * (n - 1), 1)
    return _oriented(f"sphere of dimension {n}", sphere(n), counts, betti)


def _ball(n: int) -> Known:
    """All faces of the n-simplex, bounded by a sphere; the 0-ball is a point without boundary."""
    counts = tuple(comb(n + 1, m + 1) for m in range(n + 1))
    boundary = tuple(comb(n + 1, m + 1) for m in range(n))
    name = f"ball of dimension {n}"
    return _to_a_point(_oriented(name, simplex(n), counts, (1, *(0,) * n), boundary))


SPHERES: Final = tuple(map(_sphere, range(5)))
BALLS: Final = tuple(map(_ball, range(5)))

OCTAHEDRON: Final = _oriented("octahedron", cross_polytope(3), (6, 12, 8), (1, 0, 1))
SIXTEEN_CELL: Final = _oriented("16-cell", cross_polytope(4), (8, 24, 32, 16), (1, 0, 0, 1))
TORUS: Final = _oriented("torus on 7 vertices", torus(2), (7, 21, 14), (1, 2, 1))
THREE_TORUS: Final = _oriented("3-torus on 15 vertices", torus(3), (15, 105, 180, 90), (1, 3, 3, 1))
ANNULUS: Final = _oriented(
    "annulus",
    ((0, 1, 3), (1, 3, 4), (1, 2, 4), (2, 4, 5), (0, 2, 5), (0, 3, 5)),
    (6, 12, 6),
    (1, 1, 0),
    (6, 6),
)
MOEBIUS_BAND: Final = replace(
    _oriented(
        "Möbius band",
        tuple((i, (i + 1) % 5, (i + 2) % 5) for i in range(5)),
        (5, 10, 5),
        (1, 1, 0),
        (5, 5),
    ),
    orientable=False,
)
PROJECTIVE: Final = Known(
    "projective plane on 6 vertices",
    PROJECTIVE_PLANE,
    (6, 15, 10),
    gf2=(1, 1, 1),
    q=(1, 0, 0),
    z=((1, ()), (0, (2,)), (0, ())),
    boundary=(),
    manifold=True,
    orientable=False,
)
KLEIN: Final = Known(
    "Klein bottle on 8 vertices",
    KLEIN_BOTTLE,
    (8, 24, 16),
    gf2=(1, 2, 1),
    q=(1, 1, 0),
    z=((1, ()), (1, (2,)), (0, ())),
    boundary=(),
    manifold=True,
    orientable=False,
)
POINCARE: Final = _oriented("Poincaré sphere", POINCARE_SPHERE, (16, 106, 180, 90), (1, 0, 0, 1))
"""The homology of a sphere, but its fundamental group has order 120."""

COMPLEX_PROJECTIVE: Final = _oriented(
    "complex projective plane on 9 vertices",
    COMPLEX_PROJECTIVE_PLANE,
    (9, 36, 84, 90, 36),
    (1, 0, 1, 0, 1),
)

DUNCE: Final = replace(
    _plain("dunce hat", DUNCE_HAT, (8, 24, 17), (1, 0, 0), ()), contractible=True
)
"""Contractible, but no collapse can begin: three edges lie in three triangles, the others in two.

For the same reason its boundary, as defined, is empty.
"""

MOORE: Final = Known(
    "disc glued along three turns of a circle",
    disc_glued_along((0, 1, 2) * 3),
    (13, 39, 27),
    gf2=(1, 0, 0),
    q=(1, 0, 0),
    z=((1, ()), (0, (3,)), (0, ())),
    boundary=(),
    manifold=False,
    orientable=None,
)
"""Its torsion of order three is seen neither over GF(2) nor over Q."""

SUSPENDED_PLANE: Final = Known(
    "suspension of the projective plane",
    suspension(PROJECTIVE_PLANE),
    (8, 27, 40, 20),
    gf2=(1, 0, 1, 1),
    q=(1, 0, 0, 0),
    z=((1, ()), (0, ()), (0, (2,)), (0, ())),
    boundary=(),
    manifold=False,
    orientable=None,
)
"""Every edge has a circle for its link, but two vertices have projective planes."""

SUSPENDED_TORUS: Final = _plain(
    "suspension of the torus", suspension(torus(2)), (9, 35, 56, 28), (1, 0, 2, 1), ()
)
PINCHED_SPHERE: Final = _plain(
    "sphere with two vertices made one",
    (
        *((0, 1, 2), (0, 2, 3), (0, 1, 3), (0, 4, 5), (0, 5, 6), (0, 4, 6)),
        *((1, 2, 4), (2, 4, 5), (2, 3, 5), (3, 5, 6), (1, 3, 6), (1, 4, 6)),
    ),
    (7, 18, 12),
    (1, 1, 1),
    (),
)
TWO_SPHERES: Final = _plain(
    "two spheres at a vertex",
    (*sphere(2), (0, 4, 5), (0, 4, 6), (0, 5, 6), (4, 5, 6)),
    (7, 12, 8),
    (1, 0, 2),
    (),
)
BOW_TIE: Final = _to_a_point(
    _plain("bow tie", ((0, 1, 2), (0, 3, 4)), (5, 6, 2), (1, 0, 0), (5, 6))
)
BOOK: Final = _to_a_point(
    _plain("book of three pages", ((0, 1, 2), (0, 1, 3), (0, 1, 4)), (5, 7, 3), (1, 0, 0), (5, 6))
)
INTERIOR_PINCH: Final = _to_a_point(
    _plain(
        "cone with a triangle at its top",
        ((0, 1, 2), (0, 2, 3), (0, 1, 3), (0, 4, 5)),
        (6, 9, 4),
        (1, 0, 0),
        (6, 6),
    )
)
FIGURE_8: Final = _to_a_point(
    _plain("Figure 8", ((0, 1, 2), (0, 2, 3), (0, 4, 5), (0, 6)), (7, 9, 3), (1, 0, 0), None)
)
"""What its caption says: a non-pure 2-complex with a non-manifold vertex."""

ONE_OF_EACH: Final = _plain(
    "tetrahedron, triangle, edge and point",
    ((0, 1, 2, 3), (3, 4, 5), (5, 6), (7,)),
    (8, 10, 5, 1),
    (2, 0, 0, 0),
    None,
)

KNOWN: Final[tuple[Known, ...]] = (
    *(*SPHERES, *BALLS, OCTAHEDRON, SIXTEEN_CELL, TORUS, THREE_TORUS, ANNULUS, MOEBIUS_BAND),
    *(PROJECTIVE, KLEIN, POINCARE, COMPLEX_PROJECTIVE),
    *(DUNCE, MOORE, SUSPENDED_PLANE, SUSPENDED_TORUS, PINCHED_SPHERE, TWO_SPHERES),
    *(BOW_TIE, BOOK, INTERIOR_PINCH, FIGURE_8, ONE_OF_EACH),
)
"""First manifolds, then others."""
