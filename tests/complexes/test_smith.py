"""Smith forms of matrices small enough to work out by hand, and homology with torsion."""

import pytest

from clers.complexes.homology import Row
from clers.complexes.integral import (
    Group,
    betti_modulo,
    boundary_matrices,
    homology_over_z,
    rank_modulo,
)
from clers.complexes.known import MOORE, PROJECTIVE
from clers.complexes.simplicial import closure
from clers.complexes.smith import (
    Matrix,
    Smith,
    determinant,
    factors_by_minors,
    invariant_factors,
    smith,
)

# Worked out by minors with a pencil: 2·8 − 4·6 = −8 and the entries' divisor 2 give (2, 4).
BY_HAND: list[tuple[Matrix, tuple[int, ...]]] = [
    ((), ()),
    (((0,),), ()),
    (((-3,),), (3,)),
    (((2, 0), (0, 3)), (1, 6)),
    (((4, 0), (0, 6)), (2, 12)),
    (((2, 4), (6, 8)), (2, 4)),
    (((1, 2, 3), (4, 5, 6), (7, 8, 9)), (1, 3)),
    (((2, 4, 4), (-6, 6, 12), (10, -4, -16)), (2, 6, 12)),
    (((0, 0, 5),), (5,)),
    (((0,), (6,), (4,)), (2,)),
    (((6, 0, 0), (0, 10, 0), (0, 0, 15)), (1, 30, 30)),
]


@pytest.mark.parametrize(("matrix", "factors"), BY_HAND)
def test_factors_by_hand(matrix: Matrix, factors: tuple[int, ...]) -> None:
    """Clauses: CPLX-SMITH-1, CPLX-SMITH-2."""
    assert factors_by_minors(matrix) == factors
    assert smith(matrix).factors == factors
    sparse: list[Row] = [dict(enumerate(row)) for row in matrix]
    assert invariant_factors(sparse) == factors


def test_certificate_of_nothing_to_do() -> None:
    """Clause: CPLX-SMITH-2. A diagonal that is one already needs no step but a sign."""
    assert smith(((2, 0, 0), (0, -4, 0))) == Smith(
        (2, 4), ((1, 0), (0, -1)), ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    )
    assert smith(()) == Smith((), (), ())
    assert smith(((0, 0),)) == Smith((), ((1,),), ((1, 0), (0, 1)))


@pytest.mark.parametrize(
    ("matrix", "value"),
    [
        ((), 1),
        (((7,),), 7),
        (((0, 1), (1, 0)), -1),
        (((1, 2), (3, 4)), -2),
        (((0, 2, 1), (3, 0, 0), (0, 0, 5)), -30),
        (((1, 2, 3), (4, 5, 6), (7, 8, 9)), 0),
        (((2, 0, 0, 1), (0, 3, 0, 0), (0, 0, 0, 4), (0, 0, 5, 0)), -120),
    ],
)
def test_determinant(matrix: Matrix, value: int) -> None:
    """Clause: CPLX-SMITH-2. By expansion along rows with zeros."""
    assert determinant(matrix) == value


def test_sparse_rows_are_reduced_late() -> None:
    """Clause: CPLX-SMITH-1. A row without a unit waits for pivots found after it.

    Rows (2, 3), (1, 1): determinant −1, so both factors are 1.
    """
    assert invariant_factors([{0: 2, 1: 3}, {0: 1, 1: 1}]) == (1, 1)
    assert invariant_factors([{0: 2, 1: 2}, {0: 1, 1: 1}]) == (1,)
    assert invariant_factors([{5: 2}, {}, {9: 4, 5: 0}]) == (2, 4)


def test_rank_modulo() -> None:
    """Clause: CPLX-INTEGRAL-3. diag(2, 3) and a row of their sum."""
    rows: list[Row] = [{0: 2}, {1: 3}, {0: 2, 1: 3}]
    assert [rank_modulo(2, rows), rank_modulo(3, rows), rank_modulo(5, rows)] == [1, 1, 2]
    assert rank_modulo(3, [{0: 1, 1: 2}, {0: 2, 1: 1}]) == 1
    assert rank_modulo(5, [{0: 1, 1: 2}, {0: 2, 1: 1}]) == 2
    assert rank_modulo(7, [{0: 3, 1: 2, 2: 1}, {0: 1, 2: 5}, {0: 4, 1: 2, 2: 6}]) == 2


def test_boundary_matrices_of_a_triangle() -> None:
    """Clause: CPLX-HOMOLOGY-1. ∂012 = 12 − 02 + 01, and ∂ of an edge is its end less its start."""
    assert boundary_matrices(closure([(0, 1, 2)])) == [
        [{}, {}, {}],
        [{0: -1, 1: 1}, {0: -1, 2: 1}, {1: -1, 2: 1}],
        [{0: 1, 1: -1, 2: 1}],
        [],
    ]


def test_torsion() -> None:
    """Clauses: CPLX-INTEGRAL-1, CPLX-INTEGRAL-3. Order two is seen modulo 2, three modulo 3."""
    plane, moore = PROJECTIVE.complex, MOORE.complex
    assert homology_over_z(plane) == (Group(1, ()), Group(0, (2,)), Group(0, ()))
    assert homology_over_z(moore) == (Group(1, ()), Group(0, (3,)), Group(0, ()))
    assert [betti_modulo(2, plane), betti_modulo(3, plane)] == [(1, 1, 1), (1, 0, 0)]
    assert [betti_modulo(2, moore), betti_modulo(3, moore)] == [(1, 0, 0), (1, 1, 1)]
    assert betti_modulo(5, moore) == betti_modulo(7, moore) == (1, 0, 0)


def test_homology_of_nothing() -> None:
    """Clauses: CPLX-INTEGRAL-1, CPLX-INTEGRAL-2."""
    assert homology_over_z(closure([])) == ()
    assert betti_modulo(2, closure([])) == ()
    assert homology_over_z(closure([(0,), (3,)])) == (Group(2, ()),)
