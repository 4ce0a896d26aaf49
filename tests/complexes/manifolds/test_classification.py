"""Types of surfaces known from books, their names, and their connected sums."""

import pytest

from clers.complexes.known import (
    ANNULUS,
    BALLS,
    BOOK,
    BOW_TIE,
    FIGURE_8,
    KLEIN,
    MOEBIUS_BAND,
    OCTAHEDRON,
    PROJECTIVE,
    SPHERES,
    TORUS,
    Known,
)
from clers.complexes.manifolds.classification import (
    Distinct,
    Homeomorphic,
    classify,
    homeomorphism,
)
from clers.complexes.manifolds.connected_sum import Summand, connected_sum
from clers.complexes.manifolds.kind import Flaw
from clers.complexes.manifolds.surface_type import (
    NonOrientable,
    Orientable,
    SurfaceType,
    in_words,
    summed,
)
from clers.complexes.simplicial import Complex, closure, of_dimension
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtPair, AtSimplex

SPHERE, DISC, RING = Orientable(0, 0), Orientable(0, 1), Orientable(0, 2)
PLANE, BOTTLE, BAND = NonOrientable(1, 0), NonOrientable(2, 0), NonOrientable(1, 1)


def glued(first: Complex, at: tuple[int, ...], second: Complex, other: tuple[int, ...]) -> Complex:
    answer = connected_sum(Summand(first, at), Summand(second, other))
    assert isinstance(answer, Accepted), answer
    return answer.value


def first_triangle(k: Complex) -> tuple[int, ...]:
    return tuple(sorted(of_dimension(k, 2)[0]))


def summed_up(*surfaces: Known) -> Complex:
    k = surfaces[0].complex
    for other in surfaces[1:]:
        k = glued(k, first_triangle(k), other.complex, first_triangle(other.complex))
    return k


@pytest.mark.parametrize(
    ("known", "expected"),
    [
        (SPHERES[2], SPHERE),
        (BALLS[2], DISC),
        (OCTAHEDRON, SPHERE),
        (ANNULUS, RING),
        (TORUS, Orientable(1, 0)),
        (PROJECTIVE, PLANE),
        (KLEIN, BOTTLE),
        (MOEBIUS_BAND, BAND),
    ],
)
def test_types_of_known_surfaces(known: Known, expected: SurfaceType) -> None:
    """Clauses: CPLX-CLASSIFY-1, CPLX-CLASSIFY-2."""
    assert classify(known.complex) == Accepted((expected,))
    assert expected.euler == known.euler


@pytest.mark.parametrize(
    ("of", "euler", "name"),
    [
        (SPHERE, 2, "sphere"),
        (DISC, 1, "disc"),
        (RING, 0, "annulus"),
        (Orientable(0, 3), -1, "sphere with 3 discs removed"),
        (Orientable(1, 0), 0, "torus"),
        (Orientable(1, 1), -1, "torus with 1 disc removed"),
        (Orientable(1, 2), -2, "torus with 2 discs removed"),
        (Orientable(2, 0), -2, "sphere with 2 handles"),
        (Orientable(3, 1), -5, "sphere with 3 handles and 1 disc removed"),
        (PLANE, 1, "projective plane"),
        (BAND, 0, "Möbius band"),
        (NonOrientable(1, 2), -1, "projective plane with 2 discs removed"),
        (BOTTLE, 0, "Klein bottle"),
        (NonOrientable(2, 1), -1, "Klein bottle with 1 disc removed"),
        (NonOrientable(3, 0), -1, "sphere with 3 cross-caps"),
        (NonOrientable(4, 2), -4, "sphere with 4 cross-caps and 2 discs removed"),
    ],
)
def test_names(of: SurfaceType, euler: int, name: str) -> None:
    """Clauses: CPLX-CLASSIFY-2, CPLX-CLASSIFY-3."""
    assert of.euler == euler
    assert in_words(of) == name


