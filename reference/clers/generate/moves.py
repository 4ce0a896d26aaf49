"""Complexes with moves that may apply to them, as Hypothesis strategies."""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

from clers.complexes import known
from clers.complexes.manifolds.kind import Ball, LinkKind, Sphere
from clers.complexes.simplicial import Complex, Simplex, closure, link, of_dimension
from clers.conventions.result import Accepted
from clers.generate.scripts import CHOICES
from clers.operators.moves.apply import apply, inverse
from clers.operators.moves.augmented import EMPTY, around, in_order
from clers.operators.moves.candidates import (
    KINDS,
    Kind,
    chosen,
    collapses,
    flips,
    new_vertex,
    simplices,
    subdivisions,
    vary,
)
from clers.operators.moves.given import Sited
from clers.operators.moves.move import (
    Bistellar,
    Collapse,
    Contract,
    Expand,
    Move,
    Split,
    Vertices,
    Weld,
)
from clers.operators.moves.split import spanning, split_back

FEW_MOVES: Final = st.lists(CHOICES, max_size=6)

_CURVES: Final = (known.SPHERES[1].complex, known.BALLS[1].complex, closure([(0, 1), (2, 3)]))
_SURFACES: Final = tuple(
    of.complex
    for of in (
        *(known.SPHERES[2], known.BALLS[2], known.OCTAHEDRON, known.ANNULUS),
        *(known.MOEBIUS_BAND, known.PROJECTIVE, known.TORUS, known.KLEIN),
    )
)
_CLOSED: Final = (known.SPHERES[3].complex, known.SIXTEEN_CELL.complex)
_SPACES: Final = (*_CLOSED, known.BALLS[3].complex, closure([(0, 1, 2, 3), (0, 1, 2, 4)]))


def varied(
    starts: tuple[Complex, ...], most: int, kinds: tuple[Kind, ...] = KINDS
) -> st.SearchStrategy[Complex]:
    """One of the manifolds after a few moves, with at most so many vertices or as many as it had.

    Shrinks to few moves on the first of them.
    """
    return st.builds(
        lambda start, choices: vary(start, choices, most, kinds),
        st.sampled_from(starts),
        FEW_MOVES,
    )


def curves_and_surfaces() -> st.SearchStrategy[Complex]:
    """Manifolds of dimension 1 and 2, of at most nine vertices."""
    return varied((*_CURVES, *_SURFACES), 9)


def closed_spaces() -> st.SearchStrategy[Complex]:
    """Triangulations of the 3-sphere, of at most seven vertices."""
    return varied(_CLOSED[:1], 7)


def few_simplices() -> st.SearchStrategy[Complex]:
    """Closures of a few simplices on the vertices 0 … 7; many with the homology of a point."""
    vertices = st.integers(0, 6)
    any_of = st.lists(st.sets(vertices, min_size=1, max_size=4), min_size=1, max_size=5)
    base = st.lists(st.sets(vertices, min_size=1, max_size=3), min_size=1, max_size=5)
    coned = base.map(lambda of: [{*s, 7} for s in of])
    return st.one_of(any_of, coned).map(closure)


def any_move(k: Complex) -> st.SearchStrategy[Move]:
    """A move with operands from the complex, which may apply, or with any operands."""
    names = sorted({v for simplex in k.simplices for v in simplex} | {new_vertex(k)})
    here = st.sampled_from(simplices(k)).map(in_order)
    wild = st.lists(st.integers(-1, names[-1]), max_size=3).map(_as_drawn)
    there = st.sets(st.sampled_from(names), min_size=1, max_size=4).map(in_order_set)
    one = st.one_of(here, there, wild)
    vertex = st.one_of(st.sampled_from(names), st.integers(-1, 9))
    pair = st.one_of(st.builds(_without_one, st.one_of(here, there), CHOICES), st.tuples(one, one))
    return st.one_of(
        pair.map(lambda p: Collapse(*p)),
        pair.map(lambda p: Expand(*p)),
        st.builds(Weld, one, vertex),
        st.builds(Bistellar, one, one),
        st.builds(Contract, vertex, vertex),
        st.builds(Split, vertex, vertex, _parts(one), _parts(one)),
    )


def _as_drawn(vertices: list[int]) -> Vertices:
    return tuple(vertices)


def in_order_set(of: set[int]) -> Vertices:
    """The vertices of a set as an operand."""
    return tuple(sorted(of))


def _parts(of: st.SearchStrategy[Vertices]) -> st.SearchStrategy[tuple[Vertices, ...]]:
    return st.lists(of, max_size=2).map(tuple)


def _without_one(simplex: Vertices, choice: int) -> tuple[Vertices, Vertices]:
    i = choice % max(len(simplex), 1)
    return simplex[:i] + simplex[i + 1 :], simplex


@st.composite
def sited(draw: st.DrawFn, of: st.SearchStrategy[Complex], kinds: tuple[Kind, ...]) -> Sited:
    """A complex and: a move that applies; the inverse of one that did; or any move."""
    k = draw(of)
    how = draw(st.integers(0, 7))
    move = chosen(k, draw(CHOICES), kinds) if how < 6 else None
    if move is None:
        return k, draw(any_move(k))
    after = apply(move, k)
    if how > 2 and isinstance(after, Accepted):
        return after.value, inverse(move, k)
    return k, move


