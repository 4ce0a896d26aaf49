"""The laws of all moves: complexes stay complexes, inverses undo, numbers change by formula."""

from itertools import pairwise
from typing import Final, assert_never

from clers.complexes.homology import Field, betti
from clers.complexes.manifolds.incidence import rim
from clers.complexes.manifolds.manifold import Manifold, manifold
from clers.complexes.simplicial import (
    Complex,
    Simplex,
    closure,
    dimension,
    euler,
    pieces,
)
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import AtSimplex
from clers.operators.moves.apply import apply, inverse, replay
from clers.operators.moves.effect import counts, difference, effect
from clers.operators.moves.given import MANIFOLD_MOVES, MOVES, Sited
from clers.operators.moves.move import (
    Bistellar,
    Collapse,
    Contract,
    Expand,
    Move,
    Split,
    Subdivide,
    Vertices,
    Weld,
)
from clers.operators.moves.text import read, write


def _closed(sited: Sited) -> Verdict:
    k, move = sited
    after = apply(move, k)
    if isinstance(after, Rejected):
        return Holds()
    return same(closure(after.value.simplices), after.value)


def _blamed(sited: Sited) -> Verdict:
    """What is missing is not there, what is present is there."""
    k, move = sited
    after = apply(move, k)
    match after:
        case Rejected(Reason.MISSING_SIMPLEX, _, AtSimplex(vertices)):
            return same(False, frozenset(vertices) in k.simplices)
        case Rejected(Reason.PRESENT_SIMPLEX, _, AtSimplex(vertices)):
            return same(True, frozenset(vertices) in k.simplices)
        case Rejected(Reason.MISSING_SIMPLEX | Reason.PRESENT_SIMPLEX):
            return Fails("a simplex to blame", after.line(), after.where)
        case _:
            return Holds()


def well_formed(move: Move) -> bool:
    """May these be operands of the move? Clause: OPER-MOVE-2."""
    match move:
        case Collapse(free, coface) | Expand(free, coface):
            added = set(coface) - set(free)
            return (
                _is_simplex(free)
                and _is_simplex(coface)
                and len(added) == 1
                and set(free) | added == set(coface)
                and set(free) < set(coface)
            )
        case Subdivide(simplex, vertex) | Weld(simplex, vertex):
            return _is_simplex(simplex) and vertex >= 0
        case Bistellar(gone, come):
            return _is_simplex(gone) and _is_simplex(come)
        case Contract(keep, gone):
            return keep >= 0 and gone >= 0 and keep != gone
        case Split(vertex, new, moved, shared):
            parts = (*moved, *shared)
            return (
                vertex >= 0
                and new >= 0
                and all(map(_is_simplex, parts))
                and all(vertex not in part for part in parts)
            )
        case _:
            assert_never(move)


def _is_simplex(vertices: Vertices) -> bool:
    return len(vertices) > 0 and min(vertices) >= 0 and all(a < b for a, b in pairwise(vertices))


def _operands(sited: Sited) -> Verdict:
    k, move = sited
    match apply(move, k):
        case Rejected(Reason.BAD_OPERAND, clause):
            return every(same(False, well_formed(move)), same(Clause.OPER_MOVE_2, clause))
        case _:
            return same(True, well_formed(move))


def _in_order(sited: Sited) -> Verdict:
    k, move = sited
    first = apply(move, k)
    if isinstance(first, Rejected):
        return every(same(first, replay((move, move), k)), same(Accepted(k), replay((), k)))
    return every(
        same(first, replay((move,), k)),
        same(apply(move, first.value), replay((move, move), k)),
    )


def _undone(sited: Sited) -> Verdict:
    k, move = sited
    after = apply(move, k)
    if isinstance(after, Rejected):
        return Holds()
    return same(Accepted(k), apply(inverse(move, k), after.value))


def _homology(sited: Sited) -> Verdict:
    k, move = sited
    after = apply(move, k)
    if isinstance(after, Rejected):
        return Holds()
    return every(
        same(euler(k), euler(after.value)),
        *(same(_betti(k, field), _betti(after.value, field)) for field in Field),
    )


