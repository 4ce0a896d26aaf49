"""Polytopes made of others: products, skeleta, polygons, simplices and their kind."""

from itertools import chain, product
from typing import Final

from clers.complexes.polytopes.cells import Cell, CellList, all_cells, dimension, facets

POINT: Final = CellList(1, ())
SEGMENT: Final = CellList(2, ((frozenset([0, 1]),),))


def circle(edges: int) -> CellList:
    """A cycle of edges, edge k from vertex k to the next."""
    return CellList(edges, (tuple(frozenset([k, (k + 1) % edges]) for k in range(edges)),))


def polygon(edges: int) -> CellList:
    """One polygon and its frontier."""
    return CellList(edges, (*circle(edges).cells, (frozenset(range(edges)),)))


def skeleton(of: CellList, m: int) -> CellList:
    """The cells of dimension at most m."""
    return CellList(of.vertices, of.cells[:m])


def times(a: CellList, b: CellList) -> CellList:
    """The product: a cell for each pair of cells, of the sum of their dimensions.

    In each dimension the pairs are listed by the first cell and then by the second. The product of
    polytopes with cells up to dimension 3 in all is a polytope. Clause: CPLX-POLYTOPE-12.
    """
    layers: list[list[tuple[Cell, Cell]]] = [[] for _ in range(dimension(a) + dimension(b) + 1)]
    for c, d in product(all_cells(a), all_cells(b)):
        layers[c[0] + d[0]].append((c, d))
    number = {pair: k for layer in layers for k, pair in enumerate(layer)}
    upper = tuple(
        tuple(
            frozenset(
                number[pair]
                for pair in chain(((f, d) for f in facets(a, c)), ((c, f) for f in facets(b, d)))
            )
            for c, d in layer
        )
        for layer in layers[1:]
    )
    return CellList(len(layers[0]) if layers else 0, upper)


def cube(n: int) -> CellList:
    """The n-cube: a product of n segments. Clause: CPLX-POLYTOPE-12."""
    made = POINT
    for _ in range(n):
        made = times(made, SEGMENT)
    return made
