"""Simplicial collapse and expansion in any dimension. Clause: OPER-COLLAPSE-4.

Collapse(free, coface): the open star of the free simplex, which is it and its coface, goes.
"""

from clers.complexes.simplicial import Complex, Simplex, star
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtSimplex
from clers.operators.moves.augmented import EMPTY, first_of, in_order, proper_faces
from clers.operators.moves.move import Collapse, Expand
from clers.operators.moves.operand import bad_operand, missing, present


def collapse(k: Complex, move: Collapse) -> Accepted[Complex] | Rejected:
    """Remove a free simplex with its coface. Clauses: OPER-COLLAPSE-1, OPER-COLLAPSE-2.

    A third simplex that contains the free one, if there is any, is blamed: least first.
    """
    pair = frozenset(move.free), frozenset(move.coface)
    fault = (
        bad_operand(move.free, move.coface)
        or _no_pair(move)
        or missing(k, pair, Clause.OPER_COLLAPSE_1)
    )
    if fault is not None:
        return fault
    other = first_of(star(k, pair[0]) - set(pair))
    if other is not None:
        where = AtSimplex(in_order(other))
        return Rejected(Reason.NOT_FREE, Clause.OPER_COLLAPSE_1, where)
    return Accepted(Complex(k.simplices - set(pair)))


def expand(k: Complex, move: Expand) -> Accepted[Complex] | Rejected:
    """Add a simplex and its only coface. Clause: OPER-COLLAPSE-3."""
    free, coface = frozenset(move.free), frozenset(move.coface)
    fault = bad_operand(move.free, move.coface) or _no_pair(move)
    if fault is not None:
        return fault
    rest = proper_faces(coface) - {EMPTY, free}
    blamed = missing(k, rest, Clause.OPER_COLLAPSE_3) or present(k, free, Clause.OPER_COLLAPSE_3)
    return blamed or Accepted(Complex(k.simplices | {free, coface}))


def _no_pair(move: Collapse | Expand) -> Rejected | None:
    """Is the coface not the free simplex and one vertex more?"""
    extra = set(move.coface) - set(move.free)
    if len(extra) == 1 and len(move.coface) == len(move.free) + 1:
        return None
    detail = f"{move.coface} is not {move.free} and one vertex more"
    return Rejected(Reason.BAD_OPERAND, Clause.OPER_MOVE_2, WHOLE, detail)


def free_pairs(k: Complex) -> tuple[tuple[Simplex, Simplex], ...]:
    """All free simplices with their cofaces, those of the highest dimension first, then in order.

    Clause: OPER-COLLAPSE-1.
    """
    cofaces: dict[Simplex, list[Simplex]] = {simplex: [] for simplex in k.simplices}
    for simplex in k.simplices:
        for v in simplex:
            if len(simplex) > 1:
                cofaces[simplex - {v}].append(simplex)
    # One coface is enough: two vertices more would give two simplices with one vertex more.
    pairs = [(free, of[0]) for free, of in cofaces.items() if len(of) == 1]
    return tuple(sorted(pairs, key=lambda pair: (-len(pair[0]), sorted(pair[0]))))
