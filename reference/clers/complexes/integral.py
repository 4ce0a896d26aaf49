"""Homology over the integers, with torsion; and over fields of p elements, to compare."""

from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

from clers.complexes.homology import Row, boundary_rows
from clers.complexes.simplicial import Complex, dimension, of_dimension
from clers.complexes.smith import invariant_factors

Prime = Literal[2, 3, 5, 7]
"""A prime that Betti numbers are asked for: few, so that no other number can be asked for."""


@dataclass(frozen=True, slots=True)
class Group:
    """Z^rank ⊕ Z/t for each t of `torsion`, each dividing the next. Clause: CPLX-INTEGRAL-1."""

    rank: int
    torsion: tuple[int, ...]


def boundary_matrices(k: Complex) -> list[list[Row]]:
    """∂_0 … ∂_{n+1}, the first and the last of them zero. Clause: CPLX-HOMOLOGY-1."""
    simplices = [of_dimension(k, m) for m in range(-1, dimension(k) + 2)]
    return [boundary_rows(lower, upper) for lower, upper in pairwise(simplices)]


def homology_over_z(k: Complex) -> tuple[Group, ...]:
    """H_0 … H_n. Clauses: CPLX-INTEGRAL-1, CPLX-INTEGRAL-2."""
    matrices = boundary_matrices(k)
    factors = [invariant_factors(rows) for rows in matrices]
    return tuple(
        Group(
            len(matrices[m]) - len(factors[m]) - len(factors[m + 1]),
            tuple(d for d in factors[m + 1] if d > 1),
        )
        for m in range(dimension(k) + 1)
    )


def betti_modulo(p: Prime, k: Complex) -> tuple[int, ...]:
    """The Betti numbers over the field of p elements, by Gauss elimination. CPLX-INTEGRAL-3."""
    matrices = boundary_matrices(k)
    ranks = [rank_modulo(p, rows) for rows in matrices]
    return tuple(len(matrices[m]) - ranks[m] - ranks[m + 1] for m in range(dimension(k) + 1))


def rank_modulo(p: Prime, rows: list[Row]) -> int:
    """The rank over the field of p elements, each pivot the last entry of its row, made 1."""
    pivots: dict[int, Row] = {}
    for row in rows:
        left = {j: entry % p for j, entry in row.items() if entry % p}
        while left:
            last = max(left)
            if last not in pivots:
                inverse = pow(left[last], -1, p)
                pivots[last] = {j: entry * inverse % p for j, entry in left.items()}
                break
            times = left[last]
            for j, entry in pivots[last].items():
                value = (left.get(j, 0) - times * entry) % p
                if value:
                    left[j] = value
                else:
                    left.pop(j, None)
    return len(pivots)
