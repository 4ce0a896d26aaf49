"""Duals of closed manifolds, and the two graphs."""

from clers.complexes.polytopes.cells import (
    CellList,
    Polytope,
    cofacets,
    dimension,
    facets,
    of_dimension,
)
from clers.complexes.polytopes.construct import polytope
from clers.complexes.polytopes.manifold import first_singular
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtCell

Graph = tuple[tuple[int, int], ...]
"""Links as pairs of node numbers, the smaller first. Clause: CPLX-GRAPH-1."""


def dual(of: Polytope) -> Accepted[Polytope] | Rejected:
    """Incidences reversed; or why a manifold without boundary was asked for. CPLX-DUAL-1.

    What it is like: CPLX-DUAL-2, CPLX-DUAL-3, CPLX-DUAL-4.
    """
    singular = first_singular(of)
    if singular is not None:
        return Rejected(Reason.NOT_A_MANIFOLD, Clause.CPLX_DUAL_1, AtCell(*singular))
    n = dimension(of)
    above = cofacets(of)
    for wall in of_dimension(of, n - 1):
        if len(above[wall]) == 1:
            return Rejected(Reason.HAS_BOUNDARY, Clause.CPLX_DUAL_1, AtCell(*wall))
    return polytope(reversed_incidences(of))


def reversed_incidences(of: CellList) -> CellList:
    """An m-cell for each (n−m)-cell, whatever that may be. Clause: CPLX-DUAL-1."""
    n = dimension(of)
    above = cofacets(of)
    layers = tuple(
        tuple(frozenset(k for _, k in above[cell]) for cell in of_dimension(of, n - m))
        for m in range(1, n + 1)
    )
    return CellList(len(of_dimension(of, n)), layers)


def primal_graph(of: CellList) -> Graph:
    """The vertices, joined by edges: the 1-skeleton. Clause: CPLX-GRAPH-1."""
    return tuple(_link([k for _, k in facets(of, edge)]) for edge in of_dimension(of, 1))


def dual_graph(of: CellList) -> Graph:
    """The n-cells, joined across the (n−1)-cells that are facets of two.

    Clauses: CPLX-GRAPH-1, CPLX-GRAPH-2; of triangles: CPLX-GRAPH-3.
    """
    above = cofacets(of)
    walls = (above[wall] for wall in of_dimension(of, dimension(of) - 1))
    return tuple(_link([k for _, k in both]) for both in walls if len(both) == 2)


def _link(ends: list[int]) -> tuple[int, int]:
    return min(ends), max(ends)
