"""Manifolds known from the literature, and complexes that are none: each answer and each blame."""

from itertools import combinations

import pytest
from hypothesis import given, settings

from clers.complexes.integral import Group, homology_over_z
from clers.complexes.known import (
    BALLS,
    BOOK,
    BOW_TIE,
    COMPLEX_PROJECTIVE,
    DUNCE,
    FIGURE_8,
    INTERIOR_PINCH,
    KNOWN,
    MOEBIUS_BAND,
    ONE_OF_EACH,
    POINCARE,
    PROJECTIVE,
    SPHERES,
    SUSPENDED_PLANE,
    SUSPENDED_TORUS,
    TORUS,
    TWO_SPHERES,
    Known,
)
from clers.complexes.manifolds.classification import Homeomorphic, homeomorphism
from clers.complexes.manifolds.given import Prescribed
from clers.complexes.manifolds.homology_type import (
    Looks,
    is_manifold_by_homology,
    looks,
    over_gf2,
)
from clers.complexes.manifolds.kind import (
    Ball,
    Flaw,
    LinkKind,
    Neither,
    NotManifold,
    Recogniser,
    Sphere,
    Undecided,
)
from clers.complexes.manifolds.laws_manifold import shy, trusting
from clers.complexes.manifolds.manifold import Manifold, UndecidedAt, manifold
from clers.complexes.manifolds.spheres import recognise
from clers.complexes.manifolds.surface_type import Orientable
from clers.complexes.simplicial import Complex, boundary, closure
from clers.conventions.result import Accepted
from clers.generate.manifolds import manifolds
from clers.operators.moves.recognise import recognise as by_moves

LOW = [known for known in KNOWN if known.dimension <= 3]
EMPTY = Complex(frozenset())


def coned(k: Complex, *tips: int) -> Complex:
    """The cone over a complex; over two tips its suspension."""
    return closure([*k.simplices, *(s | {tip} for s in k.simplices for tip in tips)])


def at(*vertices: int) -> frozenset[int]:
    return frozenset(vertices)


@pytest.mark.parametrize("known", LOW, ids=lambda known: known.name)
def test_low_dimensions_are_decided_as_the_literature_says(known: Known) -> None:
    """Clauses: CPLX-MANIFOLD-2, CPLX-MANIFOLD-4."""
    answer = manifold(known.complex)
    assert isinstance(answer, Manifold | NotManifold)
    assert isinstance(answer, Manifold) == known.manifold
    assert is_manifold_by_homology(known.complex) == known.manifold


@pytest.mark.parametrize(
    ("k", "expected"),
    [
        (EMPTY, Manifold(-1, (), ())),
        (closure([[7]]), Manifold(0, (7,), ())),
        (closure([[4], [2], [9]]), Manifold(0, (2, 4, 9), ())),
        (closure([[0, 1], [1, 2]]), Manifold(1, (1,), (0, 2))),
        (closure([[0, 1], [1, 2], [0, 2]]), Manifold(1, (0, 1, 2), ())),
        (closure([[0, 1, 2], [0, 2, 3], [0, 1, 3]]), Manifold(2, (0,), (1, 2, 3))),
        (TORUS.complex, Manifold(2, tuple(range(7)), ())),
        (PROJECTIVE.complex, Manifold(2, tuple(range(6)), ())),
        (MOEBIUS_BAND.complex, Manifold(2, (), tuple(range(5)))),
        (BALLS[3].complex, Manifold(3, (), (0, 1, 2, 3))),
        (coned(SPHERES[2].complex, 9), Manifold(3, (9,), (0, 1, 2, 3))),
        (POINCARE.complex, Manifold(3, tuple(range(16)), ())),
    ],
)
def test_inner_and_bounding_vertices(k: Complex, expected: Manifold) -> None:
    """Clauses: CPLX-MANIFOLD-1, CPLX-MANIFOLD-10."""
    assert manifold(k) == expected


def test_no_recogniser_is_asked_up_to_dimension_3() -> None:
    """Clause: CPLX-MANIFOLD-2."""
    for n in range(4):
        assert manifold(SPHERES[n].complex, shy) == manifold(SPHERES[n].complex)
        assert isinstance(manifold(SPHERES[n].complex, shy), Manifold)


def test_the_poincare_sphere_is_not_taken_for_a_sphere() -> None:
    """It is a 3-manifold with the homology of the 3-sphere. Clauses: CPLX-SPHERE-2, -3."""
    assert looks(POINCARE.complex, 3) is Looks.SPHERE
    expected = Undecided("has the homology of a sphere; no moves were tried")
    assert recognise(POINCARE.complex) == expected
    assert isinstance(by_moves(POINCARE.complex), Undecided)


CIRCLE = ((0, 1), (1, 2), (0, 2))
SUSPENDED_MOEBIUS = coned(MOEBIUS_BAND.complex, 8, 9)