def _betti(k: Complex, field: Field) -> tuple[int, ...]:
    """b_0 … up to the last that is not zero: a collapse may lower the dimension."""
    found = list(betti(k, field))
    while found and found[-1] == 0:
        found.pop()
    return tuple(found)


def _numbers(sited: Sited) -> Verdict:
    k, move = sited
    after = apply(move, k)
    if isinstance(after, Rejected):
        return Holds()
    return same(difference(counts(after.value), counts(k)), effect(move, k))


def _manifolds(sited: Sited) -> Verdict:
    k, move = sited
    after = apply(move, k)
    if isinstance(after, Rejected) or isinstance(move, Collapse | Expand):
        return Holds()
    return same(described(k), described(after.value))


Description = tuple[bool, int, tuple[tuple[int, ...], ...], tuple[tuple[int, ...], ...]]


def described(k: Complex) -> Description:
    """Is it a manifold, its dimension, and the homology of its components and its boundary's.

    Up to dimension 2 it tells all manifolds apart: for each component χ, the number of boundary
    curves, and whether it can be oriented. Clause: OPER-MOVE-7.
    """
    if not isinstance(manifold(k), Manifold):
        return False, dimension(k), (), ()
    parts = [(*betti(part, Field.GF2), *betti(part, Field.Q), *_rim(part)) for part in pieces(k)]
    rims = [betti(part, Field.Q) for part in pieces(rim(k))]
    return True, dimension(k), tuple(sorted(parts)), tuple(sorted(rims))


def _rim(part: Complex) -> tuple[int, ...]:
    """The number of boundary components, and the Betti numbers with the boundary coned off."""
    edge = rim(part).simplices
    if not edge:
        return (0,)
    new = 1 + max(v for simplex in part.simplices for v in simplex)
    cone: set[Simplex] = {frozenset([new]), *(simplex | {new} for simplex in edge)}
    whole = Complex(part.simplices | cone)
    return (len(pieces(Complex(edge))), *betti(whole, Field.GF2), *betti(whole, Field.Q))


def _text(sited: Sited) -> Verdict:
    _, move = sited
    if not well_formed(move):
        return Holds()
    return same(Accepted((move, move)), read(write((move, move))))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "moves-ask-for-operands",
        Clause.OPER_MOVE_2,
        "A move is rejected for its operands exactly if they are not what it names.",
        MOVES,
        _operands,
    ),
    Law(
        "moves-make-complexes",
        Clause.OPER_MOVE_3,
        "What a move makes of a complex contains the faces of all its simplices.",
        MOVES,
        _closed,
    ),
    Law(
        "moves-blame-what-is-so",
        Clause.OPER_MOVE_3,
        "A simplex blamed for missing is not in the complex, one blamed for being present is.",
        MOVES,
        _blamed,
    ),
    Law(
        "moves-run-in-order",
        Clause.OPER_MOVE_4,
        "A list of moves is the first of them, and the others on what it leaves.",
        MOVES,
        _in_order,
    ),
    Law(
        "moves-are-undone",
        Clause.OPER_MOVE_5,
        "The inverse of a move that applies leads back to the complex.",
        MOVES,
        _undone,
    ),
    Law(
        "moves-keep-homology",
        Clause.OPER_MOVE_6,
        "No move changes χ or a Betti number, over GF(2) or over Q.",
        MOVES,
        _homology,
    ),
    Law(
        "moves-change-numbers-by-formula",
        Clause.OPER_MOVE_6,
        "The numbers of simplices change as the table's formula says.",
        MOVES,
        _numbers,
    ),
    Law(
        "moves-keep-manifolds",
        Clause.OPER_MOVE_7,
        "A manifold stays one of the same dimension, homology and boundary.",
        MANIFOLD_MOVES,
        _manifolds,
    ),
    Law(
        "moves-text-round-trip",
        Clause.OPER_MOVE_8,
        "Reading written moves gives them back.",
        MOVES,
        _text,
    ),
)