def test_components_in_the_order_of_their_lowest_vertices() -> None:
    """Clause: CPLX-CLASSIFY-1."""
    plane = closure(frozenset(v + 10 for v in s) for s in PROJECTIVE.complex.simplices)
    both = Complex(plane.simplices | BALLS[2].complex.simplices)
    assert classify(both) == Accepted((DISC, PLANE))


def test_what_is_no_surface() -> None:
    """Clause: CPLX-CLASSIFY-5."""
    clause = Clause.CPLX_CLASSIFY_5
    other = Rejected(Reason.UNSUPPORTED_DIMENSION, clause, WHOLE, "dimension 3")
    assert classify(BALLS[3].complex) == other
    empty = Rejected(Reason.UNSUPPORTED_DIMENSION, clause, WHOLE, "dimension -1")
    assert classify(Complex(frozenset())) == empty
    for known, at, flaw in (
        (BOOK, (0, 1), Flaw.CROWDED_WALL),
        (FIGURE_8, (0, 6), Flaw.NOT_PURE),
        (BOW_TIE, (0,), Flaw.DISCONNECTED),
    ):
        expected = Rejected(Reason.NOT_A_MANIFOLD, clause, AtSimplex(at), flaw)
        assert classify(known.complex) == expected
        assert homeomorphism(known.complex, TORUS.complex) == expected
        assert homeomorphism(TORUS.complex, known.complex) == expected


def test_the_simplex_to_blame_is_named_in_increasing_order() -> None:
    """Clause: CPLX-CLASSIFY-5."""
    answer = classify(closure([(8, 1, 2), (8, 1, 3), (8, 1, 4)]))
    assert isinstance(answer, Rejected)
    assert answer.where == AtSimplex((1, 8))


def test_two_planes_are_a_klein_bottle() -> None:
    """And three, or one and a torus, are the same (W. Dyck). CPLX-SUM-2, CPLX-CLASSIFY-4."""
    two = summed_up(PROJECTIVE, PROJECTIVE)
    assert homeomorphism(two, KLEIN.complex) == Accepted(Homeomorphic((BOTTLE,)))
    three = summed_up(PROJECTIVE, PROJECTIVE, PROJECTIVE)
    mixed = summed_up(TORUS, PROJECTIVE)
    assert homeomorphism(three, mixed) == Accepted(Homeomorphic((NonOrientable(3, 0),)))
    assert homeomorphism(mixed, two) == Accepted(Distinct((NonOrientable(3, 0),), (BOTTLE,)))


def test_the_torus_is_not_the_klein_bottle() -> None:
    """Both have χ = 0. Clause: CPLX-CLASSIFY-4."""
    answer = homeomorphism(TORUS.complex, KLEIN.complex)
    assert answer == Accepted(Distinct((Orientable(1, 0),), (BOTTLE,)))


def beside(*parts: Complex) -> Complex:
    return Complex(
        frozenset(
            frozenset(100 * i + v for v in s)
            for i, part in enumerate(parts)
            for s in part.simplices
        )
    )


def test_types_are_counted() -> None:
    """Orientable ones first, then by falling χ, then by curves. Clause: CPLX-CLASSIFY-4."""
    sphere, disc, torus = SPHERES[2].complex, BALLS[2].complex, TORUS.complex
    plane, band, ring = PROJECTIVE.complex, MOEBIUS_BAND.complex, ANNULUS.complex
    many = beside(band, ring, plane, torus, disc, sphere, disc)
    few = beside(sphere, band, disc)
    missing = (DISC, Orientable(1, 0), RING, PLANE)
    assert homeomorphism(many, few) == Accepted(Distinct(missing, ()))
    assert homeomorphism(few, many) == Accepted(Distinct((), missing))
    assert homeomorphism(few, beside(disc, sphere, band)) == Accepted(
        Homeomorphic((SPHERE, DISC, BAND))
    )


