"""Oriented simplices and coherence, by examples worked out with a pencil."""

from itertools import permutations, product

import pytest

from clers.complexes.known import (
    BOOK,
    FIGURE_8,
    KLEIN,
    KNOWN,
    MOEBIUS_BAND,
    PROJECTIVE,
    SPHERES,
    TORUS,
    Known,
)
from clers.complexes.manifolds.certificates import is_coherent, is_one_sided
from clers.complexes.manifolds.kind import Flaw
from clers.complexes.manifolds.orient import OneSided, Oriented, orient
from clers.complexes.manifolds.orientation import (
    OrientedSimplex,
    induced,
    joined,
    next_vertex,
    opposite,
    ordering,
    oriented,
    previous_vertex,
)
from clers.complexes.simplicial import Complex, closure
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSimplex, AtVertex

EMPTY = Complex(frozenset())


def positive(*vertices: int) -> OrientedSimplex:
    return OrientedSimplex(vertices, positive=True)


def negative(*vertices: int) -> OrientedSimplex:
    return OrientedSimplex(vertices, positive=False)


def at(*vertices: int) -> frozenset[int]:
    return frozenset(vertices)


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ((5,), positive(5)),
        ((2, 7), positive(2, 7)),
        ((7, 2), negative(2, 7)),
        ((1, 2, 3), positive(1, 2, 3)),
        ((2, 3, 1), positive(1, 2, 3)),
        ((3, 2, 1), negative(1, 2, 3)),
        ((1, 0, 3, 2), positive(0, 1, 2, 3)),
        ((1, 2, 3, 0), negative(0, 1, 2, 3)),
    ],
)
def test_orderings(given: tuple[int, ...], expected: OrientedSimplex) -> None:
    """Clause: CPLX-COHERENT-1."""
    assert oriented(given) == Accepted(expected)


def test_what_is_no_ordering() -> None:
    """Clause: CPLX-COHERENT-1."""
    clause = Clause.CPLX_COHERENT_1
    assert oriented(()) == Rejected(Reason.EMPTY_SIMPLEX, clause)
    assert oriented((4, 2, 3, 2, 4)) == Rejected(Reason.REPEATED_VERTEX, clause, AtVertex(2))


def test_the_least_ordering_represents() -> None:
    """Clause: CPLX-COHERENT-1."""
    assert ordering(positive(1, 4, 6)) == (1, 4, 6)
    assert ordering(negative(1, 4, 6)) == (1, 6, 4)
    assert ordering(negative(1, 4)) == (4, 1)
    assert ordering(negative(1, 4, 6, 8)) == (1, 4, 8, 6)
    assert ordering(opposite(negative(3))) == (3,)


def test_walls_of_a_triangle_and_a_tetrahedron() -> None:
    """(0,1,2) runs 1→2, 2→0, 0→1; of (0,1,2,3) the wall 0,2,3 is reversed. CPLX-COHERENT-2."""
    triangle, tetrahedron = positive(0, 1, 2), positive(0, 1, 2, 3)
    walls = [ordering(induced(triangle, v)) for v in range(3)]
    assert walls == [(1, 2), (2, 0), (0, 1)]
    assert induced(tetrahedron, 1) == negative(0, 2, 3)
    assert induced(opposite(tetrahedron), 2) == negative(0, 1, 3)
    assert joined(1, negative(0, 2, 3)) == tetrahedron
    assert joined(9, positive(0, 2, 3)) == negative(0, 2, 3, 9)


def test_around_a_triangle() -> None:
    """Clause: CPLX-COHERENT-7."""
    turning = [next_vertex(negative(3, 5, 8), v) for v in (3, 5, 8)]
    assert turning == [Accepted(8), Accepted(3), Accepted(5)]
    back = [previous_vertex(negative(3, 5, 8), v) for v in (3, 5, 8)]
    assert back == [Accepted(5), Accepted(8), Accepted(3)]
    refused = Rejected(Reason.OPERATOR_NOT_APPLICABLE, Clause.CPLX_COHERENT_7, AtVertex(4))
    assert next_vertex(positive(3, 5, 8), 4) == refused
    assert previous_vertex(positive(4, 5), 4) == refused
    assert next_vertex(positive(1, 2, 3, 4), 4) == refused


