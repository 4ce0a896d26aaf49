"""The vertex split: a contraction backwards.

D is the part of the vertex's link that moves to the new vertex, L the part of D that the old one
keeps as well. Then D is what the new vertex's link has beside the old vertex, and L the link of the
new edge.
"""

from clers.complexes.simplicial import Complex, Simplex, closure
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtSimplex
from clers.operators.moves.augmented import (
    EMPTY,
    Augmented,
    around,
    first_of,
    in_order,
    joined,
    proper_faces,
)
from clers.operators.moves.contract import contract, shared_and_moved
from clers.operators.moves.move import Contract, Split, Vertices
from clers.operators.moves.operand import bad_operand, missing, present


def split(k: Complex, move: Split) -> Accepted[Complex] | Rejected:
    """Two vertices and an edge for one vertex. Clauses: OPER-CONTRACT-4 … OPER-CONTRACT-6."""
    a, b = frozenset([move.vertex]), frozenset([move.new])
    moved, shared = spanned(move.moved), spanned(move.shared)
    fault = (
        bad_operand((move.vertex,), (move.new,), *move.moved, *move.shared)
        or _around_itself(move)
        or missing(k, joined([a], moved), Clause.OPER_CONTRACT_4)
        or present(k, b, Clause.OPER_CONTRACT_4)
        or _no_part(around(k, a), moved, shared)
    )
    if fault is not None:
        return fault
    gone = joined([a], moved - shared)
    come = joined([b], moved) | joined([a | b], shared)
    result = Complex(k.simplices - gone | come)
    back = contract(result, Contract(move.vertex, move.new))
    return back if isinstance(back, Rejected) else Accepted(result)


def spanned(simplices: tuple[Vertices, ...]) -> Augmented:
    """The closure of the simplices, and the empty simplex. Clause: OPER-CONTRACT-4."""
    return closure(simplices).simplices | {EMPTY}


def _around_itself(move: Split) -> Rejected | None:
    """Is the vertex named in its own link?"""
    if all(move.vertex not in simplex for simplex in (*move.moved, *move.shared)):
        return None
    detail = f"vertex {move.vertex} is not in its own link"
    return Rejected(Reason.BAD_OPERAND, Clause.OPER_MOVE_2, WHOLE, detail)


def _no_part(whole: Augmented, moved: Augmented, shared: Augmented) -> Rejected | None:
    """Is L no part of D, or does a simplex that stays have a face that goes?"""
    torn = frozenset(face for simplex in whole - moved for face in proper_faces(simplex))
    odd = first_of((shared - moved) | (torn & moved) - shared)
    if odd is None:
        return None
    return Rejected(Reason.WRONG_LINK, Clause.OPER_CONTRACT_4, AtSimplex(in_order(odd)))


def split_back(k: Complex, move: Contract) -> Split:
    """The split that undoes a contraction of this complex. Clause: OPER-CONTRACT-4."""
    shared, moved = shared_and_moved(k, move)
    return Split(move.keep, move.gone, spanning(moved), spanning(shared))


def spanning(simplices: frozenset[Simplex]) -> tuple[Vertices, ...]:
    """The maximal simplices, less the empty one, in order."""
    inner = {face for simplex in simplices for face in proper_faces(simplex)}
    return tuple(sorted(in_order(simplex) for simplex in simplices - inner - {EMPTY}))
