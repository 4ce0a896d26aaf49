"""Spheres and balls recognised by moves: known ones, large ones, and what is none."""

from itertools import permutations
from math import comb

import pytest
from moved import after

from clers.complexes.known import (
    BALLS,
    COMPLEX_PROJECTIVE,
    DUNCE,
    KNOWN,
    POINCARE,
    SPHERES,
    SUSPENDED_PLANE,
    THREE_TORUS,
    Known,
)
from clers.complexes.manifolds.kind import Ball, Flaw, Neither, Sphere, Undecided
from clers.complexes.manifolds.manifold import Manifold, UndecidedAt, manifold
from clers.complexes.simplicial import Complex, closure, dimension, of_dimension
from clers.conventions.result import Accepted
from clers.operators.moves.apply import replay
from clers.operators.moves.move import Bistellar, Subdivide
from clers.operators.moves.recognise import (
    Recognition,
    closed,
    is_frontier,
    recognise,
    recognition,
    shows_sphere,
)
from clers.operators.moves.simplify import simplifying


def barycentric(k: Complex) -> Complex:
    """A vertex for each simplex, a simplex for each chain of them."""
    number = {s: i for i, s in enumerate(sorted(k.simplices, key=lambda s: (len(s), sorted(s))))}
    return closure(
        [number[frozenset(order[: i + 1])] for i in range(len(order))]
        for facet in of_dimension(k, dimension(k))
        for order in permutations(sorted(facet))
    )


@pytest.mark.parametrize("of", KNOWN, ids=lambda of: of.name)
def test_known(of: Known) -> None:
    """Only spheres and balls are taken for some. Clause: OPER-RECOGNISE-2."""
    kind = recognise(of.complex)
    if of in SPHERES or of.name in ("octahedron", "16-cell"):
        assert kind == Sphere(of.dimension)
    elif of in BALLS:
        assert kind == Ball(of.dimension)
    elif of is POINCARE:
        assert kind == Undecided("no 1000 moves led to the boundary of a simplex")
    else:
        assert isinstance(kind, Neither)


LARGE = [
    ("3-sphere", SPHERES[3].complex, Sphere(3), 30),
    ("3-ball", BALLS[3].complex, Ball(3), 15),
    ("4-ball", BALLS[4].complex, Ball(4), 31),
]


@pytest.mark.parametrize(("name", "k", "kind", "vertices"), LARGE)
def test_barycentric(name: str, k: Complex, kind: Sphere | Ball, vertices: int) -> None:
    """What they are is known from what was subdivided. OPER-RECOGNISE-2, OPER-RECOGNISE-3."""
    large = barycentric(k)
    assert len(of_dimension(large, 0)) == vertices, name
    found = recognition(large)
    assert found.kind == kind
    assert shows_sphere(closed(large), found.moves)
    assert not shows_sphere(closed(large), found.moves[:-1])
    assert not shows_sphere(closed(large), found.moves[1:])


def test_manifolds_of_dimension_four() -> None:
    """Links of dimension 3 decide them, once moves recognise these. Clause: OPER-RECOGNISE-2."""
    once = after(SPHERES[4].complex, Subdivide((0, 1, 2), 9), Subdivide((0, 9), 10))
    assert manifold(once, recognise) == Manifold(4, (*range(6), 9, 10), ())
    answer = manifold(COMPLEX_PROJECTIVE.complex, recognise)
    assert answer == Manifold(4, tuple(range(9)), ())
    assert isinstance(manifold(COMPLEX_PROJECTIVE.complex), UndecidedAt)


def test_the_suspended_poincare_sphere_stays_undecided() -> None:
    """It is no manifold, at two vertices; homology cannot see that."""
    facets = of_dimension(POINCARE.complex, 3)
    top = 1 + max(map(max, facets))
    k = closure(facet | {v} for facet in facets for v in (top, top + 1))
    assert isinstance(manifold(k, lambda link: recognition(link, 150).kind), UndecidedAt)


