"""Laws of skeletons, joins, purity and boundaries in every dimension."""

from itertools import product
from typing import Final

from clers.complexes.facets import facets
from clers.complexes.given_every_dimension import COMPLEXES, JOINABLE, PURE_COMPLEXES
from clers.complexes.homology import Field, betti
from clers.complexes.parts import f_vector, is_subcomplex, join, skeleton
from clers.complexes.purity import impure_at, interior, pure_boundary
from clers.complexes.simplicial import (
    Complex,
    boundary,
    closure,
    dimension,
    euler,
    is_pure,
    of_dimension,
    pieces,
)
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Holds, Verdict
from clers.conventions.where import AtSimplex

EMPTY: Final = Complex(frozenset())
Two = tuple[Complex, Complex]


def _skeleton(k: Complex) -> Verdict:
    n = dimension(k)
    return every(
        *(
            every(
                same(True, is_subcomplex(part, k)),
                same(m >= n, is_subcomplex(k, part)),
                same(min(m, n), dimension(part)),
                same(True, all(s in part.simplices for s in k.simplices if len(s) <= m + 1)),
            )
            for m in range(-1, n + 2)
            for part in [skeleton(m, k)]
        )
    )


def _f_vector(k: Complex) -> Verdict:
    counts = f_vector(k)
    return every(
        same(dimension(k) + 1, len(counts)),
        same(len(k.simplices), sum(counts)),
        same(euler(k), sum(counts[::2]) - sum(counts[1::2])),
        same([len(of_dimension(k, m)) for m in range(len(counts))], list(counts)),
    )


def _connected(k: Complex) -> Verdict:
    """Try all ways to part the first seven facets in two, the first facet in the first part."""
    rows = facets(k)[:7]
    splits = 0
    for chosen in product((False, True), repeat=len(rows[1:])):
        one = closure(row for row, first in zip(rows, (True, *chosen), strict=False) if first)
        other = closure(row for row, first in zip(rows, (True, *chosen), strict=False) if not first)
        splits += bool(other.simplices) and not one.simplices & other.simplices
    return same(bool(rows) and splits == 0, len(pieces(closure(rows))) == 1)


def _join(both: Two) -> Verdict:
    one, other = both
    whole = join(one, other)
    if isinstance(whole, Rejected):
        return same("accepted", whole.line())
    simplices = whole.value.simplices
    vertices = frozenset().union(*one.simplices)
    parts = {(s & vertices, s - vertices) for s in simplices}
    sides = [k.simplices | {frozenset[int]()} for k in both]
    return every(
        same(len(simplices), len(parts)),
        same(set(product(*sides)) - {(frozenset(), frozenset())}, parts),
        _rejects_itself(one),
    )


def _rejects_itself(k: Complex) -> Verdict:
    lowest = min((v for s in k.simplices for v in s), default=None)
    again = join(k, k)
    if lowest is None:
        return same(Accepted(EMPTY), again)
    return same(True, isinstance(again, Rejected))


def _algebra_of_joins(both: Two) -> Verdict:
    one, other = both
    whole, point = join(one, other), closure([(99,)])
    if isinstance(whole, Rejected):
        return same("accepted", whole.line())
    right = join(other, point)
    if isinstance(right, Rejected):
        return same("accepted", right.line())
    f, g = (1, *f_vector(one)), (1, *f_vector(other))
    multiplied = [0] * (len(f) + len(g) - 1)
    for (i, a), (j, b) in product(enumerate(f), enumerate(g)):
        multiplied[i + j] += a * b
    return every(
        same(whole, join(other, one)),
        same(join(whole.value, point), join(one, right.value)),
        same(Accepted(one), join(one, EMPTY)),
        same(multiplied, [1, *f_vector(whole.value)]),
        same((1 - euler(one)) * (1 - euler(other)), 1 - euler(whole.value)),
    )


def _homology_of_joins(both: Two) -> Verdict:
    one, other = both
    whole = join(one, other)
    if isinstance(whole, Rejected):
        return same("accepted", whole.line())
    if not one.simplices or not other.simplices:
        return Holds()
    return every(*(_multiplies(one, other, whole.value, field) for field in Field))