@pytest.mark.parametrize(
    ("k", "simplex", "flaw"),
    [
        (FIGURE_8.complex, at(0, 6), Flaw.NOT_PURE),
        (ONE_OF_EACH.complex, at(7), Flaw.NOT_PURE),
        (closure([(0, 1, 2, 3), (4, 5, 6), (1, 8)]), at(1, 8), Flaw.NOT_PURE),
        (closure([(0, 1, 2), (2, 4), (1, 4)]), at(1, 4), Flaw.NOT_PURE),
        (BOOK.complex, at(0, 1), Flaw.CROWDED_WALL),
        (DUNCE.complex, at(0, 1), Flaw.CROWDED_WALL),
        (closure([(5, 1), (5, 2), (5, 3)]), at(5), Flaw.CROWDED_WALL),
        (closure([(1, 2, 3, v) for v in range(4, 7)]), at(1, 2, 3), Flaw.CROWDED_WALL),
        (BOW_TIE.complex, at(0), Flaw.DISCONNECTED),
        (INTERIOR_PINCH.complex, at(0), Flaw.DISCONNECTED),
        (TWO_SPHERES.complex, at(0), Flaw.DISCONNECTED),
        (closure([(0, 1, 2, 3), (3, 4, 5, 6)]), at(3), Flaw.DISCONNECTED),
        (closure([(0, 1, 2, 3), (2, 3, 4, 5)]), at(2), Flaw.BAD_LINK),
        (coned(BOW_TIE.complex, 9), at(0), Flaw.BAD_LINK),
        (SUSPENDED_PLANE.complex, at(6), Flaw.WRONG_HOMOLOGY),
        (SUSPENDED_TORUS.complex, at(7), Flaw.WRONG_HOMOLOGY),
        (coned(PROJECTIVE.complex, 6), at(6), Flaw.WRONG_HOMOLOGY),
        (SUSPENDED_MOEBIUS, at(8), Flaw.WRONG_HOMOLOGY),
    ],
)
def test_the_simplex_to_blame(k: Complex, simplex: frozenset[int], flaw: Flaw) -> None:
    """Found by hand: the lowest, by the order of CPLX-MANIFOLD-3."""
    assert manifold(k) == NotManifold(simplex, flaw)


@pytest.mark.parametrize(
    ("k", "expected"),
    [
        (EMPTY, Sphere(-1)),
        (closure([[3]]), Ball(0)),
        (closure([[3], [4]]), Sphere(0)),
        (closure([[3], [4], [5]]), Neither(Flaw.DISCONNECTED)),
        (closure(CIRCLE), Sphere(1)),
        (closure(CIRCLE[:2]), Ball(1)),
        (closure([(0, 1), (2, 3)]), Neither(Flaw.DISCONNECTED)),
        (closure([(0, 1), (2,)]), Neither(Flaw.NOT_PURE)),
        (closure([(0, 1), (0, 2), (0, 3)]), Neither(Flaw.CROWDED_WALL)),
        (SPHERES[2].complex, Sphere(2)),
        (BALLS[2].complex, Ball(2)),
        (TORUS.complex, Neither(Flaw.WRONG_HOMOLOGY)),
        (PROJECTIVE.complex, Neither(Flaw.WRONG_HOMOLOGY)),
        (MOEBIUS_BAND.complex, Neither(Flaw.WRONG_HOMOLOGY)),
        (closure([(0, 1, 2), (3, 4, 5)]), Neither(Flaw.DISCONNECTED)),
        (BOW_TIE.complex, Neither(Flaw.BAD_LINK)),
        (BOOK.complex, Neither(Flaw.CROWDED_WALL)),
        (FIGURE_8.complex, Neither(Flaw.NOT_PURE)),
        (SUSPENDED_TORUS.complex, Neither(Flaw.WRONG_HOMOLOGY)),
        (SPHERES[3].complex, Undecided("has the homology of a sphere; no moves were tried")),
        (BALLS[3].complex, Undecided("has the homology of a ball; no moves were tried")),
        (ONE_OF_EACH.complex, Neither(Flaw.NOT_PURE)),
    ],
)
def test_spheres_and_balls(k: Complex, expected: LinkKind) -> None:
    """Clauses: CPLX-SPHERE-1, CPLX-SPHERE-3."""
    assert recognise(k) == expected


def test_two_elements_see_the_twist() -> None:
    """The projective plane over the field of two elements: 1, 1, 1. Clause: CPLX-MANIFOLD-4."""
    assert over_gf2(PROJECTIVE.complex) == (Group(1, ()),) * 3


def test_a_point_does_not_look_like_the_empty_sphere() -> None:
    """What is maximal has an empty link, whose dimension must be right. Clause: CPLX-SPHERE-3."""
    assert looks(closure([[0]]), -1) is Looks.NEITHER
    assert looks(EMPTY, -1) is Looks.SPHERE
    assert looks(EMPTY, 0) is Looks.NEITHER


