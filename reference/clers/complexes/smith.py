"""The Smith normal form of integer matrices: by minors, with a certificate, and quickly if sparse.

All numbers are exact. A matrix is a tuple of its rows, all of one length.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise, takewhile
from math import gcd

from clers.complexes.homology import Row

Matrix = tuple[tuple[int, ...], ...]


@dataclass(frozen=True, slots=True)
class Smith:
    """The invariant factors of A, and U, V of determinant ±1 with U A V diagonal.

    `left` is U, with a row for each row of A; `right` is V, with one for each column. The diagonal
    has the factors, then zeros. Clause: CPLX-SMITH-2.
    """

    factors: tuple[int, ...]
    left: Matrix
    right: Matrix


def determinant(matrix: Sequence[Sequence[int]]) -> int:
    """The determinant of a square matrix, by divisions that leave no remainder (Bareiss)."""
    a = [list(row) for row in matrix]
    sign, last = 1, 1
    for t in range(len(a)):
        pivot = next((i for i in range(t, len(a)) if a[i][t]), None)
        if pivot is None:
            return 0
        if pivot != t:
            a[t], a[pivot], sign = a[pivot], a[t], -sign
        for i in range(t + 1, len(a)):
            for j in range(t + 1, len(a)):
                a[i][j] = (a[i][j] * a[t][t] - a[i][t] * a[t][j]) // last
        last = a[t][t]
    return sign * last


def factors_by_minors(matrix: Matrix) -> tuple[int, ...]:
    """The invariant factors as defined: quotients of greatest common divisors of minors.

    Exponential in the size. Clause: CPLX-SMITH-1.
    """
    transposed = tuple(zip(*matrix, strict=True))
    divisors = (
        gcd(
            *(
                determinant([[column[i] for i in rows] for column in columns])
                for rows in combinations(range(len(matrix)), k)
                for columns in combinations(transposed, k)
            )
        )
        for k in range(1, min(len(matrix), len(transposed)) + 1)
    )
    return tuple(b // a for a, b in pairwise((1, *takewhile(bool, divisors))))


def smith(matrix: Matrix) -> Smith:
    """The Smith form with its certificate, by row and column steps. Clause: CPLX-SMITH-2.

    A matrix without rows has no columns.
    """
    height, width = len(matrix), len(matrix[0]) if matrix else 0
    # Below A stand the rows of V, right of A the columns of U: a step on A is a step on them.
    a = [[*row, *unit] for row, unit in zip(matrix, _identity(height), strict=True)]
    a += [[*unit, *([0] * height)] for unit in _identity(width)]
    t = 0
    while (place := _least(a, t, height, width)) is not None:
        _swap(a, t, *place)
        if _clear(a, t, height, width):
            continue
        left = range(t + 1, height)
        odd = next((i for i in left if any(x % a[t][t] for x in a[i][:width])), None)
        if odd is not None:
            _add(a, odd, t, 1)
            continue
        if a[t][t] < 0:
            a[t] = [-x for x in a[t]]
        t += 1
    return Smith(
        tuple(a[i][i] for i in range(t)),
        tuple(tuple(row[width:]) for row in a[:height]),
        tuple(tuple(row[:width]) for row in a[height:]),
    )


def _identity(size: int) -> list[list[int]]:
    return [[int(i == j) for j in range(size)] for i in range(size)]


def _least(a: list[list[int]], t: int, height: int, width: int) -> tuple[int, int] | None:
    """The place of an entry that is not zero and the least such, below and right of t."""
    places = ((i, j) for i in range(t, height) for j in range(t, width) if a[i][j])
    return min(places, key=lambda at: abs(a[at[0]][at[1]]), default=None)


def _swap(a: list[list[int]], t: int, i: int, j: int) -> None:
    """Bring the entry at i, j to t, t."""
    a[t], a[i] = a[i], a[t]
    for row in a:
        row[t], row[j] = row[j], row[t]


def _clear(a: list[list[int]], t: int, height: int, width: int) -> bool:
    """Take the pivot out of its column and row; does something less than it remain in the row?"""
    for i in range(t + 1, height):
        _add(a, t, i, -(a[i][t] // a[t][t]))
    for j in range(t + 1, width):
        times = a[t][j] // a[t][t]
        for row in a:
            row[j] -= times * row[t]
    return any(a[t][t + 1 : width])


def _add(a: list[list[int]], source: int, target: int, times: int) -> None:
    """Add a multiple of one row to another."""
    a[target] = [y + times * x for x, y in zip(a[source], a[target], strict=True)]


def invariant_factors(rows: Iterable[Row]) -> tuple[int, ...]:
    """The invariant factors of a sparse matrix, without certificate. Clause: CPLX-SMITH-1.

    Rows are reduced by pivots ±1, in the order in which these were found: no pivot row has an entry
    in the column of an earlier one. What has no such pivot is left for the Smith form.
    """
    pivots: dict[int, Row] = {}
    rest: list[Row] = []
    for row in rows:
        left = _reduced(row, pivots)
        column = next((j for j, entry in left.items() if abs(entry) == 1), None)
        if column is None:
            rest.append(left)
        else:
            pivots[column] = left
    rest = [_reduced(row, pivots) for row in rest]
    columns = sorted({j for row in rest for j in row})
    dense = tuple(tuple(row.get(j, 0) for j in columns) for row in rest)
    return (1,) * len(pivots) + smith(dense).factors


def _reduced(row: Row, pivots: dict[int, Row]) -> Row:
    """The row without entries in the columns of pivots."""
    left = dict(row)
    for column, pivot in pivots.items():
        times = left.get(column, 0) * pivot[column]
        if times:
            for j, entry in pivot.items():
                left[j] = left.get(j, 0) - times * entry
                if not left[j]:
                    del left[j]
    return left
