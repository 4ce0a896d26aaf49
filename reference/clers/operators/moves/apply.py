"""Do a move, and find the move that undoes it."""

from collections.abc import Iterable
from functools import partial
from typing import assert_never

from clers.complexes.simplicial import Complex
from clers.conventions.result import Accepted, Rejected, and_then
from clers.operators.moves.bistellar import bistellar
from clers.operators.moves.collapse import collapse, expand
from clers.operators.moves.contract import contract
from clers.operators.moves.move import (
    Bistellar,
    Collapse,
    Contract,
    Expand,
    Move,
    Split,
    Subdivide,
    Weld,
)
from clers.operators.moves.split import split, split_back
from clers.operators.moves.stellar import subdivide, weld


def apply(move: Move, k: Complex) -> Accepted[Complex] | Rejected:
    """The complex after the move, or why it does not apply. Clause: OPER-MOVE-3."""
    match move:
        case Collapse():
            return collapse(k, move)
        case Expand():
            return expand(k, move)
        case Subdivide():
            return subdivide(k, move)
        case Weld():
            return weld(k, move)
        case Bistellar():
            return bistellar(k, move)
        case Contract():
            return contract(k, move)
        case Split():
            return split(k, move)
        case _:
            assert_never(move)


def replay(moves: Iterable[Move], k: Complex) -> Accepted[Complex] | Rejected:
    """The complex after all of the moves, or the first rejection. Clause: OPER-MOVE-4."""
    now: Accepted[Complex] | Rejected = Accepted(k)
    for move in moves:
        now = and_then(now, partial(apply, move))
    return now


def inverse(move: Move, k: Complex) -> Move:
    """The move that undoes this one, where this one applies to the complex. Clause: OPER-MOVE-5.

    Only a contraction forgets something, which its inverse reads from the complex.
    """
    match move:
        case Collapse(free, coface):
            return Expand(free, coface)
        case Expand(free, coface):
            return Collapse(free, coface)
        case Subdivide(simplex, vertex):
            return Weld(simplex, vertex)
        case Weld(simplex, vertex):
            return Subdivide(simplex, vertex)
        case Bistellar(gone, come):
            return Bistellar(come, gone)
        case Contract():
            return split_back(k, move)
        case Split(vertex, new, _, _):
            return Contract(vertex, new)
        case _:
            assert_never(move)
