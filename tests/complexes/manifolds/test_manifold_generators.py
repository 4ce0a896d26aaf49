"""What the strategies of manifolds draw, and what a planted fault shrinks to."""

from collections.abc import Callable
from random import Random
from typing import TypeVar

import pytest
from hypothesis import HealthCheck, Phase, find, given, settings
from hypothesis import strategies as st

from clers.complexes.manifolds.classification import classify
from clers.complexes.manifolds.given import Piece, Prescribed
from clers.complexes.manifolds.kind import Flaw, NotManifold
from clers.complexes.manifolds.manifold import Manifold, manifold
from clers.complexes.manifolds.orient import Oriented, orient
from clers.complexes.manifolds.surface_type import NonOrientable, Orientable
from clers.complexes.simplicial import Complex, boundary, closure, euler, of_dimension, pieces
from clers.conventions.result import Accepted
from clers.generate.manifold_pieces import handle, made
from clers.generate.manifolds import DOMAINS, broken, manifolds
from clers.generate.manifolds import pieces as pieces_of
from clers.generate.sample import sample

T = TypeVar("T")


def shrunk(strategy: st.SearchStrategy[T], fails: Callable[[T], bool]) -> T:
    """The smallest example that Hypothesis finds."""
    ways = settings(
        max_examples=300,
        database=None,
        deadline=None,
        phases=[Phase.generate, Phase.shrink],
        suppress_health_check=list(HealthCheck),
    )
    return find(strategy, fails, settings=ways, random=Random(1))


def counts(k: Complex) -> tuple[int, ...]:
    top = max(map(len, k.simplices))
    return tuple(len(of_dimension(k, m)) for m in range(top))


def test_a_checker_blind_to_cross_caps_is_shown_the_projective_plane() -> None:
    """Planted: whoever takes χ and curves alone for the type. The plane has χ = 1: 6 vertices."""

    def misjudged(of: Prescribed) -> bool:
        (piece,) = of.pieces
        return 2 - 2 * piece.genus - piece.curves != euler(of.complex)

    found = shrunk(manifolds(2, components=(1, 1), moves=2), misjudged)
    assert found.pieces == (Piece(False, 1, 0),)
    assert counts(found.complex) == (6, 15, 10)


def test_a_law_that_forgets_boundaries_is_shown_one_triangle() -> None:
    """Planted: each wall in two simplices."""

    def misjudged(of: Prescribed) -> bool:
        return bool(boundary(of.complex).simplices)

    assert shrunk(manifolds(2, moves=2), misjudged).complex == closure([(0, 1, 2)])


def test_a_checker_of_walls_alone_is_shown_a_pinch() -> None:
    """Planted: pure, and each wall in one or two, is all that is asked of a surface."""

    def pinched(k: Complex) -> bool:
        answer = manifold(k)
        return isinstance(answer, NotManifold) and answer.flaw is Flaw.DISCONNECTED

    discs = manifolds(2, genus=(0, 0), curves=(1, 2), components=(2, 3), moves=1)
    found = shrunk(broken(discs, 2), pinched)
    assert counts(found) == (5, 6, 2)


@given(manifolds(2, orientable=False, genus=(2, 3), curves=(1, 1), components=(2, 2)))
def test_what_is_asked_for_is_drawn(of: Prescribed) -> None:
    answer = classify(of.complex)
    assert isinstance(answer, Accepted)
    assert len(answer.value) == 2
    assert set(answer.value) <= {NonOrientable(2, 1), NonOrientable(3, 1)}


@given(manifolds(3, orientable=False, curves=(0, 1), components=(1, 1)))
def test_one_sided_3_manifolds(of: Prescribed) -> None:
    assert isinstance(manifold(of.complex), Manifold)
    assert not isinstance(orient(of.complex), Oriented)


@given(manifolds(3, orientable=True, genus=(1, 2), components=(1, 1), moves=1))
def test_two_sided_3_manifolds(of: Prescribed) -> None:
    assert isinstance(orient(of.complex), Oriented)
    assert len(pieces(boundary(of.complex))) == of.pieces[0].curves


@pytest.mark.parametrize(("n", "orientable"), [(0, False), (1, False), (4, False)])
def test_nothing_is_drawn_where_nothing_fits(n: int, orientable: bool) -> None:
    assert pieces_of(n, orientable=orientable).is_empty


@pytest.mark.parametrize(
    ("n", "orientable", "vertices"), [(2, True, 7), (2, False, 6), (3, True, 10), (3, False, 9)]
)
def test_handles(n: int, orientable: bool, vertices: int) -> None:
    """Möbius' torus; the plane; bundles of spheres over a circle (D. W. Walkup; W. Kühnel)."""
    k = handle(n, orientable=orientable)
    assert manifold(k) == Manifold(n, tuple(range(vertices)), ())
    assert isinstance(orient(k), Oriented) == orientable
    assert euler(k) == (1 if (n, orientable) == (2, False) else 0)


def test_pieces_are_as_small_as_they_come() -> None:
    assert counts(made(2, Piece(True, 0, 0), 0)) == (4, 6, 4)
    assert counts(made(2, Piece(True, 0, 1), 0)) == (3, 3, 1)
    assert counts(made(2, Piece(True, 0, 2), 0)) == (6, 12, 6)
    assert counts(made(2, Piece(True, 1, 1), 3)) == (7, 21, 13)
    assert counts(made(3, Piece(True, 0, 0), 0)) == (5, 10, 10, 5)
    assert counts(made(1, Piece(True, 0, 2), 0)) == (2, 1)
    assert counts(made(1, Piece(True, 0, 0), 0)) == (3, 3)
    assert counts(made(0, Piece(True, 0, 0), 0)) == (1,)


def test_surfaces_of_all_types_are_drawn() -> None:
    """The pieces alone, so that there can be many: rare types come whatever the seed."""
    pieces_drawn = sample(pieces_of(2, None, (0, 3), (0, 3)), 2000, 1)
    drawn = {piece.surface_type for piece in pieces_drawn}
    assert {Orientable(g, b) for g in range(3) for b in range(3)} <= drawn
    assert {NonOrientable(k, b) for k in range(1, 3) for b in range(3)} <= drawn


def test_every_flaw_is_drawn() -> None:
    drawn = [
        manifold(k) for k in sample(DOMAINS["near-manifolds"], 400, 0) if isinstance(k, Complex)
    ]
    assert {answer.flaw for answer in drawn if isinstance(answer, NotManifold)} == set(Flaw)
    assert sum(isinstance(answer, NotManifold) for answer in drawn) > len(drawn) // 8
