"""Complexes by their facets: how they are written, and how such a list is read."""

from collections.abc import Sequence
from typing import Final

from clers.complexes.simplicial import Complex, Simplex, closure, dimension, of_dimension
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtFace

Row = tuple[int, ...]
"""The vertices of a simplex; in what is answered, in increasing order."""

MOST_VERTICES: Final = 16
"""The longest row that is read: a simplex of n vertices has 2^n − 1 faces. Clause: CPLX-FACET-3."""


def row(simplex: Simplex) -> Row:
    """The vertices in increasing order."""
    return tuple(sorted(simplex))


def facets(k: Complex) -> tuple[Row, ...]:
    """The simplices that are proper faces of none, in lexicographic order.

    Linear in the sizes of the simplices, but for sorting: a simplex of a complex is a proper face
    of one of them exactly if it is one of them without a vertex. Clause: CPLX-FACET-2.
    """
    covered = {simplex - {v} for simplex in k.simplices for v in simplex}
    return tuple(sorted(map(row, k.simplices - covered)))


def top_simplices(k: Complex) -> tuple[Simplex, ...]:
    """The simplices of largest dimension: the tutorial's maximal faces. Clause: CPLX-FACET-2."""
    return of_dimension(k, dimension(k))


def from_facets(rows: Sequence[Sequence[int]]) -> Accepted[Complex] | Rejected:
    """The closure of the simplices that the rows name. Clause: CPLX-FACET-3.

    Rejects `too-many-vertices`, `empty-simplex`, `index-out-of-range` (negative), `repeated-index`,
    at the row. Without rows the complex is empty. Clause: CPLX-FACET-1.
    """
    for i, vertices in enumerate(rows):
        if len(vertices) > MOST_VERTICES:
            return Rejected(Reason.TOO_MANY_VERTICES, Clause.CPLX_FACET_3, AtFace(i))
        if not vertices:
            return Rejected(Reason.EMPTY_SIMPLEX, Clause.CPLX_FACET_3, AtFace(i))
        if min(vertices) < 0:
            return Rejected(Reason.INDEX_OUT_OF_RANGE, Clause.CPLX_FACET_3, AtFace(i))
        if len(set(vertices)) < len(vertices):
            return Rejected(Reason.REPEATED_INDEX, Clause.CPLX_FACET_3, AtFace(i))
    return Accepted(closure(rows))