@pytest.mark.parametrize("known", KNOWN, ids=lambda known: known.name)
def test_orientable_as_the_literature_says(known: Known) -> None:
    """Clauses: CPLX-COHERENT-3, CPLX-COHERENT-4, CPLX-COHERENT-5."""
    answer = orient(known.complex)
    if known.manifold:
        assert isinstance(answer, Oriented) == known.orientable
    match answer:
        case Oriented():
            assert is_coherent(known.complex, answer)
        case OneSided():
            assert is_one_sided(known.complex, answer)
        case Rejected():
            assert not known.manifold


def test_orientations_by_hand() -> None:
    """Each answer begins with the lowest, positive. Clause: CPLX-COHERENT-3."""
    assert orient(EMPTY) == Oriented(())
    assert orient(closure([[4], [1]])) == Oriented((positive(1), positive(4)))
    path = Oriented((positive(0, 1), positive(1, 2)))
    assert orient(closure([(0, 1), (1, 2)])) == path
    assert orient(closure([(0, 2), (1, 2)])) == Oriented((positive(0, 2), negative(1, 2)))
    two = closure([(0, 1, 2), (0, 1, 3), (5, 6, 7)])
    assert orient(two) == Oriented((positive(0, 1, 2), negative(0, 1, 3), positive(5, 6, 7)))


def test_every_orientation_of_small_surfaces() -> None:
    """All 2^m tried: two of the tetrahedron are coherent, none of the plane. CPLX-COHERENT-6."""
    for k, expected in (
        (SPHERES[2].complex, 2),
        (MOEBIUS_BAND.complex, 0),
        (PROJECTIVE.complex, 0),
    ):
        triangles = sorted(tuple(sorted(s)) for s in k.simplices if len(s) == 3)
        tried = [
            Oriented(tuple(map(OrientedSimplex, triangles, signs)))
            for signs in product((True, False), repeat=len(triangles))
        ]
        assert sum(is_coherent(k, orientation) for orientation in tried) == expected


MOEBIUS_CYCLE = tuple(at(i, (i + 1) % 5, (i + 2) % 5) for i in range(5))


def test_the_moebius_band_is_its_own_cycle() -> None:
    """Clause: CPLX-COHERENT-4."""
    k = MOEBIUS_BAND.complex
    assert is_one_sided(k, OneSided(MOEBIUS_CYCLE))
    answer = orient(k)
    assert isinstance(answer, OneSided)
    assert set(answer.cycle) == set(MOEBIUS_CYCLE)


def test_cycles_that_prove_nothing() -> None:
    """Clause: CPLX-COHERENT-4."""
    k = MOEBIUS_BAND.complex
    assert not is_one_sided(k, OneSided(()))
    assert not is_one_sided(k, OneSided(MOEBIUS_CYCLE[:1]))
    assert not is_one_sided(k, OneSided(MOEBIUS_CYCLE[:2]))
    assert not is_one_sided(k, OneSided(MOEBIUS_CYCLE[:4]))
    assert not is_one_sided(k, OneSided((*MOEBIUS_CYCLE, *MOEBIUS_CYCLE)))
    assert not is_one_sided(k, OneSided((*MOEBIUS_CYCLE, *MOEBIUS_CYCLE, *MOEBIUS_CYCLE)))
    assert not is_one_sided(k, OneSided(tuple(at(i, i + 1) for i in range(4))))
    assert not is_one_sided(EMPTY, OneSided(MOEBIUS_CYCLE))
    tetrahedron = SPHERES[2].complex
    around = [at(0, 1, 2), at(0, 2, 3), at(0, 1, 3)]
    assert not is_one_sided(tetrahedron, OneSided(tuple(around)))
    assert not is_one_sided(TORUS.complex, OneSided(tuple(at(i, i + 1, i + 3) for i in range(4))))


def test_simplices_of_a_cycle_are_in_the_complex() -> None:
    """With a new vertex in the first triangle: all walls are there, but not the triangle itself.

    Clause: CPLX-COHERENT-4.
    """
    k = closure([*MOEBIUS_CYCLE[1:], (0, 1, 9), (1, 2, 9), (0, 2, 9)])
    assert not is_one_sided(k, OneSided(MOEBIUS_CYCLE))
    assert isinstance(orient(k), OneSided)


