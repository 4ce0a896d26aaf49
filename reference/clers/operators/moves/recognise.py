"""Spheres and balls of any dimension, recognised by bistellar moves, with the moves as proof.

A complex that bistellar moves make the boundary of a simplex is a sphere, whatever led to them. A
complex is a ball if closing it by a cone over its boundary gives a sphere: it is what is left of
this sphere without the open star of one vertex.
"""

from dataclasses import dataclass
from typing import Final, assert_never

from clers.complexes.manifolds.incidence import rim
from clers.complexes.manifolds.kind import Ball, LinkKind, Neither, Sphere, Undecided
from clers.complexes.manifolds.spheres import recognise as recognised_by_homology
from clers.complexes.simplicial import Complex, dimension, of_dimension
from clers.conventions.result import Rejected
from clers.operators.moves.augmented import EMPTY, complex_of, joined
from clers.operators.moves.bistellar import bistellar
from clers.operators.moves.move import Bistellar
from clers.operators.moves.simplify import simplifying

EFFORT: Final = 1000
"""How many moves are tried before an answer is `Undecided`, if nothing else is said."""


@dataclass(frozen=True, slots=True)
class Recognition:
    """What a complex is, and the moves that show it: of itself, or of itself with a cone.

    Clause: OPER-RECOGNISE-3. Without moves the kind was found by chapter 3 alone.
    """

    kind: LinkKind
    moves: tuple[Bistellar, ...] = ()


def recognise(k: Complex) -> LinkKind:
    """Sphere, ball, neither or undecided, never wrong. OPER-RECOGNISE-2, OPER-RECOGNISE-4."""
    return recognition(k).kind


def recognition(k: Complex, effort: int = EFFORT, seed: int = 0) -> Recognition:
    """The same with its proof. Clauses: OPER-RECOGNISE-2, OPER-RECOGNISE-3."""
    known = recognised_by_homology(k)
    match known:
        case Sphere() | Ball() | Neither():
            return Recognition(known)
        case Undecided():
            return _by_moves(k, effort, seed)
        case _:
            assert_never(known)


def _by_moves(k: Complex, effort: int, seed: int) -> Recognition:
    whole, n = closed(k), dimension(k)
    moves = simplifying(whole, effort, seed)
    if not shows_sphere(whole, moves):
        return Recognition(Undecided(f"no {effort} moves led to the boundary of a simplex"))
    return Recognition(Sphere(n) if whole == k else Ball(n), moves)


def closed(k: Complex) -> Complex:
    """The complex with a cone over its boundary, if it has one. Clause: OPER-RECOGNISE-3.

    The top of the cone is the next number after the largest vertex.
    """
    edge = rim(k).simplices
    if not edge:
        return k
    top = frozenset([1 + max(v for simplex in k.simplices for v in simplex)])
    return complex_of(k.simplices | joined([top], edge | {EMPTY}))


def shows_sphere(k: Complex, moves: tuple[Bistellar, ...]) -> bool:
    """Do the moves apply, and lead to the boundary of a simplex? Clause: OPER-RECOGNISE-3."""
    for move in moves:
        after = bistellar(k, move)
        if isinstance(after, Rejected):
            return False
        k = after.value
    return is_frontier(k)


def is_frontier(k: Complex) -> bool:
    """Is it the boundary of a simplex: all sets of its vertices but the empty and the whole?"""
    vertices = len(of_dimension(k, 0))
    return len(k.simplices) == (1 << vertices) - 2
