"""What a polytope is, by definition: frontiers are circles and spheres, intersections are cells.

It shares nothing with `construct` but the words of `cells`: frontiers are judged as simplicial
complexes, by chapter 3's own definition of surfaces.
"""

from itertools import combinations

from clers.complexes.definition import is_surface
from clers.complexes.polytopes.cells import (
    Cell,
    CellList,
    all_cells,
    closures,
    counts,
    facets,
    restricted,
)
from clers.complexes.polytopes.order import order_complex
from clers.complexes.simplicial import Complex, boundary, euler, is_circle, pieces


def is_polytope(given: CellList) -> bool:
    """Is this coherent, with frontiers as cells have them? Clause: CPLX-POLYTOPE-8."""
    return _is_listed(given) and _has_frontiers(given) and _is_coherent(given)


def _is_listed(given: CellList) -> bool:
    """All facets are there, and no cell is too large."""
    numbers = (given.vertices, *map(len, given.cells))
    return (
        given.vertices >= 0
        and len(counts(given)) <= 4
        and all(
            set(cell) <= set(range(below))
            for below, layer in zip(numbers, given.cells, strict=False)
            for cell in layer
        )
    )


def _has_frontiers(given: CellList) -> bool:
    for cell, closed in closures(given).items():
        around = order_complex(restricted(given, closed - {cell}))
        match cell[0]:
            case 0:
                good = True
            case 1:
                good = len(facets(given, cell)) == 2
            case 2:
                good = is_circle(around)
            case _:
                good = _is_sphere(around)
        if not good:
            return False
    return True


def _is_sphere(k: Complex) -> bool:
    closed = is_surface(k) and not boundary(k).simplices
    return closed and len(pieces(k)) == 1 and euler(k) == 2


def _is_coherent(given: CellList) -> bool:
    closed = closures(given)
    pairs: combinations[tuple[Cell, Cell]] = combinations(all_cells(given), 2)
    return all(
        not common or any(closed[c] == common for c in common)
        for a, b in pairs
        for common in [closed[a] & closed[b]]
    )