def test_a_stem_is_no_part_of_the_cycle() -> None:
    """A strip leads to the band. From its triangle 0 the search goes both ways: 1 and 4, 2 and 3.

    Clause: CPLX-COHERENT-4.
    """
    band = [at(*(10 + v for v in triangle)) for triangle in MOEBIUS_CYCLE]
    k = closure([(0, 1, 2), (1, 2, 3), (2, 3, 10), (3, 10, 12), *band])
    assert orient(k) == OneSided((band[2], band[1], band[0], band[4], band[3]))


def test_a_cycle_across_a_wall_in_three_proves_nothing() -> None:
    """The Möbius band with a third triangle at one of its walls. Clause: CPLX-COHERENT-4."""
    k = closure([*MOEBIUS_CYCLE, (1, 2, 9)])
    assert not is_one_sided(k, OneSided(MOEBIUS_CYCLE))


def test_points_have_no_one_sided_cycle() -> None:
    """Clause: CPLX-COHERENT-4."""
    k = closure([[0], [1], [2]])
    assert not is_one_sided(k, OneSided((at(0), at(1), at(2))))


def test_orientations_that_are_none() -> None:
    """Clause: CPLX-COHERENT-2."""
    k = closure([(0, 1, 2), (0, 1, 3)])
    good = (positive(0, 1, 2), negative(0, 1, 3))
    assert is_coherent(k, Oriented(good))
    assert is_coherent(k, Oriented(good[::-1]))
    assert is_coherent(k, Oriented(tuple(map(opposite, good))))
    assert not is_coherent(k, Oriented((positive(0, 1, 2), positive(0, 1, 3))))
    assert not is_coherent(k, Oriented(good[:1]))
    assert not is_coherent(k, Oriented((*good, good[0])))
    assert not is_coherent(k, Oriented((*good, positive(0, 2, 3))))


def test_a_wall_in_three_asks_nothing() -> None:
    """Clause: CPLX-COHERENT-2 is about walls that lie in two."""
    for signs in product((True, False), repeat=3):
        triangles = [(0, 1, 2), (0, 1, 3), (0, 1, 4)]
        assert is_coherent(BOOK.complex, Oriented(tuple(map(OrientedSimplex, triangles, signs))))


@pytest.mark.parametrize(
    ("k", "simplex", "flaw"),
    [
        (BOOK.complex, (0, 1), Flaw.CROWDED_WALL),
        (FIGURE_8.complex, (0, 6), Flaw.NOT_PURE),
        (closure([(8, 1), (8, 2), (8, 3)]), (8,), Flaw.CROWDED_WALL),
        (closure([(8, 1, 2), (8, 1, 3), (8, 1, 4)]), (1, 8), Flaw.CROWDED_WALL),
    ],
)
def test_what_cannot_be_asked(k: Complex, simplex: tuple[int, ...], flaw: Flaw) -> None:
    """Clause: CPLX-COHERENT-8."""
    expected = Rejected(Reason.NOT_A_MANIFOLD, Clause.CPLX_COHERENT_8, AtSimplex(simplex), flaw)
    assert orient(k) == expected


def test_cycles_are_short() -> None:
    """No simplex twice; begun elsewhere or run backwards it is a cycle too. CPLX-COHERENT-4."""
    for known in (PROJECTIVE, KLEIN):
        answer = orient(known.complex)
        assert isinstance(answer, OneSided)
        assert len(set(answer.cycle)) == len(answer.cycle) < known.f_vector[2]
        for turned in range(len(answer.cycle)):
            rotated = OneSided(answer.cycle[turned:] + answer.cycle[:turned])
            assert is_one_sided(known.complex, rotated)
            assert is_one_sided(known.complex, OneSided(rotated.cycle[::-1]))


def test_parity_is_that_of_transpositions() -> None:
    """Against the determinant of the permutation's matrix, for four vertices. CPLX-COHERENT-1."""
    for given in permutations(range(4)):
        sign = 1
        for i in range(4):
            for j in range(i):
                sign *= 1 if given[j] < given[i] else -1
        assert oriented(given) == Accepted(OrientedSimplex((0, 1, 2, 3), sign == 1))
