"""Parts of complexes, and complexes put together by joins."""

from clers.complexes.simplicial import Complex, dimension, of_dimension
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtVertex


def is_subcomplex(part: Complex, whole: Complex) -> bool:
    """Are all simplices of the first in the second? Clause: CPLX-PART-1."""
    return part.simplices <= whole.simplices


def skeleton(m: int, k: Complex) -> Complex:
    """The simplices of dimension at most m. Clause: CPLX-PART-1."""
    return Complex(frozenset(s for s in k.simplices if len(s) <= m + 1))


def f_vector(k: Complex) -> tuple[int, ...]:
    """#_0 … #_n, the numbers of simplices of each dimension. Clause: CPLX-PART-2."""
    return tuple(len(of_dimension(k, m)) for m in range(dimension(k) + 1))


def join(one: Complex, other: Complex) -> Accepted[Complex] | Rejected:
    """Both, and all joins of a simplex of one with one of the other. Clause: CPLX-JOIN-1.

    Rejects `shared-vertex`, at the lowest vertex that is in both. What becomes of f-vectors, χ and
    homology: CPLX-JOIN-2, CPLX-JOIN-3.
    """
    shared = frozenset().union(*one.simplices) & frozenset().union(*other.simplices)
    if shared:
        return Rejected(Reason.SHARED_VERTEX, Clause.CPLX_JOIN_1, AtVertex(min(shared)))
    joins = frozenset(s | t for s in one.simplices for t in other.simplices)
    return Accepted(Complex(one.simplices | other.simplices | joins))
