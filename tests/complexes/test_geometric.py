"""Complexes in space: what is accepted, and with what blame the others are rejected."""

from fractions import Fraction

import pytest

from clers.complexes.affine import (
    corners_of_intersection,
    in_general_position,
    is_circuit,
    kernel,
)
from clers.complexes.facets import row
from clers.complexes.geometric import (
    Geometric,
    by_size,
    geometric,
    meet_properly,
    missing_face,
    near_pairs,
    overlap,
)
from clers.complexes.simplicial import Complex, closure
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtFace, AtPair, AtSimplex, AtVertex

Points = list[tuple[int | Fraction, ...]]
Rows = list[tuple[int, ...]]

SQUARE: Points = [(0, 0), (2, 0), (2, 2), (0, 2)]
LINE: Points = [(-1,), (1,), (0,)]
HALF = Fraction(1, 2)


def whole(*facets: tuple[int, ...]) -> Rows:
    """All simplices of the closure."""
    return by_size(closure(facets))


def overlapping(one: tuple[int, ...], other: tuple[int, ...]) -> Rejected:
    return Rejected(Reason.SIMPLICES_OVERLAP, Clause.CPLX_GEOMETRIC_5, AtPair(one, other))


def test_a_square_is_accepted() -> None:
    """Clauses: CPLX-GEOMETRIC-1, CPLX-GEOMETRIC-2, CPLX-GEOMETRIC-5."""
    answer = geometric(SQUARE, whole((0, 1, 2), (0, 2, 3)))
    points = tuple((Fraction(x), Fraction(y)) for x, y in SQUARE)
    assert answer == Accepted(Geometric(points, closure([(0, 1, 2), (0, 2, 3)])))


def test_nothing_is_accepted() -> None:
    """Clause: CPLX-GEOMETRIC-2. No point; no simplex; no coordinate."""
    assert isinstance(geometric([], []), Accepted)
    assert isinstance(geometric(SQUARE, []), Accepted)
    assert isinstance(geometric([()], [(0,)]), Accepted)
    assert geometric([(), ()], [(0,), (1,)]) == overlapping((0,), (1,))
    assert isinstance(geometric([(), ()], [(0,)]), Accepted)


# name, points, facets, the pair to blame: dependences worked out by hand
OVERLAPS: list[tuple[str, Points, Rows, Rows]] = [
    ("vertex inside an edge", LINE, [(0, 1), (2,)], [(0, 1), (2,)]),
    ("two vertices at one point", [(1, 2), (3, 4), (1, 2)], [(0, 1), (1, 2)], [(0,), (2,)]),
    ("edges that cross", SQUARE, [(0, 2), (1, 3)], [(0, 2), (1, 3)]),
    ("triangles that cross", SQUARE, [(0, 1, 2), (0, 1, 3)], [(0, 2), (1, 3)]),
    (
        "Figure 5(b): triangles whose edges cross, one corner each in the other",
        [(0, 0), (4, 0), (0, 4), (1, 1), (5, 1), (1, 5)],
        [(0, 1, 2), (3, 4, 5)],
        [(0, 1, 2), (3,)],
    ),
    (
        "a vertex on an edge, between triangles that share no other",
        [(0, 0), (4, 0), (0, 4), (2, 0), (1, -2), (3, -2)],
        [(0, 1, 2), (3, 4, 5)],
        [(0, 1), (3,)],
    ),
    (
        "an edge through a triangle in space",
        [(0, 0, 0), (4, 0, 0), (0, 4, 0), (1, 1, -1), (1, 1, 1)],
        [(0, 1, 2), (3, 4)],
        [(0, 1, 2), (3, 4)],
    ),
    (
        "an edge that touches an edge of a triangle in space",
        [(0, 0, 0), (4, 0, 0), (0, 4, 0), (2, 0, -1), (2, 0, 1)],
        [(0, 1, 2), (3, 4)],
        [(0, 1), (3, 4)],
    ),
    (
        "two tetrahedra, one upside down inside the other's face",
        [(0, 0, 0), (6, 0, 0), (0, 6, 0), (0, 0, 6), (1, 1, 0), (2, 1, 0), (1, 2, 0), (2, 2, -6)],
        [(0, 1, 2, 3), (4, 5, 6, 7)],
        [(0, 1, 2), (4,)],
    ),
    (
        "the lesser simplex first, though it has fewer vertices",
        [(1,), (0,), (2,)],
        [(1, 2), (0,)],
        [(0,), (1, 2)],
    ),
    ("edges along one line", [(0,), (2,), (1,), (3,)], [(0, 1), (2, 3)], [(0, 1), (2,)]),
    (
        "the first of two pairs",
        [(0,), (4,), (3,), (1,)],
        [(0, 1), (2,), (3,)],
        [(0, 1), (2,)],
    ),
]