@st.composite
def welds(draw: st.DrawFn) -> tuple[Complex, Weld]:
    """After a subdivision: its weld, or one of other vertices around some vertex."""
    k = draw(st.one_of(few_simplices(), varied(_SURFACES[:3], 7)))
    move = chosen(k, draw(CHOICES), (subdivisions,))
    after = None if move is None else apply(move, k)
    if move is not None and isinstance(after, Accepted):
        undo = inverse(move, k)
        if isinstance(undo, Weld) and draw(st.booleans()):
            return after.value, undo
        k = after.value
    (v,) = draw(st.sampled_from(of_dimension(k, 0)))
    near = sorted({w for simplex in link(k, frozenset([v])).simplices for w in simplex} | {99})
    return k, Weld(draw(st.sets(st.sampled_from(near), min_size=1).map(in_order_set)), v)


@st.composite
def flip_moves(draw: st.DrawFn) -> tuple[Complex, Bistellar]:
    """A simplex with the vertices of its link, with a new vertex, or with anything."""
    k = draw(st.one_of(few_simplices(), varied((*_SURFACES, *_SPACES), 8), _four_dimensional()))
    if draw(st.integers(0, 3)) > 0:
        move = chosen(k, draw(CHOICES), (flips,))
        if isinstance(move, Bistellar):
            return k, move
    a = draw(st.sampled_from(simplices(k)))
    near = sorted({w for simplex in link(k, a).simplices for w in simplex} | {new_vertex(k)})
    one = st.sampled_from([(w,) for w in near])
    return k, Bistellar(
        in_order(a), draw(st.one_of(st.just((near[-1],)), st.just(in_order(frozenset(near))), one))
    )


def _four_dimensional() -> st.SearchStrategy[Complex]:
    return varied((known.SPHERES[4].complex,), 8, (flips, subdivisions))


@st.composite
def splits_of(draw: st.DrawFn) -> Sited:
    """A vertex of a curve or surface and a part of its link, most often with what it shares."""
    k = draw(varied((*_CURVES, *_SURFACES[:6]), 8))
    if draw(st.booleans()):
        edge = draw(st.sampled_from(of_dimension(k, 1)))
        move = Contract(*in_order(edge))
        after = apply(move, k)
        if isinstance(after, Accepted):
            return after.value, split_back(k, move)
    (v,) = draw(st.sampled_from(of_dimension(k, 0)))
    whole = around(k, frozenset([v]))
    listed = sorted(whole - {EMPTY}, key=lambda s: (-len(s), sorted(s)))
    picked: list[Simplex] = draw(st.lists(st.sampled_from(listed), max_size=4)) if listed else []
    moved = closure(picked).simplices
    stay = closure(whole - moved - {EMPTY}).simplices
    shared = set(moved & stay)
    if moved and draw(st.integers(0, 3)) == 0:
        shared ^= {draw(st.sampled_from(sorted(moved, key=sorted)))}
    return k, Split(v, new_vertex(k), spanning(moved), spanning(frozenset(shared)))


def spheres_and_balls() -> st.SearchStrategy[tuple[Complex, LinkKind]]:
    """Spheres and balls of dimension 3 and 4, by moves from the smallest, with what they are."""
    return st.one_of(
        varied(_CLOSED, 9).map(lambda k: (k, Sphere(3))),
        varied((known.BALLS[3].complex,), 8).map(lambda k: (k, Ball(3))),
        _four_dimensional().map(lambda k: (k, Sphere(4))),
        varied((known.BALLS[4].complex,), 8).map(lambda k: (k, Ball(4))),
    )


@st.composite
def renamed_surfaces(draw: st.DrawFn) -> tuple[Complex, Complex]:
    """A sphere or projective plane, and it or another one, its vertices permuted."""
    surfaces = varied((_SURFACES[0], _SURFACES[5]), 6)
    k = draw(surfaces)
    other = draw(st.one_of(st.just(k), surfaces))
    old = [v for simplex in of_dimension(other, 0) for v in simplex]
    name = dict(zip(old, draw(st.permutations(old)), strict=True))
    return k, Complex(frozenset(frozenset(name[v] for v in s) for s in other.simplices))


def manifolds() -> st.SearchStrategy[Complex]:
    """Small manifolds of dimension 1 to 3, with and without boundary."""
    return st.one_of(curves_and_surfaces(), varied(_SPACES, 8))


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "complex-moves": sited(
        st.one_of(
            few_simplices(), varied((*_CURVES, *_SURFACES, *_SPACES), 8), _four_dimensional()
        ),
        (collapses, *KINDS),
    ),
    "manifold-moves": sited(manifolds(), KINDS),
    "few-simplices": few_simplices(),
    "curves-and-surfaces": curves_and_surfaces(),
    "closed-spaces": closed_spaces(),
    "welds": welds(),
    "flips": flip_moves(),
    "splits": splits_of(),
    "spheres-and-balls": spheres_and_balls(),
    "renamed-surfaces": renamed_surfaces(),
}
"""The domains of this module, by name."""