@pytest.mark.parametrize(
    ("first", "second", "expected"),
    [
        (Orientable(1, 2), Orientable(2, 1), Orientable(3, 3)),
        (Orientable(2, 0), NonOrientable(1, 1), NonOrientable(5, 1)),
        (NonOrientable(3, 1), Orientable(1, 0), NonOrientable(5, 1)),
        (NonOrientable(1, 0), NonOrientable(2, 2), NonOrientable(3, 2)),
    ],
)
def test_sums_of_types(first: SurfaceType, second: SurfaceType, expected: SurfaceType) -> None:
    """Clause: CPLX-SUM-2."""
    assert summed(first, second) == expected


def test_two_tetrahedra_become_a_bipyramid() -> None:
    """Vertices 0, 1, 2 are shared, in this order; 3 of the second becomes 9. CPLX-SUM-1."""
    first = closure([(0, 1, 2), (0, 1, 8), (0, 2, 8), (1, 2, 8)])
    second = SPHERES[2].complex
    expected = closure([(0, 1, 8), (0, 2, 8), (1, 2, 8), (0, 1, 9), (0, 2, 9), (1, 2, 9)])
    assert glued(first, (0, 1, 2), second, (3, 1, 2)) == expected
    assert glued(first, (2, 0, 1), second, (0, 1, 2)) == expected


def test_names_go_on_in_their_order() -> None:
    """Of the path 1, 3, 5, 7, glued at its end 1–3, 5 becomes 11 and 7 becomes 12. CPLX-SUM-1."""
    circle = closure([(0, 1), (0, 10), (1, 10)])
    path = closure([(1, 3), (3, 5), (5, 7)])
    expected = closure([(0, 10), (1, 10), (0,), (1, 11), (11, 12)])
    assert glued(circle, (0, 1), path, (1, 3)) == expected
    back = closure([(3, 5), (5, 8), (8, 1)])
    crossed = closure([(0, 10), (1, 10), (0,), (1, 12), (12, 11)])
    assert glued(circle, (0, 1), back, (3, 5)) == crossed


def test_one_inner_simplex_is_enough() -> None:
    """A triangle, glued on a sphere, is a disc; on a disc it is refused. CPLX-SUM-3."""
    disc, sphere = BALLS[2].complex, SPHERES[2].complex
    for answer in (
        glued(disc, (0, 1, 2), sphere, (0, 1, 2)),
        glued(sphere, (0, 1, 2), disc, (0, 1, 2)),
    ):
        assert classify(answer) == Accepted((DISC,))
    corner = Complex(sphere.simplices - {frozenset({1, 2, 3})})
    refused = connected_sum(Summand(disc, (2, 0, 1)), Summand(corner, (1, 0, 3)))
    assert refused == Rejected(
        Reason.OPERATOR_NOT_APPLICABLE,
        Clause.CPLX_SUM_3,
        AtPair((0, 1, 2), (0, 1, 3)),
        "both on the boundary",
    )


@pytest.mark.parametrize("at", [(0, 1), (2, 1, 1), (1, 0, 9), (2, 1, 0, 3), (1, 1, 2, 0), ()])
def test_what_is_no_facet(at: tuple[int, ...]) -> None:
    """Clause: CPLX-SUM-3."""
    sphere = SPHERES[2].complex
    where = AtSimplex(tuple(sorted(at)))
    why = Reason.OPERATOR_NOT_APPLICABLE
    expected = Rejected(why, Clause.CPLX_SUM_3, where, "not an n-simplex, n = 2")
    assert connected_sum(Summand(sphere, at), Summand(sphere, (0, 1, 2))) == expected
    assert connected_sum(Summand(sphere, (0, 1, 2)), Summand(sphere, at)) == expected


def test_sums_of_other_dimensions() -> None:
    """The dimension is that of the first. Clauses: CPLX-SUM-1, CPLX-SUM-3."""
    sphere, ball = SPHERES[2].complex, SPHERES[3].complex
    refused = connected_sum(Summand(ball, (0, 1, 2, 3)), Summand(sphere, (0, 1, 2)))
    assert isinstance(refused, Rejected)
    assert refused.where == AtSimplex((0, 1, 2))
    assert refused.detail == "not an n-simplex, n = 3"
    points = SPHERES[0].complex
    assert glued(points, (0,), points, (1,)) == closure([[1], [2]])