@pytest.mark.parametrize(
    ("points", "facets", "pair"), [case[1:] for case in OVERLAPS], ids=[c[0] for c in OVERLAPS]
)
def test_overlaps(points: Points, facets: Rows, pair: Rows) -> None:
    """Clauses: CPLX-GEOMETRIC-5, CPLX-GEOMETRIC-6."""
    assert geometric(points, whole(*facets)) == overlapping(pair[0], pair[1])


# name, points, facets
FITTING: list[tuple[str, Points, Rows]] = [
    ("triangles at a vertex", [(0, 0), (1, 0), (0, 1), (-1, 0), (0, -1)], [(0, 1, 2), (0, 3, 4)]),
    ("two edges of a line", [(0,), (2,), (1,)], [(0, 2), (1, 2)]),
    ("an edge just past a vertex", [(0, 0), (2, 0), (1, Fraction(1, 10**30))], [(0, 1), (2,)]),
    ("boxes that meet, hulls that do not", [(0, 0), (4, 4), (3, 1), (4, 0)], [(0, 1), (2, 3)]),
    ("lines that meet, segments that do not", [(0, 0), (2, 0), (5, -1), (5, 1)], [(0, 1), (2, 3)]),
    ("parallel edges", [(0, 0), (2, 0), (0, 1), (2, 1)], [(0, 1), (2, 3)]),
    (
        "two tetrahedra at a face",
        [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)],
        [(0, 1, 2, 3), (1, 2, 3, 4)],
    ),
    (
        "a simplex of four dimensions",
        [(0, 0, 0, 0), (1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1)],
        [(0, 1, 2, 3, 4)],
    ),
]


@pytest.mark.parametrize(
    ("points", "facets"), [case[1:] for case in FITTING], ids=[c[0] for c in FITTING]
)
def test_fitting(points: Points, facets: Rows) -> None:
    """Clauses: CPLX-GEOMETRIC-4, CPLX-GEOMETRIC-5."""
    assert isinstance(geometric(points, whole(*facets)), Accepted)


def test_points_that_no_simplex_names_lie_anywhere() -> None:
    """Clause: CPLX-GEOMETRIC-2."""
    assert isinstance(geometric(LINE, whole((0, 1))), Accepted)


@pytest.mark.parametrize(
    ("points", "rows", "expected"),
    [
        (
            [(0, 0), (1, 1), (1,), (1, 2, 3)],
            [()],
            Rejected(Reason.COUNT_MISMATCH, Clause.CPLX_GEOMETRIC_1, AtVertex(2)),
        ),
        (LINE, [(0,), ()], Rejected(Reason.EMPTY_SIMPLEX, Clause.CPLX_FACET_3, AtFace(1))),
        (
            LINE,
            [(0,), (3,), (0, 1)],
            Rejected(Reason.INDEX_OUT_OF_RANGE, Clause.CPLX_GEOMETRIC_2, AtFace(1)),
        ),
        (
            LINE,
            [(2,), (1, 0), (1,)],
            Rejected(Reason.MISSING_FACE, Clause.CPLX_GEOMETRIC_3, AtPair((0, 1), (0,))),
        ),
        (
            SQUARE,
            [(3, 2), (0,), (1,), (2,), (0, 1, 2), (0, 1)],
            Rejected(Reason.MISSING_FACE, Clause.CPLX_GEOMETRIC_3, AtPair((0, 1, 2), (0, 2))),
        ),
        (
            [(0, 0), (0, 0), (1, 1)],
            whole((0, 2), (1, 2), (0, 1)),
            Rejected(Reason.DEGENERATE_SIMPLEX, Clause.CPLX_GEOMETRIC_4, AtSimplex((0, 1))),
        ),
        (
            [(0, 0), (2, 2), (1, 1), (0, 1), (0, 2)],
            whole((0, 1, 2), (0, 3, 4)),
            Rejected(Reason.DEGENERATE_SIMPLEX, Clause.CPLX_GEOMETRIC_4, AtSimplex((0, 1, 2))),
        ),
        (
            LINE,
            whole((0, 1, 2)),
            Rejected(Reason.DEGENERATE_SIMPLEX, Clause.CPLX_GEOMETRIC_4, AtSimplex((0, 1, 2))),
        ),
    ],
)
def test_other_rejections(points: Points, rows: Rows, expected: Rejected) -> None:
    """Clauses: CPLX-GEOMETRIC-1, CPLX-GEOMETRIC-2, CPLX-GEOMETRIC-3, CPLX-GEOMETRIC-4."""
    assert geometric(points, rows) == expected


def q(*coordinates: int) -> tuple[Fraction, ...]:
    return tuple(map(Fraction, coordinates))


