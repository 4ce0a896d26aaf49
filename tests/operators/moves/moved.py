"""What tests of moves share: moves that must apply, and rejections said in one line."""

from clers.complexes.simplicial import Complex, closure
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtPair, AtSimplex, Where
from clers.operators.moves.apply import apply, replay
from clers.operators.moves.move import Move

Simplices = tuple[tuple[int, ...], ...]


def after(k: Complex, *moves: Move) -> Complex:
    """The complex after moves that apply."""
    result = replay(moves, k)
    assert isinstance(result, Accepted), result.line()
    return result.value


def refusal(move: Move, *facets: tuple[int, ...]) -> tuple[Reason, Clause, Where]:
    """Why a move does not apply to the closure of the facets."""
    result = apply(move, closure(facets))
    assert isinstance(result, Rejected), result
    return result.reason, result.clause, result.where


def at(*vertices: int) -> AtSimplex:
    """A simplex to blame."""
    return AtSimplex(vertices)


def pair(first: tuple[int, ...], second: tuple[int, ...]) -> AtPair:
    """A pair to blame."""
    return AtPair(first, second)


BAD = (Reason.BAD_OPERAND, Clause.OPER_MOVE_2, WHOLE)
