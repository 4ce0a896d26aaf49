"""What every move asks of its operands before it looks at its own condition."""

from collections.abc import Iterable

from clers.complexes.simplicial import Complex, Simplex
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Rejected
from clers.conventions.where import WHOLE, AtSimplex
from clers.operators.moves.augmented import first_of, in_order
from clers.operators.moves.move import Vertices


def bad_operand(*operands: Vertices) -> Rejected | None:
    """Is one of the operands no simplex? Clause: OPER-MOVE-2."""
    for operand in operands:
        if not operand or operand[0] < 0 or list(operand) != sorted(set(operand)):
            detail = f"{operand} is not a list of vertices from 0 in increasing order"
            return Rejected(Reason.BAD_OPERAND, Clause.OPER_MOVE_2, WHOLE, detail)
    return None


def missing(k: Complex, needed: Iterable[Simplex], clause: Clause) -> Rejected | None:
    """Is a simplex not there that must be? Clause: OPER-MOVE-3."""
    found = first_of(simplex for simplex in needed if simplex not in k.simplices)
    if found is None:
        return None
    return Rejected(Reason.MISSING_SIMPLEX, clause, AtSimplex(in_order(found)))


def present(k: Complex, new: Simplex, clause: Clause) -> Rejected | None:
    """Is a simplex there that must be new? Clause: OPER-MOVE-3."""
    if new not in k.simplices:
        return None
    return Rejected(Reason.PRESENT_SIMPLEX, clause, AtSimplex(in_order(new)))
