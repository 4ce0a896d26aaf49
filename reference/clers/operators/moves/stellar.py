"""Stellar subdivision and its inverse, the weld. A is a simplex, L its link.

Between A * L and v * ∂A * L: two balls with one boundary, so that nothing outside notices.
Contracting v into a vertex of A undoes a subdivision too. Clause: OPER-STELLAR-3.
"""

from clers.complexes.simplicial import Complex, star
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSimplex
from clers.operators.moves.augmented import around, first_of, in_order, joined, proper_faces
from clers.operators.moves.move import Subdivide, Weld
from clers.operators.moves.operand import bad_operand, missing, present


def subdivide(k: Complex, move: Subdivide) -> Accepted[Complex] | Rejected:
    """The open star of A becomes the open star of a new vertex. Clause: OPER-STELLAR-1."""
    a, v = frozenset(move.simplex), frozenset([move.vertex])
    fault = (
        bad_operand(move.simplex, (move.vertex,))
        or missing(k, [a], Clause.OPER_STELLAR_1)
        or present(k, v, Clause.OPER_STELLAR_1)
    )
    if fault is not None:
        return fault
    new = joined([v], joined(proper_faces(a), around(k, a)))
    return Accepted(Complex(k.simplices - star(k, a) | new))


def weld(k: Complex, move: Weld) -> Accepted[Complex] | Rejected:
    """A vertex whose link is ∂A * L goes; A comes with the link L. Clause: OPER-STELLAR-2.

    Blamed for a wrong link: the least simplex that is in it, or in ∂A * L, and not in the other.
    """
    a, v = frozenset(move.simplex), frozenset([move.vertex])
    fault = (
        bad_operand(move.simplex, (move.vertex,))
        or missing(k, [v], Clause.OPER_STELLAR_2)
        or present(k, a, Clause.OPER_STELLAR_2)
    )
    if fault is not None:
        return fault
    found = around(k, v)
    rest = frozenset(simplex for simplex in found if not simplex & a)
    odd = first_of(found ^ joined(proper_faces(a), rest))
    if odd is not None:
        return Rejected(Reason.WRONG_LINK, Clause.OPER_STELLAR_2, AtSimplex(in_order(odd)))
    return Accepted(Complex(k.simplices - star(k, v) | joined([a], rest)))
