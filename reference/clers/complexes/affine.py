"""Exact affine geometry over the rationals: kernels, general position, convex combinations."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations

Point = tuple[Fraction, ...]
Column = tuple[Fraction, ...]

ONE, ZERO = Fraction(1), Fraction(0)


def kernel(columns: Sequence[Column]) -> list[list[Fraction]]:
    """A basis of the relations: coefficients that take the columns, of one height, to zero.

    Each relation has the coefficient 1 at a column, and 0 at all later ones.
    """
    basis: list[list[Fraction]] = []
    # Each entry is a column made from the given ones, not zero at its pivot, with how it was made.
    made: list[tuple[int, list[Fraction], list[Fraction]]] = []
    for number, column in enumerate(columns):
        left = list(column)
        how = [ONE if i == number else ZERO for i in range(len(columns))]
        for pivot, other, recipe in made:
            if left[pivot]:
                times = left[pivot] / other[pivot]
                left = [x - times * y for x, y in zip(left, other, strict=True)]
                how = [x - times * y for x, y in zip(how, recipe, strict=True)]
        place = next((i for i, x in enumerate(left) if x), None)
        if place is None:
            basis.append(how)
        else:
            made.append((place, left, how))
    return basis


def in_general_position(points: Sequence[Point]) -> bool:
    """Are the points affinely independent? Clause: CPLX-GEOMETRIC-4."""
    return not kernel([(ONE, *point) for point in points])


def is_circuit(one: Sequence[Point], other: Sequence[Point]) -> bool:
    """Do the closed hulls meet, inside both, in one point, and no faces of them meet?

    That is: there is one affine dependence, positive on the first and negative on the others.
    Clause: CPLX-GEOMETRIC-6.
    """
    relations = kernel([(ONE, *p) for p in one] + [(-ONE, *(-x for x in q)) for q in other])
    return len(relations) == 1 and all(x > 0 for x in relations[0])


Meeting = tuple[tuple[int, ...], tuple[int, ...]]


def corners_of_intersection(one: Sequence[Point], other: Sequence[Point]) -> list[Meeting]:
    """The corners of the set of all ways to write a point as a convex combination of both.

    For each corner the numbers of the points whose coefficients are positive, of the first and of
    the others. The hulls are disjoint exactly if there is no corner. By trying all sets of points:
    exponential. Clause: CPLX-GEOMETRIC-5.
    """
    columns = [(ONE, ZERO, *p) for p in one] + [(ZERO, ONE, *(-x for x in q)) for q in other]
    if not one or not other:
        return []
    target = (-ONE, -ONE, *(ZERO for _ in one[0]))
    found: list[Meeting] = []
    for size in range(2, len(target) + 1):
        for chosen in combinations(range(len(columns)), size):
            relations = kernel([*(columns[i] for i in chosen), target])
            if len(relations) == 1 and all(x > 0 for x in relations[0]):
                first = tuple(i for i in chosen if i < len(one))
                found.append((first, tuple(i - len(one) for i in chosen if i >= len(one))))
    return found