def test_effort() -> None:
    """The 3-ball of two tetrahedra, closed, is one move from the boundary of a simplex."""
    k = closure([(0, 1, 2, 3), (0, 1, 2, 4)])
    found = recognition(k, 1)
    assert found.kind == Ball(3)
    assert len(found.moves) == 1
    assert recognition(k, 0) == Recognition(
        Undecided("no 0 moves led to the boundary of a simplex"), ()
    )


def test_no_moves_are_needed_below() -> None:
    """Chapter 3 decides; and the boundary of a simplex is one. Clause: OPER-RECOGNISE-3."""
    for k in (SPHERES[2].complex, BALLS[2].complex, THREE_TORUS.complex, DUNCE.complex):
        assert recognition(k).moves == ()
    assert recognition(SPHERES[3].complex) == Recognition(Sphere(3), ())
    assert recognition(BALLS[3].complex) == Recognition(Ball(3), ())
    assert recognition(SUSPENDED_PLANE.complex).kind == Neither(Flaw.WRONG_HOMOLOGY)


def test_closed() -> None:
    """Clause: OPER-RECOGNISE-3."""
    assert closed(SPHERES[2].complex) == SPHERES[2].complex
    assert closed(closure([(2, 5)])) == closure([(2, 5), (2, 6), (5, 6)])


def test_frontier() -> None:
    for n in range(4):
        assert is_frontier(SPHERES[n].complex)
        assert not is_frontier(BALLS[n].complex)
    assert not is_frontier(closure([(0, 1), (1, 2)]))
    assert not is_frontier(Complex(frozenset()))
    assert is_frontier(closure([(3, 4), (4, 9), (3, 9)]))


def test_moves_that_do_not_apply_show_nothing() -> None:
    k = after(SPHERES[3].complex, Subdivide((0, 1, 2, 3), 9))
    good = Bistellar((9,), (0, 1, 2, 3))
    assert shows_sphere(k, (good,))
    assert not shows_sphere(k, (good, good))
    assert not shows_sphere(k, (Bistellar((0, 1), (2, 3)), good))
    assert not shows_sphere(k, ())


def test_simplifying_takes_vertices_out_first() -> None:
    """Clause: OPER-RECOGNISE-1."""
    k = after(SPHERES[3].complex, Subdivide((0, 1, 2, 3), 9))
    assert simplifying(k, 100) == (Bistellar((9,), (0, 1, 2, 3)),)
    both = after(k, Subdivide((0, 1, 2, 9), 10))
    assert len(simplifying(both, 100)) == 2
    assert len(simplifying(both, 1)) == 1
    assert simplifying(both, 0) == ()
    assert simplifying(SPHERES[4].complex, 100) == ()


def test_vertices_go_before_edges() -> None:
    """Edge 49 lies in three tetrahedra, vertex 10 in four: both may go, and 10 goes first."""
    k = after(
        SPHERES[3].complex,
        Subdivide((0, 1, 2, 3), 9),
        Bistellar((0, 1, 2), (4, 9)),
        Subdivide((1, 2, 3, 9), 10),
    )
    assert after(k, Bistellar((4, 9), (0, 1, 2))) != k
    for seed in range(3):
        assert simplifying(k, 1, seed) == (Bistellar((10,), (1, 2, 3, 9)),)


def test_simplifying_is_a_function_of_its_arguments() -> None:
    """Clause: OPER-RECOGNISE-1."""
    k = barycentric(SPHERES[3].complex)
    moves = simplifying(k, 400)
    assert moves == simplifying(k, 400)
    assert moves[:50] == simplifying(k, 50)
    assert len(moves) < 400
    others = [simplifying(k, 400, seed) for seed in (1, 2)]
    assert moves != others[0] != others[1]
    assert all(shows_sphere(k, other) for other in others)
    # of 30 vertices, 5 stay
    gone = [move for move in moves if len(move.gone) == 1]
    assert len(gone) == 25
    assert isinstance(replay(moves, k), Accepted)


def test_where_nothing_can_be_done_it_ends() -> None:
    """Neighbourly: every flip would bring an edge that is there. Clause: OPER-RECOGNISE-1."""
    torus = closure({i, (i + j) % 7, (i + 3) % 7} for i in range(7) for j in (1, 2))
    assert comb(7, 2) == len(of_dimension(torus, 1))
    assert simplifying(torus, 10) == ()
