"""Cells by their incidences: a list for each dimension, each cell by its facets.

The vocabulary of chapter 3 for cells that need not be simplices. Nothing is checked here: every
function takes what `construct.polytope` accepts, and some take lists on the way there.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

Cell = tuple[int, int]
"""The dimension of a cell and its number among the cells of that dimension."""


@dataclass(frozen=True, slots=True)
class CellList:
    """Vertices 0 … vertices−1, and the m-cells as sets of (m−1)-cells: cells[m−1] for m ≥ 1.

    Clause: CPLX-CELL-1. Nothing is checked yet.
    """

    vertices: int
    cells: tuple[tuple[frozenset[int], ...], ...]


@dataclass(frozen=True, slots=True)
class Polytope(CellList):
    """A coherent cell list of dimension at most 3. Clause: CPLX-POLYTOPE-1.

    Built by `construct.polytope`, never by hand; no list of cells at its end is empty.
    """


def counts(of: CellList) -> tuple[int, ...]:
    """The numbers #0 … #n of the cells of each dimension. Clause: CPLX-CELL-1."""
    numbers = [of.vertices, *map(len, of.cells)]
    while numbers and numbers[-1] == 0:
        numbers.pop()
    return tuple(numbers)


def dimension(of: CellList) -> int:
    """The largest dimension of a cell; −1 where there is none. Clause: CPLX-CELL-1."""
    return len(counts(of)) - 1


def euler(of: CellList) -> int:
    """χ, the alternating sum of the numbers of cells. Clause: CPLX-CELL-1."""
    return sum((-1) ** m * number for m, number in enumerate(counts(of)))


def all_cells(of: CellList) -> Iterator[Cell]:
    """Every cell, by dimension and then by number."""
    return ((m, k) for m, number in enumerate(counts(of)) for k in range(number))


def of_dimension(of: CellList, m: int) -> tuple[Cell, ...]:
    """The m-cells by their numbers."""
    return tuple(cell for cell in all_cells(of) if cell[0] == m)


def facets(of: CellList, cell: Cell) -> frozenset[Cell]:
    """The facets of a cell, of one dimension less; a vertex has none. Clause: CPLX-CELL-1."""
    m, k = cell
    return frozenset((m - 1, j) for j in of.cells[m - 1][k]) if m > 0 else frozenset()


def cofacets(of: CellList) -> dict[Cell, tuple[Cell, ...]]:
    """For each cell those of which it is a facet, by their numbers. Clause: CPLX-CELL-1."""
    above: dict[Cell, list[Cell]] = {cell: [] for cell in all_cells(of)}
    for cell in all_cells(of):
        for facet in facets(of, cell):
            above[facet].append(cell)
    return {cell: tuple(found) for cell, found in above.items()}


def closure(of: CellList, cells: Iterable[Cell]) -> frozenset[Cell]:
    """The least set with these cells and, with each cell, its facets. Clause: CPLX-CELL-2."""
    found: set[Cell] = set()
    layer = set(cells)
    while layer:
        found |= layer
        layer = {facet for cell in layer for facet in facets(of, cell)} - found
    return frozenset(found)


def closures(of: CellList) -> dict[Cell, frozenset[Cell]]:
    """The closure of each cell, all at once. Clause: CPLX-CELL-2."""
    found: dict[Cell, frozenset[Cell]] = {}
    for cell in all_cells(of):
        below = (found[facet] for facet in facets(of, cell))
        found[cell] = frozenset([cell]).union(*below)
    return found


def vertices_of(of: CellList, cell: Cell) -> frozenset[int]:
    """The vertices in the closure of a cell."""
    return frozenset(k for m, k in closure(of, [cell]) if m == 0)


def star(of: CellList, cell: Cell) -> frozenset[Cell]:
    """The cells whose closure contains this one, itself among them. Clause: CPLX-CELL-2."""
    return frozenset(c for c, closed in closures(of).items() if cell in closed)


def is_pure(of: CellList) -> bool:
    """Does each cell lie in one of the largest dimension? Clause: CPLX-CELL-3."""
    return closure(of, of_dimension(of, dimension(of))) == frozenset(all_cells(of))


def boundary(of: CellList) -> frozenset[Cell]:
    """The closure of the (n−1)-cells that are facets of just one n-cell. Clause: CPLX-CELL-3."""
    n = dimension(of)
    return closure(
        of, (c for c, above in cofacets(of).items() if c[0] == n - 1 and len(above) == 1)
    )


def interior(of: CellList) -> frozenset[Cell]:
    """The cells that are not in the boundary. Clause: CPLX-CELL-3."""
    return frozenset(all_cells(of)) - boundary(of)


def components(of: CellList) -> tuple[frozenset[Cell], ...]:
    """The connected components, by their lowest vertices. Clause: CPLX-CELL-3."""
    above = cofacets(of)
    done: set[Cell] = set()
    found: list[frozenset[Cell]] = []
    for first in of_dimension(of, 0):
        if first not in done:
            piece, stack = {first}, [first]
            while stack:
                cell = stack.pop()
                fresh = facets(of, cell).union(above[cell]) - piece
                piece |= fresh
                stack.extend(fresh)
            done |= piece
            found.append(frozenset(piece))
    return tuple(found)


def restricted(of: CellList, cells: Iterable[Cell]) -> CellList:
    """A closed set of cells as a cell list of its own, in the same order. Clause: CPLX-CELL-1."""
    return _renumbered(of, sorted(cells), 0)


def figure(of: CellList, cell: Cell) -> CellList:
    """The cells around one cell, of which it is a face. Clause: CPLX-CELL-4."""
    return _renumbered(of, sorted(star(of, cell) - {cell}), cell[0] + 1)


def _renumbered(of: CellList, cells: list[Cell], lowest: int) -> CellList:
    """Some cells with new numbers, those of dimension `lowest` as vertices."""
    layers: list[list[Cell]] = []
    for cell in cells:
        while len(layers) <= cell[0] - lowest:
            layers.append([])
        layers[cell[0] - lowest].append(cell)
    number = {cell: k for layer in layers for k, cell in enumerate(layer)}
    upper = tuple(
        tuple(frozenset(number[f] for f in facets(of, c) if f in number) for c in layer)
        for layer in layers[1:]
    )
    return CellList(len(layers[0]) if layers else 0, upper)
