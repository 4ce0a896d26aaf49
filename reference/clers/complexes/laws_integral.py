"""Laws of the Smith form and of homology over the integers."""

from itertools import pairwise
from typing import Final

from clers.complexes.given_every_dimension import COMPLEXES, MATRICES
from clers.complexes.homology import Field, betti
from clers.complexes.integral import Prime, betti_modulo, boundary_matrices, homology_over_z
from clers.complexes.simplicial import Complex, euler, pieces
from clers.complexes.smith import (
    Matrix,
    determinant,
    factors_by_minors,
    invariant_factors,
    smith,
)
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.verdict import Verdict

PRIMES: Final[tuple[Prime, ...]] = (2, 3, 5, 7)


def _factors(matrix: Matrix) -> Verdict:
    factors = factors_by_minors(matrix)
    sparse = [{j: x for j, x in enumerate(row) if x} for row in matrix]
    return every(
        same(factors, smith(matrix).factors),
        same(factors, invariant_factors(sparse)),
        same([0] * (len(factors) - 1), [b % a for a, b in pairwise(factors)]),
    )


def _certificate(matrix: Matrix) -> Verdict:
    form = smith(matrix)
    width = len(matrix[0]) if matrix else 0
    diagonal = tuple(
        tuple(form.factors[i] if i == j < len(form.factors) else 0 for j in range(width))
        for i in range(len(matrix))
    )
    return every(
        same((len(matrix), width), (len(form.left), len(form.right))),
        same((1, 1), (abs(determinant(form.left)), abs(determinant(form.right)))),
        same(diagonal, _product(_product(form.left, matrix), form.right)),
    )


def _product(a: Matrix, b: Matrix) -> Matrix:
    columns = list(zip(*b, strict=True))
    return tuple(
        tuple(sum(x * y for x, y in zip(row, column, strict=True)) for column in columns)
        for row in a
    )


def _squares_to_zero(k: Complex) -> Verdict:
    matrices = boundary_matrices(k)

    def composed(m: int, row: dict[int, int]) -> dict[int, int]:
        total: dict[int, int] = {}
        for i, x in row.items():
            for j, y in matrices[m - 1][i].items():
                total[j] = total.get(j, 0) + x * y
        return {j: x for j, x in total.items() if x}

    return every(
        *(same({}, composed(m, row)) for m in range(1, len(matrices)) for row in matrices[m])
    )


def _over_z(k: Complex) -> Verdict:
    groups = homology_over_z(k)
    return every(
        same(betti(k, Field.Q), tuple(group.rank for group in groups)),
        same(euler(k), sum((-1) ** m * group.rank for m, group in enumerate(groups))),
        same(
            [],
            [
                group
                for group in groups
                for a, b in zip((1, *group.torsion), group.torsion, strict=False)
                if b < 2 or b % a
            ],
        ),
    )


def _ends(k: Complex) -> Verdict:
    groups = homology_over_z(k)
    if not groups:
        return same(frozenset(), k.simplices)
    return every(
        same(len(pieces(k)), groups[0].rank),
        same(((), ()), (groups[0].torsion, groups[-1].torsion)),
    )


def _universal_coefficients(k: Complex) -> Verdict:
    groups = homology_over_z(k)

    def expected(p: Prime) -> tuple[int, ...]:
        divided = [0] + [sum(t % p == 0 for t in group.torsion) for group in groups]
        return tuple(group.rank + divided[m] + divided[m + 1] for m, group in enumerate(groups))

    return every(
        *(same(expected(p), betti_modulo(p, k)) for p in PRIMES),
        same(betti(k, Field.GF2), betti_modulo(2, k)),
    )


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "invariant-factors-are-quotients-of-minors",
        Clause.CPLX_SMITH_1,
        "The factors by steps, dense or sparse, are those by minors, and each divides the next.",
        MATRICES,
        _factors,
    ),
    Law(
        "smith-form-has-a-certificate",
        Clause.CPLX_SMITH_2,
        "U and V have determinant ±1, and U A V is the diagonal of the factors.",
        MATRICES,
        _certificate,
    ),
    Law(
        "boundary-matrices-compose-to-zero",
        Clause.CPLX_HOMOLOGY_1,
        "The boundary of the boundary of each simplex is the chain 0.",
        COMPLEXES,
        _squares_to_zero,
    ),
    Law(
        "rank-over-z-is-the-betti-number-over-q",
        Clause.CPLX_INTEGRAL_1,
        "Ranks are Betti numbers over Q; torsion coefficients exceed 1, each dividing the next.",
        COMPLEXES,
        _over_z,
    ),
    Law(
        "homology-has-no-torsion-at-its-ends",
        Clause.CPLX_INTEGRAL_2,
        "H_0 is free on the components, and the last homology group is free.",
        COMPLEXES,
        _ends,
    ),
    Law(
        "universal-coefficients",
        Clause.CPLX_INTEGRAL_3,
        "Betti numbers modulo p count the ranks, and torsion that p divides in two dimensions.",
        COMPLEXES,
        _universal_coefficients,
    ),
)
