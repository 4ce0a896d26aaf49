"""Homology of small complexes over the field of two elements and over the rationals.

An independent witness: b_0 counts components, b_1 the handles and curves, b_2 the closed
orientable components, and none of them knows about corners, curves or orientations.
"""

from collections.abc import Iterable, Sequence
from enum import Enum
from fractions import Fraction
from typing import assert_never

from clers.complexes.simplicial import Complex, Simplex, dimension, of_dimension


class Field(Enum):
    """The field that chains have their coefficients in. Clause: CPLX-HOMOLOGY-1."""

    GF2 = "GF(2)"
    Q = "Q"


Row = dict[int, int]
"""A row of a boundary matrix: the columns of its non-zero entries, each +1 or −1."""


def boundary_rows(lower: Sequence[Simplex], upper: Iterable[Simplex]) -> list[Row]:
    """∂: one row for each upper simplex, one column for each lower one.

    The simplex with vertices v_0 < … < v_m has at its face without v_i the entry (−1)^i; faces that
    are not among `lower` are left out, as in relative homology. Clause: CPLX-HOMOLOGY-1.
    """
    column = {simplex: j for j, simplex in enumerate(lower)}
    rows: list[Row] = []
    for simplex in upper:
        faces = [(simplex - {v}, (-1) ** i) for i, v in enumerate(sorted(simplex))]
        rows.append({column[face]: sign for face, sign in faces if face in column})
    return rows


def rank(rows: Iterable[Row], field: Field) -> int:
    """The rank of a matrix, exact. Clause: CPLX-HOMOLOGY-1."""
    match field:
        case Field.GF2:
            return rank_over_gf2(rows)
        case Field.Q:
            return rank_over_q(rows)
        case _:
            assert_never(field)


def rank_over_gf2(rows: Iterable[Row]) -> int:
    """Gauss elimination on rows as sets of bits, each pivot the highest bit of its row."""
    pivots: dict[int, int] = {}
    for row in rows:
        bits = sum(1 << j for j, entry in row.items() if entry % 2)
        while bits and bits.bit_length() in pivots:
            bits ^= pivots[bits.bit_length()]
        if bits:
            pivots[bits.bit_length()] = bits
    return len(pivots)


def rank_over_q(rows: Iterable[Row]) -> int:
    """Gauss elimination on sparse rows of fractions, each pivot the last entry of its row."""
    pivots: dict[int, dict[int, Fraction]] = {}
    for row in rows:
        left = {j: Fraction(entry) for j, entry in row.items() if entry}
        while left and (last := max(left)) in pivots:
            factor = left[last] / pivots[last][last]
            for j, entry in pivots[last].items():
                value = left.get(j, Fraction(0)) - factor * entry
                if value:
                    left[j] = value
                else:
                    left.pop(j, None)
        if left:
            pivots[max(left)] = left
    return len(pivots)


def betti(k: Complex, field: Field) -> tuple[int, ...]:
    """b_0 … b_n with b_m = #m − rank ∂_m − rank ∂_{m+1}.

    Clauses: CPLX-HOMOLOGY-1; what they are for surfaces: CPLX-HOMOLOGY-2; with χ: CPLX-HOMOLOGY-3.
    """
    n = dimension(k)
    simplices = [of_dimension(k, m) for m in range(n + 2)]
    ranks = [0] + [
        rank(boundary_rows(simplices[m - 1], simplices[m]), field) for m in range(1, n + 2)
    ]
    return tuple(len(simplices[m]) - ranks[m] - ranks[m + 1] for m in range(n + 1))


def coherent_chains(k: Complex, field: Field) -> int:
    """The dimension of the chains of n-simplices that cancel wherever two of these meet.

    Over the rationals the number of orientable sets of neighbours, over GF(2) of all of them,
    where no (n−1)-simplex lies in more than two n-simplices. Clause: CPLX-ORIENT-2.
    """
    n = dimension(k)
    largest = of_dimension(k, n)
    walls = [s for s in of_dimension(k, n - 1) if sum(s < big for big in largest) == 2]
    return len(largest) - rank(boundary_rows(walls, largest), field)
