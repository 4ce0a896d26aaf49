"""The laws of recognition, and of triangulations up to isomorphism."""

from itertools import permutations
from typing import Final, assert_never

from clers.complexes.manifolds.kind import Ball, LinkKind, Neither, Sphere, Undecided
from clers.complexes.simplicial import Complex, boundary, dimension, of_dimension
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted
from clers.conventions.verdict import Holds, Verdict
from clers.operators.moves.apply import replay
from clers.operators.moves.given import RENAMED, SPHERES_AND_BALLS
from clers.operators.moves.reach import automorphisms, canonical
from clers.operators.moves.recognise import closed, recognise, recognition
from clers.operators.moves.simplify import simplifying


def _simplified(given: tuple[Complex, LinkKind]) -> Verdict:
    """The moves apply, none brings a new vertex, and twice the same question has one answer."""
    k = closed(given[0])
    moves = simplifying(k, 60)
    return every(
        same(moves, simplifying(k, 60)),
        same(True, len(moves) <= 60),
        same(True, all(len(move.come) > 1 for move in moves)),
        same(True, isinstance(replay(moves, k), Accepted)),
    )


def _right(given: tuple[Complex, LinkKind]) -> Verdict:
    """Undecided is no error."""
    k, expected = given
    kind = recognise(k)
    return Holds() if isinstance(kind, Undecided) else same(expected, kind)


def _shown(given: tuple[Complex, LinkKind]) -> Verdict:
    """The moves lead to all proper faces of a simplex of one dimension more."""
    k, _ = given
    found = recognition(k)
    match found.kind:
        case Sphere(n):
            return every(same((), of_dimension(boundary(k), 0)), _ends(k, n, found.moves))
        case Ball(n):
            return every(
                same(False, boundary(k).simplices == frozenset()),
                _ends(closed(k), n, found.moves),
            )
        case Neither() | Undecided():
            return same((), found.moves)
        case _:
            assert_never(found.kind)


def _ends(k: Complex, n: int, moves: tuple[object, ...]) -> Verdict:
    listed = simplifying(k, len(moves))
    left = replay(listed, k)
    if not isinstance(left, Accepted):
        return same("moves that apply", left)
    return every(
        same(moves, listed),
        same(n, dimension(left.value)),
        same(n + 2, len(of_dimension(left.value, 0))),
        same(2 ** (n + 2) - 2, len(left.value.simplices)),
    )


def _isomorphic(k: Complex, other: Complex) -> int:
    """How many renamings of vertices carry one onto the other: all are tried."""
    old = [v for (v,) in map(tuple, of_dimension(k, 0))]
    new = [v for (v,) in map(tuple, of_dimension(other, 0))]
    if len(old) != len(new):
        return 0
    facets = of_dimension(k, dimension(k))
    found = 0
    for order in permutations(new):
        name = dict(zip(old, order, strict=True))
        found += all(frozenset(name[v] for v in facet) in other.simplices for facet in facets)
    return found if len(facets) == len(of_dimension(other, dimension(other))) else 0


def _canonical(pair: tuple[Complex, Complex]) -> Verdict:
    k, other = pair
    return same(_isomorphic(k, other) > 0, canonical(k) == canonical(other))


def _automorphisms(pair: tuple[Complex, Complex]) -> Verdict:
    return same(_isomorphic(pair[1], pair[1]), automorphisms(pair[1]))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "simplifying-moves-apply",
        Clause.OPER_RECOGNISE_1,
        "The moves that simplify apply one after the other, and are the same each time.",
        SPHERES_AND_BALLS,
        _simplified,
    ),
    Law(
        "recognised-is-right",
        Clause.OPER_RECOGNISE_2,
        "What moves made of a sphere or a ball is recognised as that, or not decided.",
        SPHERES_AND_BALLS,
        _right,
    ),
    Law(
        "recognised-has-a-proof",
        Clause.OPER_RECOGNISE_3,
        "The moves of the proof lead to the boundary of a simplex.",
        SPHERES_AND_BALLS,
        _shown,
    ),
    Law(
        "canonical-forms-are-those-of-isomorphic-complexes",
        Clause.OPER_FLIPS_1,
        "Two surfaces have one canonical form exactly if some renaming carries one to the other.",
        RENAMED,
        _canonical,
    ),
    Law(
        "automorphisms-are-renamings",
        Clause.OPER_FLIPS_2,
        "The automorphisms counted are the renamings that keep the complex.",
        RENAMED,
        _automorphisms,
    ),
)
