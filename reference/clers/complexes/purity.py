"""Purity with its witness, and what only pure complexes have: boundary and interior."""

from clers.complexes.facets import facets
from clers.complexes.simplicial import Complex, Simplex, boundary, dimension
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSimplex


def impure_at(k: Complex) -> Simplex | None:
    """The first facet below the largest dimension; None where the complex is pure.

    Clauses: CPLX-PURE-1, CPLX-PURE-2.
    """
    size = dimension(k) + 1
    return next((frozenset(facet) for facet in facets(k) if len(facet) < size), None)


def pure_boundary(k: Complex) -> Accepted[Complex] | Rejected:
    """The boundary, or `not-pure` at the first low facet. Clauses: CPLX-PURE-2, CPLX-PURE-4."""
    witness = impure_at(k)
    if witness is not None:
        where = AtSimplex(tuple(sorted(witness)))
        return Rejected(Reason.NOT_PURE, Clause.CPLX_PURE_2, where)
    return Accepted(boundary(k))


def interior(k: Complex) -> Accepted[frozenset[Simplex]] | Rejected:
    """The simplices that are not in the boundary. Clause: CPLX-PURE-3."""
    rim = pure_boundary(k)
    return rim if isinstance(rim, Rejected) else Accepted(k.simplices - rim.value.simplices)
