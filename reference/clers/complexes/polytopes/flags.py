"""Flags, and orientability by colouring them."""

from clers.complexes.parity import Parity
from clers.complexes.polytopes.cells import Cell, CellList, cofacets, dimension, of_dimension

Flag = tuple[Cell, ...]
"""A cell of each dimension 0 … n, each a facet of the next. Clause: CPLX-POLYMANIFOLD-3."""


def flags(of: CellList) -> tuple[Flag, ...]:
    """Every flag of a polytope, in lexicographic order. Clause: CPLX-POLYMANIFOLD-3."""
    above = cofacets(of)
    found: list[Flag] = [(vertex,) for vertex in of_dimension(of, 0)]
    for _ in range(dimension(of)):
        found = [(*flag, cell) for flag in found for cell in above[flag[-1]]]
    return tuple(found)


def is_orientable(of: CellList) -> bool:
    """Can the flags have two colours, adjacent ones different? Clause: CPLX-POLYMANIFOLD-3.

    By homology instead: CPLX-POLYMANIFOLD-4.
    """
    every = flags(of)
    sets = Parity(len(every))
    first: dict[tuple[int, Flag], int] = {}
    for i, flag in enumerate(every):
        for m in range(len(flag)):
            rest = (m, flag[:m] + flag[m + 1 :])
            other = first.setdefault(rest, i)
            if other != i and not sets.unite(other, i, differ=True):
                return False
    return True
