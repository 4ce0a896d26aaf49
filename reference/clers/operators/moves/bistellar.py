"""Bistellar moves (Pachner flips): A * ∂B becomes ∂A * B.

On surfaces: A a triangle and B a vertex puts a vertex into a face; A and B edges is the edge flip;
A a vertex and B a triangle takes a vertex of degree three out again.
In each dimension it is a subdivision and a weld in one. OPER-BISTELLAR-2, OPER-BISTELLAR-3.
"""

from clers.complexes.simplicial import Complex, star
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSimplex
from clers.operators.moves.augmented import around, first_of, in_order, joined, proper_faces
from clers.operators.moves.move import Bistellar
from clers.operators.moves.operand import bad_operand, missing, present


def bistellar(k: Complex, move: Bistellar) -> Accepted[Complex] | Rejected:
    """A goes and B comes, where the link of A is ∂B and B is new. Clause: OPER-BISTELLAR-1.

    Blamed for a wrong link: the least simplex that is in it, or in ∂B, and not in the other.
    """
    a, b = frozenset(move.gone), frozenset(move.come)
    fault = (
        bad_operand(move.gone, move.come)
        or missing(k, [a], Clause.OPER_BISTELLAR_1)
        or present(k, b, Clause.OPER_BISTELLAR_1)
    )
    if fault is not None:
        return fault
    odd = first_of(around(k, a) ^ proper_faces(b))
    if odd is not None:
        return Rejected(Reason.WRONG_LINK, Clause.OPER_BISTELLAR_1, AtSimplex(in_order(odd)))
    return Accepted(Complex(k.simplices - star(k, a) | joined([b], proper_faces(a))))