def _multiplies(one: Complex, other: Complex, whole: Complex, field: Field) -> Verdict:
    b, c = _reduced(one, field), _reduced(other, field)
    expected = [0] * (len(b) + len(c))
    for (i, x), (j, y) in product(enumerate(b), enumerate(c)):
        expected[i + j + 1] += x * y
    return same(expected, _reduced(whole, field))


def _reduced(k: Complex, field: Field) -> list[int]:
    numbers = betti(k, field)
    return [numbers[0] - 1, *numbers[1:]]


def _purity(k: Complex) -> Verdict:
    witness, rim = impure_at(k), pure_boundary(k)
    low = [row for row in facets(k) if len(row) <= dimension(k)]
    if witness is None:
        return every(same([], low), same(True, is_pure(k)), same(Accepted(boundary(k)), rim))
    where = rim.where if isinstance(rim, Rejected) else "accepted"
    return every(
        same(False, is_pure(k)),
        same(low[:1], [tuple(sorted(witness))]),
        same(AtSimplex(tuple(sorted(witness))), where),
        same(rim, interior(k)),
    )


def _interior(k: Complex) -> Verdict:
    inside, rim = interior(k), pure_boundary(k)
    if isinstance(inside, Rejected) or isinstance(rim, Rejected):
        return same("pure", "rejected")
    return every(
        same(k.simplices, inside.value | rim.value.simplices),
        same(frozenset(), inside.value & rim.value.simplices),
        same(True, all(t in inside.value for s in inside.value for t in k.simplices if s < t)),
    )


def _boundary_twice(k: Complex) -> Verdict:
    n = dimension(k)
    top = of_dimension(k, n)
    if any(sum(wall < big for big in top) > 2 for wall in of_dimension(k, n - 1)):
        return Holds()
    return same(EMPTY, boundary(boundary(k)))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "skeleton-is-the-largest-subcomplex-of-its-dimension",
        Clause.CPLX_PART_1,
        "The m-skeleton is a subcomplex of dimension at most m, with all simplices that low.",
        COMPLEXES,
        _skeleton,
    ),
    Law(
        "f-vector-counts-every-simplex",
        Clause.CPLX_PART_2,
        "The numbers of the f-vector add up to all simplices, with alternating signs to χ.",
        COMPLEXES,
        _f_vector,
    ),
    Law(
        "connected-is-what-no-two-subcomplexes-part",
        Clause.CPLX_PART_3,
        "A complex has one component exactly if its facets cannot be parted in two.",
        COMPLEXES,
        _connected,
    ),
    Law(
        "join-has-each-pair-once",
        Clause.CPLX_JOIN_1,
        "The simplices of a join are the pairs of one of each, or of nothing, but two nothings.",
        JOINABLE,
        _join,
    ),
    Law(
        "joins-are-an-algebra",
        Clause.CPLX_JOIN_2,
        "Joins commute, associate, have a unit, and multiply f-polynomials and reduced χ.",
        JOINABLE,
        _algebra_of_joins,
    ),
    Law(
        "homology-of-a-join-is-the-product",
        Clause.CPLX_JOIN_3,
        "The reduced Betti numbers of a join are products of those of its parts, one higher.",
        JOINABLE,
        _homology_of_joins,
    ),
    Law(
        "purity-has-a-witness",
        Clause.CPLX_PURE_1,
        "A complex is pure, and has a boundary, or else a first low facet, which is blamed.",
        COMPLEXES,
        _purity,
    ),
    Law(
        "interior-is-all-but-the-boundary",
        Clause.CPLX_PURE_3,
        "Each simplex of a pure complex is interior or boundary; what is around one is interior.",
        PURE_COMPLEXES,
        _interior,
    ),
    Law(
        "boundary-of-a-boundary-is-empty",
        Clause.CPLX_PURE_4,
        "A pure complex with at most two n-simplices at each wall has a boundary without one.",
        PURE_COMPLEXES,
        _boundary_twice,
    ),
)
