"""Polytopes known from books, written by hand; none comes from the code under test."""

from itertools import combinations, product
from typing import Final

from clers.complexes.polytopes.cells import CellList, Polytope
from clers.complexes.polytopes.construct import polytope
from clers.complexes.polytopes.order import from_complex
from clers.complexes.polytopes.polygons import PolygonList, polygon_surface
from clers.complexes.simplicial import closure
from clers.conventions.result import Accepted, Rejected


def made(answer: Accepted[Polytope] | Rejected) -> Polytope:
    """The polytope of a list that is one."""
    assert isinstance(answer, Accepted), answer
    return answer.value


def simplicial(*facets: tuple[int, ...]) -> Polytope:
    """A simplicial complex by its largest simplices."""
    return made(polytope(from_complex(closure(facets))))


def cells(vertices: int, *layers: tuple[tuple[int, ...], ...]) -> CellList:
    """A cell list with the facets as plain tuples."""
    return CellList(vertices, tuple(tuple(map(frozenset, layer)) for layer in layers))


CUBE_FACES: Final = PolygonList(
    ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)), 8
)
DODECAHEDRON_FACES: Final = PolygonList(
    (
        (4, 3, 2, 1, 0),
        *((i, (i + 1) % 5, 5 + (i + 1) % 5, 10 + i, 5 + i) for i in range(5)),
        *((10 + i, 5 + (i + 1) % 5, 10 + (i + 1) % 5, 15 + (i + 1) % 5, 15 + i) for i in range(5)),
        (15, 16, 17, 18, 19),
    ),
    20,
)
GRID_TORUS_FACES: Final = PolygonList(
    tuple(
        (3 * i + j, 3 * ((i + 1) % 3) + j, 3 * ((i + 1) % 3) + (j + 1) % 3, 3 * i + (j + 1) % 3)
        for i, j in product(range(3), range(3))
    ),
    9,
)
KLEIN_FACES: Final = (
    *((0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)),
    *((3, 4, 7, 6), (4, 5, 8, 7), (5, 3, 6, 8)),
    *((6, 7, 2, 0), (7, 8, 1, 2), (8, 6, 0, 1)),
)
"""A grid of 3 × 3 squares; the last row is glued to the first upside down: 0, 2, 1."""

CUBE: Final = made(polygon_surface(CUBE_FACES))
DODECAHEDRON: Final = made(polygon_surface(DODECAHEDRON_FACES))
GRID_TORUS: Final = made(polygon_surface(GRID_TORUS_FACES))
TETRAHEDRON: Final = simplicial((0, 1, 2), (0, 1, 3), (0, 2, 3), (1, 2, 3))
TRIANGLE: Final = simplicial((0, 1, 2))
SEVEN_TORUS: Final = simplicial(
    *((i, (i + 1) % 7, (i + 3) % 7) for i in range(7)),
    *((i, (i + 2) % 7, (i + 3) % 7) for i in range(7)),
)
"""Möbius' torus on seven vertices."""
PROJECTIVE_PLANE: Final = simplicial(
    *((0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5), (0, 1, 5)),
    *((1, 2, 4), (2, 3, 5), (1, 3, 4), (2, 4, 5), (1, 3, 5)),
)
FOUR_SIMPLEX: Final = simplicial(*combinations(range(5), 4))
CROSS_POLYTOPE: Final = simplicial(*product((0, 1), (2, 3), (4, 5), (6, 7)))
"""The boundary of the 4-dimensional one: from each of four pairs of opposite vertices, one."""
