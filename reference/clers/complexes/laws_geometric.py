"""Laws of complexes in space: corners of intersections, by definition, against circuits."""

from fractions import Fraction
from itertools import combinations
from typing import Final

from clers.complexes.affine import Point, in_general_position
from clers.complexes.facets import facets, row
from clers.complexes.geometric import geometric, meet_properly, missing_face, overlap
from clers.complexes.given_every_dimension import PLACED, Placed
from clers.complexes.simplicial import Complex
from clers.complexes.smith import determinant
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Holds, Verdict
from clers.conventions.where import AtSimplex

FEW: Final = 14


def _independent(placed: Placed) -> Complex:
    """The simplices in general position: a subcomplex, as their faces are so too."""
    points, k = placed
    return Complex(frozenset(s for s in k.simplices if in_general_position([points[v] for v in s])))


def _overlap(placed: Placed) -> Verdict:
    """All pairs of few simplices, with the blame; of many simplices the pairs of facets."""
    points, k = placed[0], _independent(placed)
    found, few = overlap(points, k), len(k.simplices) <= FEW
    rows = sorted(map(row, k.simplices)) if few else facets(k)
    improper = [
        (len(one) + len(other), one, other)
        for one, other in combinations(rows, 2)
        if not meet_properly(points, one, other)
    ]
    meeting = [case for case in improper if not set(case[1]) & set(case[2])]
    blamed = min(meeting)[1:] if meeting else None
    return every(same(not improper, found is None), same(blamed if few else found, found))


def _general_position(placed: Placed) -> Verdict:
    points, k = placed
    flat = [s for s in map(row, k.simplices) if not _volume_squared([points[v] for v in s])]
    answer = geometric(points, [row(s) for s in k.simplices])
    if not flat:
        return same(_independent(placed), k)
    blamed = answer.where if isinstance(answer, Rejected) else answer
    return same(AtSimplex(min(flat, key=lambda s: (len(s), s))), blamed)


def _volume_squared(points: list[Point]) -> int:
    """Gram's determinant of the edges from the first point, of twice the coordinates."""
    edges = [
        [int(2 * (x - y)) for x, y in zip(point, points[0], strict=True)] for point in points[1:]
    ]
    return determinant(
        [[sum(x * y for x, y in zip(a, b, strict=True)) for b in edges] for a in edges]
    )


def _missing(placed: Placed) -> Verdict:
    _, k = placed
    for gone in sorted(map(row, k.simplices)):
        rest = k.simplices - {frozenset(gone)}
        around = [s for s in sorted(map(row, rest)) if set(gone) < set(s)]
        expected = (around[0], gone) if around else None
        if missing_face(rest) != expected:
            return same(expected, missing_face(rest))
    return same(None, missing_face(k.simplices))


def _moved(placed: Placed) -> Verdict:
    """Shear, stretch, shift; and one coordinate more, a sum of the others."""
    points, k = placed
    rows = [row(s) for s in k.simplices]
    before = geometric(points, rows)

    def image(point: Point) -> Point:
        sheared = [3 * x + sum(point[:i], Fraction(0)) - 7 for i, x in enumerate(point)]
        return (*sheared, sum(point, Fraction(1, 3)))

    after = geometric([image(point) for point in points], rows)
    if isinstance(before, Rejected) or isinstance(after, Rejected):
        return same(before, after)
    return same(before.value.complex, after.value.complex)


def _parts(placed: Placed) -> Verdict:
    points, k = placed
    if not isinstance(geometric(points, [row(s) for s in k.simplices]), Accepted):
        return Holds()
    low = [row(s) for s in k.simplices if len(s) <= 2]
    return same(True, isinstance(geometric(points, low), Accepted))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "overlaps-are-found-among-circuits",
        Clause.CPLX_GEOMETRIC_6,
        "Every two simplices meet properly exactly if no circuit is found; the first is blamed.",
        PLACED,
        _overlap,
    ),
    Law(
        "degenerate-is-what-has-no-volume",
        Clause.CPLX_GEOMETRIC_4,
        "The first simplex for which Gram's determinant is 0 is blamed, if there is one.",
        PLACED,
        _general_position,
    ),
    Law(
        "missing-faces-are-missed",
        Clause.CPLX_GEOMETRIC_3,
        "When one simplex is taken out, it is missed by the first simplex it was a face of.",
        PLACED,
        _missing,
    ),
    Law(
        "affine-maps-change-nothing",
        Clause.CPLX_GEOMETRIC_5,
        "A one-to-one affine map, to a space of one dimension more, changes no answer.",
        PLACED,
        _moved,
    ),
    Law(
        "parts-of-complexes-in-space-are-such",
        Clause.CPLX_GEOMETRIC_5,
        "The vertices and edges of an accepted complex in space are accepted.",
        PLACED,
        _parts,
    ),
)
