"""The connected sum: an n-simplex is taken out of each of two complexes, the holes are glued."""

from dataclasses import dataclass

from clers.complexes.manifolds.incidence import rim
from clers.complexes.simplicial import Complex, Simplex, dimension
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtPair, AtSimplex


@dataclass(frozen=True, slots=True)
class Summand:
    """A complex and one of its n-simplices, its vertices in the order of the gluing. CPLX-SUM-1."""

    complex: Complex
    at: tuple[int, ...]


def connected_sum(first: Summand, second: Summand) -> Accepted[Complex] | Rejected:
    """Take both simplices out and identify their vertices, the i-th with the i-th.

    The vertices of the first keep their names; the others of the second are numbered on from the
    highest of the first, in their order. Linear. Clauses: CPLX-SUM-1, CPLX-SUM-3.
    """
    n = dimension(first.complex)
    for summand in (first, second):
        if not _is_facet(summand, n):
            return _refused(AtSimplex(tuple(sorted(summand.at))), f"not an n-simplex, n = {n}")
    if _at_rim(first) and _at_rim(second):
        pair = AtPair(tuple(sorted(first.at)), tuple(sorted(second.at)))
        return _refused(pair, "both on the boundary")
    place = dict(zip(second.at, first.at, strict=True))
    free = 1 + max(set().union(*first.complex.simplices))
    others = sorted(set().union(*second.complex.simplices) - set(second.at))
    place |= {v: free + i for i, v in enumerate(others)}
    moved = (frozenset(place[v] for v in s) for s in second.complex.simplices)
    hole = frozenset(first.at)
    return Accepted(Complex((first.complex.simplices | frozenset(moved)) - {hole}))


def _refused(where: AtSimplex | AtPair, detail: str) -> Rejected:
    return Rejected(Reason.OPERATOR_NOT_APPLICABLE, Clause.CPLX_SUM_3, where, detail)


def _is_facet(summand: Summand, n: int) -> bool:
    simplex: Simplex = frozenset(summand.at)
    return len(simplex) == len(summand.at) == n + 1 and simplex in summand.complex.simplices


def _at_rim(summand: Summand) -> bool:
    border = set[int]().union(*rim(summand.complex).simplices)
    return not border.isdisjoint(summand.at)