def test_kernel() -> None:
    """Clause: CPLX-GEOMETRIC-4. Columns 1, 2, 4: twice the first is the second, four times the
    third."""
    assert kernel([]) == []
    assert kernel([q(0)]) == [[1]]
    assert kernel([q(1), q(2), q(4)]) == [[-2, 1, 0], [-4, 0, 1]]
    assert kernel([q(0, 2), q(3, 0)]) == []
    assert kernel([q(0, 2), q(3, 0), q(3, 2)]) == [[-1, -1, 1]]
    assert kernel([q(1, 1), q(1, 3), q(0, 1)]) == [[HALF, -HALF, 1]]


def test_general_position() -> None:
    """Clause: CPLX-GEOMETRIC-4."""
    assert in_general_position([])
    assert in_general_position([q(0, 0), q(1, 0), q(0, 1)])
    assert not in_general_position([q(0, 0), q(1, 1), q(2, 2)])
    assert not in_general_position([q(1), q(1)])
    assert not in_general_position([q(0), q(1), q(2)])


def test_circuits() -> None:
    """Clause: CPLX-GEOMETRIC-6. Radon's partitions: three on a line, four in a plane."""
    a, b, c = q(0), q(2), q(1)
    assert is_circuit([a, b], [c])
    assert is_circuit([c], [a, b])
    assert not is_circuit([a, c], [b])
    assert is_circuit([a], [a])
    assert not is_circuit([a], [b])
    assert not is_circuit([a, b], [a, c])  # two dependences
    assert not is_circuit([q(0, 0), q(2, 0), q(0, 2)], [q(1, 0)])  # the third has coefficient 0


def test_corners_of_intersections() -> None:
    """Clause: CPLX-GEOMETRIC-5. Segments 0–2 and 1–3 meet from 1 to 2."""
    found = corners_of_intersection([q(0), q(2)], [q(1), q(3)])
    assert sorted(found) == [((0, 1), (0,)), ((1,), (0, 1))]
    assert corners_of_intersection([q(0)], [q(0)]) == [((0,), (0,))]
    assert corners_of_intersection([q(0), q(1)], [q(2), q(3)]) == []
    assert corners_of_intersection([], [q(2)]) == []
    assert corners_of_intersection([q(2)], []) == []


def test_meeting_properly() -> None:
    """Clause: CPLX-GEOMETRIC-5."""
    points = [q(0), q(2), q(1)]
    assert meet_properly(points, (0, 2), (1, 2))
    assert not meet_properly(points, (0, 1), (1, 2))
    assert not meet_properly(points, (0, 1), (2,))
    assert meet_properly(points, (0,), (2,))
    assert meet_properly(points, (0, 1), (0,))
    assert meet_properly(points, (1,), (0, 1))


def test_missing_faces() -> None:
    """Clause: CPLX-GEOMETRIC-3. The first simplex, and its face of fewest vertices."""
    given = [(4, 5), (4,), (1, 2, 3), (1,), (2,), (3,), (2, 3)]
    assert missing_face(frozenset(map(frozenset, given))) == ((1, 2, 3), (1, 2))
    assert missing_face(frozenset(map(frozenset, [*given, (1, 2), (1, 3)]))) == ((4, 5), (5,))
    assert missing_face(closure(given).simplices) is None


def test_near_pairs() -> None:
    """Clause: CPLX-GEOMETRIC-6. Boxes: 0 is (0, 0), 1 (4, 4), 2 (4, 0), 3 (0, 4), 4 (5, 5)."""
    points = [q(0, 0), q(4, 4), q(4, 0), q(0, 4), q(5, 5)]
    edges = Complex(frozenset(map(frozenset, [(0, 1), (0, 2), (1, 3), (4,), (1, 4)])))
    found = {frozenset(pair) for pair in near_pairs(points, edges)}
    expected = [
        *(((0, 1), (0, 2)), ((0, 1), (1, 3)), ((0, 1), (1, 4)), ((1, 3), (1, 4))),
        ((4,), (1, 4)),
    ]
    assert found == set(map(frozenset, expected))
    assert len(list(near_pairs(points, edges))) == len(expected)


def test_a_grid_of_many_triangles() -> None:
    """Clause: CPLX-GEOMETRIC-6. A sheet of 8 × 8 squares fits; one corner moved, it does not."""
    points = [q(i, j) for i in range(9) for j in range(9)]
    sheet = closure(
        corner
        for i in range(8)
        for j in range(8)
        for a in [9 * i + j]
        for corner in ((a, a + 1, a + 10), (a, a + 9, a + 10))
    )
    assert overlap(points, sheet) is None
    bent = [*points[:10], q(3, 1), *points[11:]]  # vertex 10 from (1, 1) onto vertex 28 at (3, 1)
    assert overlap(bent, sheet) == ((10,), (28,))
    assert len(by_size(sheet)) == 81 + (8 * 9 * 2 + 64) + 128
    assert by_size(sheet)[0] == row(frozenset({0}))
