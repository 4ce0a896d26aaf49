"""Between polytopes and simplicial complexes: chains of cells, and simplices as cells."""

from clers.complexes.polytopes.cells import (
    Cell,
    CellList,
    Polytope,
    all_cells,
    closures,
    vertices_of,
)
from clers.complexes.simplicial import Complex, dimension
from clers.complexes.simplicial import of_dimension as simplices_of_dimension


def order_complex(of: CellList) -> Complex:
    """The barycentric subdivision: a vertex for each cell, a simplex for each chain of them.

    The vertices are numbered as `all_cells` lists the cells. Clauses: CPLX-POLYTOPE-9,
    CPLX-POLYTOPE-11.
    """
    number = {cell: i for i, cell in enumerate(all_cells(of))}
    chains: dict[Cell, list[frozenset[int]]] = {}
    for cell, closed in closures(of).items():
        top = frozenset([number[cell]])
        lower = (chain for face in closed if face != cell for chain in chains[face])
        chains[cell] = [top, *(chain | top for chain in lower)]
    return Complex(frozenset(chain for ending in chains.values() for chain in ending))


def from_complex(k: Complex) -> CellList:
    """The simplices as cells, in lexicographic order in each dimension. Clause: CPLX-POLYTOPE-10.

    Vertex number i of the cell list is the i-th lowest vertex of the complex.
    """
    layers = [simplices_of_dimension(k, m) for m in range(dimension(k) + 1)]
    number = {simplex: i for layer in layers for i, simplex in enumerate(layer)}
    upper = tuple(
        tuple(frozenset(number[simplex - {v}] for v in simplex) for simplex in layer)
        for layer in layers[1:]
    )
    return CellList(len(layers[0]) if layers else 0, upper)


def to_complex(of: Polytope) -> Complex | None:
    """The simplicial complex that a polytope is, if its cells are simplices: CPLX-POLYTOPE-10."""
    simplices = {cell: vertices_of(of, cell) for cell in all_cells(of)}
    if any(len(simplex) != m + 1 for (m, _), simplex in simplices.items()):
        return None
    return Complex(frozenset(simplices.values()))
