"""From a cell list to a polytope, or to the first fault by the order of CPLX-POLYTOPE."""

from collections import defaultdict
from collections.abc import Collection, Iterable
from typing import Final

from clers.complexes.parity import Parity
from clers.complexes.polytopes.cells import (
    Cell,
    CellList,
    Polytope,
    all_cells,
    closures,
    counts,
    facets,
    of_dimension,
)
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtCell

LARGEST: Final = 3
"""The largest dimension of a cell. Clause: CPLX-POLYTOPE-3."""


def polytope(given: CellList) -> Accepted[Polytope] | Rejected:
    """The polytope that a cell list describes, cells keeping their numbers. CPLX-POLYTOPE-1.

    Linear in incidences, but for coherence: that takes as long as there are pairs of cells with a
    vertex in common.
    """
    fault = _bad_indices(given) or _bad_frontiers(given) or _incoherent(given)
    if fault is not None:
        return fault
    kept = len(counts(given)) - 1
    return Accepted(Polytope(given.vertices, given.cells[: max(kept, 0)]))


def _bad_indices(given: CellList) -> Rejected | None:
    """Clauses: CPLX-POLYTOPE-2, CPLX-POLYTOPE-3."""
    if given.vertices < 0:
        return Rejected(Reason.IMPOSSIBLE_COUNT, Clause.CPLX_POLYTOPE_2)
    below = given.vertices
    for m, layer in enumerate(given.cells, 1):
        for k, cell in enumerate(layer):
            if not all(0 <= facet < below for facet in cell):
                return Rejected(Reason.INDEX_OUT_OF_RANGE, Clause.CPLX_POLYTOPE_2, AtCell(m, k))
        below = len(layer)
    if len(counts(given)) > LARGEST + 1:
        where = AtCell(LARGEST + 1, 0)
        return Rejected(Reason.UNSUPPORTED_DIMENSION, Clause.CPLX_POLYTOPE_3, where)
    return None


def _bad_frontiers(given: CellList) -> Rejected | None:
    """Clauses: CPLX-POLYTOPE-4, CPLX-POLYTOPE-5, CPLX-POLYTOPE-6."""
    for m, clause, is_good in (
        (1, Clause.CPLX_POLYTOPE_4, _has_two_ends),
        (2, Clause.CPLX_POLYTOPE_5, _is_cycle),
        (3, Clause.CPLX_POLYTOPE_6, _is_sphere),
    ):
        for _, k in of_dimension(given, m):
            if not is_good(given, facets(given, (m, k))):
                return Rejected(Reason.BAD_FRONTIER, clause, AtCell(m, k))
    return None


def _has_two_ends(given: CellList, ends: frozenset[Cell]) -> bool:
    return len(ends) == 2


def _is_cycle(given: CellList, edges: frozenset[Cell]) -> bool:
    """Two of the edges at each vertex, at least three, and all hang together."""
    at = _by_facet(given, edges)
    twice = all(len(pair) == 2 for pair in at.values())
    return twice and len(edges) >= 3 and _hang_together(edges, at.values())


def _is_sphere(given: CellList, polygons: frozenset[Cell]) -> bool:
    """Two of the polygons at each edge, all hang together, and χ = 2: CPLX-POLYTOPE-6."""
    at = _by_facet(given, polygons)
    twice = all(len(pair) == 2 for pair in at.values())
    vertices = {end for edge in at for end in facets(given, edge)}
    chi = len(vertices) - len(at) + len(polygons)
    return twice and chi == 2 and _hang_together(polygons, at.values())


def _by_facet(given: CellList, cells: Iterable[Cell]) -> dict[Cell, list[Cell]]:
    at: defaultdict[Cell, list[Cell]] = defaultdict(list)
    for cell in cells:
        for facet in facets(given, cell):
            at[facet].append(cell)
    return at


def _hang_together(cells: Collection[Cell], joined: Iterable[list[Cell]]) -> bool:
    number = {cell: i for i, cell in enumerate(cells)}
    sets = Parity(len(cells))
    for first, *others in joined:
        for other in others:
            sets.unite(number[first], number[other], differ=False)
    return len({sets.find(i)[0] for i in range(len(cells))}) == 1


def _incoherent(given: CellList) -> Rejected | None:
    """What two cells share are the vertices of a cell in both closures. Clause: CPLX-POLYTOPE-7."""
    closed = closures(given)
    corners = {c: frozenset(k for m, k in whole if m == 0) for c, whole in closed.items()}
    at: defaultdict[int, list[Cell]] = defaultdict(list)
    for cell in all_cells(given):
        earlier = {other for v in corners[cell] for other in at[v]}
        for other in sorted(earlier):
            shared = corners[cell] & corners[other]
            common = closed[cell] & closed[other]
            if len(shared) > 1 and all(corners[c] != shared for c in common):
                detail = f"with {other[0]}-cell {other[1]}"
                where = AtCell(*cell)
                return Rejected(Reason.INCOHERENT_CELLS, Clause.CPLX_POLYTOPE_7, where, detail)
        for v in corners[cell]:
            at[v].append(cell)
    return None