def test_a_solid_torus_is_bounded_by_a_torus() -> None:
    """Seven tetrahedra in a ring. Its boundary is Möbius' torus. Clause: CPLX-MANIFOLD-9."""
    k = closure([(i + j) % 7 for j in range(4)] for i in range(7))
    assert manifold(k) == Manifold(3, (), tuple(range(7)))
    answer = homeomorphism(boundary(k), TORUS.complex)
    assert answer == Accepted(Homeomorphic((Orientable(1, 0),)))
    assert homology_over_z(k)[1].rank == 1


@given(manifolds(4, genus=(0, 1), curves=(0, 1), components=(1, 1), moves=2))
@settings(max_examples=8)
def test_moves_prove_4_manifolds_made_to_order(of: Prescribed) -> None:
    """Clauses: CPLX-MANIFOLD-5, CPLX-MANIFOLD-10."""
    assert manifold(of.complex, by_moves) == manifold(of.complex, trusting)
    assert isinstance(manifold(of.complex, by_moves), Manifold)


FOUR_SPHERE = SPHERES[4].complex
SUSPENDED_POINCARE = coned(POINCARE.complex, 16, 17)


@pytest.mark.parametrize(
    ("k", "expected"),
    [
        (FOUR_SPHERE, Manifold(4, tuple(range(6)), ())),
        (BALLS[4].complex, Manifold(4, (), tuple(range(5)))),
        (coned(SPHERES[3].complex, 5), Manifold(4, (5,), (0, 1, 2, 3, 4))),
        (COMPLEX_PROJECTIVE.complex, Manifold(4, tuple(range(9)), ())),
    ],
)
def test_moves_prove_4_manifolds(k: Complex, expected: Manifold) -> None:
    """Clause: CPLX-MANIFOLD-5."""
    assert manifold(k, by_moves) == expected
    assert manifold(k, trusting) == expected


@pytest.mark.parametrize(
    ("k", "simplex", "flaw"),
    [
        (coned(SUSPENDED_TORUS.complex, 9), at(7), Flaw.WRONG_HOMOLOGY),
        (coned(coned(TORUS.complex, 7), 8, 9), at(7), Flaw.WRONG_HOMOLOGY),
        (coned(SUSPENDED_PLANE.complex, 8, 9), at(6), Flaw.WRONG_HOMOLOGY),
        (coned(ONE_OF_EACH.complex, 9), at(7, 9), Flaw.NOT_PURE),
        (closure((0, 1, 2, 3, v) for v in (4, 5, 6)), at(0, 1, 2, 3), Flaw.CROWDED_WALL),
        (closure(((0, 1, 2, 3, 4), (4, 5, 6, 7, 8))), at(4), Flaw.WRONG_HOMOLOGY),
        (closure(((0, 1, 2, 3, 4), (3, 4, 5, 6, 7))), at(3), Flaw.WRONG_HOMOLOGY),
    ],
)
@pytest.mark.parametrize("recogniser", [shy, recognise, by_moves])
def test_homology_refutes_4_manifolds(
    k: Complex, simplex: frozenset[int], flaw: Flaw, recogniser: Recogniser
) -> None:
    """Clauses: CPLX-MANIFOLD-3, CPLX-MANIFOLD-6."""
    assert manifold(k, recogniser) == NotManifold(simplex, flaw)


def test_the_suspension_of_the_poincare_sphere_is_not_proved() -> None:
    """Its suspension points have homology spheres for links. Clauses: CPLX-MANIFOLD-7, -6."""
    first = UndecidedAt(at(0), "has the homology of a sphere; no moves were tried")
    assert manifold(SUSPENDED_POINCARE) == first
    answer = manifold(SUSPENDED_POINCARE, by_moves)
    assert isinstance(answer, UndecidedAt)
    assert answer.simplex == at(16)


def test_a_refusal_of_the_recogniser_is_no_refutation() -> None:
    """The recogniser's Neither leaves it open; homology alone refutes. Clause: CPLX-MANIFOLD-7."""

    def refusing(k: Complex) -> LinkKind:
        return Neither(Flaw.BAD_LINK)

    assert manifold(FOUR_SPHERE, refusing) == UndecidedAt(at(0), Flaw.BAD_LINK)


def test_a_5_simplex_is_proved_and_its_links_are_asked_once_each() -> None:
    """Clause: CPLX-MANIFOLD-5: the links of vertices, not those of larger simplices."""
    asked: list[Complex] = []

    def counting(k: Complex) -> LinkKind:
        asked.append(k)
        return trusting(k)

    assert manifold(closure([range(6)]), counting) == Manifold(5, (), tuple(range(6)))
    faces = [closure(combinations(set(range(6)) - {v}, 5)) for v in range(6)]
    assert asked == faces
