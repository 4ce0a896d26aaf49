"""Complexes in space: points with rational coordinates, closed simplices that meet as they must."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations
from operator import le

from clers.complexes.affine import Point, corners_of_intersection, in_general_position, is_circuit
from clers.complexes.facets import Row, from_facets, row
from clers.complexes.simplex import frontier
from clers.complexes.simplicial import Complex, Simplex
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtFace, AtPair, AtSimplex, AtVertex

Pair = tuple[Row, Row]


@dataclass(frozen=True, slots=True)
class Geometric:
    """A complex, and for each vertex its point. Clauses: CPLX-GEOMETRIC-1 … CPLX-GEOMETRIC-5."""

    points: tuple[Point, ...]
    complex: Complex


def geometric(
    points: Sequence[Sequence[Fraction | int]], rows: Sequence[Sequence[int]]
) -> Accepted[Geometric] | Rejected:
    """The complex in space with these points and exactly these simplices, by their vertices.

    Rejects `count-mismatch` (CPLX-GEOMETRIC-1); what `from_facets` does, and `index-out-of-range`
    (CPLX-GEOMETRIC-2); `missing-face` (CPLX-GEOMETRIC-3); `degenerate-simplex` (CPLX-GEOMETRIC-4);
    `simplices-overlap` (CPLX-GEOMETRIC-5).
    """
    places = tuple(tuple(Fraction(x) for x in point) for point in points)
    for v, place in enumerate(places):
        if len(place) != len(places[0]):
            return Rejected(Reason.COUNT_MISMATCH, Clause.CPLX_GEOMETRIC_1, AtVertex(v))
    read = from_facets(rows)
    if isinstance(read, Rejected):
        return read
    for i, vertices in enumerate(rows):
        if max(vertices) >= len(places):
            return Rejected(Reason.INDEX_OUT_OF_RANGE, Clause.CPLX_GEOMETRIC_2, AtFace(i))
    if missing := missing_face(frozenset(map(frozenset, rows))):
        return Rejected(Reason.MISSING_FACE, Clause.CPLX_GEOMETRIC_3, AtPair(*missing))
    for vertices in by_size(read.value):
        if not in_general_position([places[v] for v in vertices]):
            return Rejected(Reason.DEGENERATE_SIMPLEX, Clause.CPLX_GEOMETRIC_4, AtSimplex(vertices))
    if pair := overlap(places, read.value):
        return Rejected(Reason.SIMPLICES_OVERLAP, Clause.CPLX_GEOMETRIC_5, AtPair(*pair))
    return Accepted(Geometric(places, read.value))


def by_size(k: Complex) -> list[Row]:
    """The simplices, those of fewest vertices first, in lexicographic order."""
    return sorted(map(row, k.simplices), key=lambda vertices: (len(vertices), vertices))


def missing_face(simplices: frozenset[Simplex]) -> Pair | None:
    """The first simplex with a face that is not given, and that face. Clause: CPLX-GEOMETRIC-3."""
    for vertices in sorted(map(row, simplices)):
        missing = frontier(frozenset(vertices)) - simplices
        if missing:
            return vertices, by_size(Complex(missing))[0]
    return None


def meet_properly(points: Sequence[Point], one: Row, other: Row) -> bool:
    """Do the closed simplices meet in that on their common vertices? Clause: CPLX-GEOMETRIC-5."""
    return all(
        {one[i] for i in first} <= set(other)
        for first, _ in corners_of_intersection(
            [points[v] for v in one], [points[v] for v in other]
        )
    )


def overlap(points: Sequence[Point], k: Complex) -> Pair | None:
    """The first two simplices without a common vertex that meet. Clause: CPLX-GEOMETRIC-6.

    All simplices of k are in general position. Only pairs whose boxes meet are looked at.
    """
    found = [
        (len(one) + len(other), min(one, other), max(one, other))
        for one, other in near_pairs(points, k)
        if len(one) + len(other) <= len(points[one[0]]) + 2
        and not set(one) & set(other)
        and is_circuit([points[v] for v in one], [points[v] for v in other])
    ]
    return min(found)[1:] if found else None


def near_pairs(points: Sequence[Point], k: Complex) -> Iterator[Pair]:
    """The pairs of simplices whose bounding boxes meet, each once.

    Simplices that meet have boxes that do. Clause: CPLX-GEOMETRIC-6.
    """
    boxes: list[tuple[Row, list[Fraction], list[Fraction]]] = []
    for vertices in map(row, k.simplices):
        axes = list(zip(*(points[v] for v in vertices), strict=True))
        boxes.append((vertices, [min(axis) for axis in axes], [max(axis) for axis in axes]))
    for (one, low, high), (other, other_low, other_high) in combinations(boxes, 2):
        if all(map(le, low, other_high)) and all(map(le, other_low, high)):
            yield one, other
