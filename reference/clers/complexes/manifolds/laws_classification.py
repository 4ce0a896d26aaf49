"""Laws of the classification of surfaces, and of connected sums."""

from collections import Counter
from typing import Final

from clers.complexes.corner_table import face_list
from clers.complexes.definition import components_by_definition
from clers.complexes.given import SMALL_SURFACES
from clers.complexes.homology import Field, betti
from clers.complexes.integral import Group, homology_over_z
from clers.complexes.manifolds.classification import (
    Distinct,
    Homeomorphic,
    classify,
    homeomorphism,
)
from clers.complexes.manifolds.connected_sum import Summand, connected_sum
from clers.complexes.manifolds.given import (
    NEAR_MANIFOLDS,
    SURFACE_PAIRS,
    SURFACES,
    Prescribed,
    PrescribedPair,
)
from clers.complexes.manifolds.kind import NotManifold
from clers.complexes.manifolds.manifold import manifold
from clers.complexes.manifolds.surface_type import (
    NonOrientable,
    Orientable,
    SurfaceType,
    in_words,
    summed,
)
from clers.complexes.simplicial import (
    Complex,
    boundary,
    closure,
    dimension,
    euler,
    of_dimension,
    pieces,
)
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Verdict
from clers.conventions.where import AtPair, AtSimplex


def _types(given: Prescribed) -> Counter[SurfaceType]:
    """Of what it was made."""
    return Counter(piece.surface_type for piece in given.pieces)


def _made(given: Prescribed) -> Verdict:
    answer = classify(given.complex)
    got = Counter(answer.value) if isinstance(answer, Accepted) else answer
    return same(_types(given), got) if given.pieces else same(True, isinstance(answer, Rejected))


def _counted(given: Prescribed) -> Verdict:
    """χ and curves by definition, for each component in its place."""
    parts = pieces(given.complex)
    expected = tuple((euler(part), len(pieces(boundary(part)))) for part in parts)
    answer = classify(given.complex)
    got = [(t.euler, t.curves) for t in answer.value] if isinstance(answer, Accepted) else []
    return same(list(expected), got)


def _named(given: PrescribedPair) -> Verdict:
    types = [piece.surface_type for both in given for piece in both.pieces]
    return every(*(same(a == b, in_words(a) == in_words(b)) for a in types for b in types))


def _compared(given: PrescribedPair) -> Verdict:
    first, second = given
    a, b = _types(first), _types(second)
    answer = homeomorphism(first.complex, second.complex)
    if isinstance(answer, Rejected):
        return same("two surfaces", answer)
    match answer.value:
        case Homeomorphic(types):
            return every(same(a, b), same(a, Counter(types)), _in_order(types))
        case Distinct(first_only, second_only):
            return every(
                same(False, a == b),
                same(a - b, Counter(first_only)),
                same(b - a, Counter(second_only)),
                _in_order(first_only),
                _in_order(second_only),
            )


def _in_order(types: tuple[SurfaceType, ...]) -> Verdict:
    keys = [(isinstance(t, NonOrientable), -t.euler, t.curves) for t in types]
    return same(sorted(keys), keys)


def _rejected(k: Complex) -> Verdict:
    answer, fault = classify(k), manifold(k)
    if dimension(k) != 2:
        got = (answer.reason, answer.clause) if isinstance(answer, Rejected) else answer
        return same((Reason.UNSUPPORTED_DIMENSION, Clause.CPLX_CLASSIFY_5), got)
    if isinstance(fault, NotManifold):
        where = AtSimplex(tuple(sorted(fault.simplex)))
        clause = Clause.CPLX_CLASSIFY_5
        return same(Rejected(Reason.NOT_A_MANIFOLD, clause, where, fault.flaw), answer)
    return same(True, isinstance(answer, Accepted))


def _witnessed(given: Prescribed) -> Verdict:
    verdicts: list[Verdict] = []
    for part in pieces(given.complex):
        answer = classify(part)
        if isinstance(answer, Rejected):
            return same("a surface", answer)
        (of,) = answer.value
        over_q, over_gf2 = _betti(of, over_q=True), _betti(of, over_q=False)
        twist = (2,) if over_q != over_gf2 else ()
        groups = tuple(Group(b, twist if m == 1 else ()) for m, b in enumerate(over_q))
        found = betti(part, Field.Q), betti(part, Field.GF2), homology_over_z(part)
        verdicts.append(same((over_q, over_gf2, groups), found))
    return every(*verdicts)


def _betti(of: SurfaceType, *, over_q: bool) -> tuple[int, int, int]:
    if of.curves > 0:
        return 1, 1 - of.euler, 0
    match of:
        case Orientable(genus, _):
            return 1, 2 * genus, 1
        case NonOrientable(crosscaps, _):
            return (1, crosscaps - 1, 0) if over_q else (1, crosscaps, 1)


def _oriented(of: Surface) -> Verdict:
    known = components_by_definition(face_list(of))
    answer = classify(closure(of.triangles()))
    got = Counter(answer.value) if isinstance(answer, Accepted) else answer
    return same(Counter(Orientable(part.genus, part.curves) for part in known), got)


def _summands(given: PrescribedPair) -> tuple[Summand, Summand]:
    """Both at their first triangles."""
    first, second = (
        Summand(one.complex, tuple(sorted(of_dimension(one.complex, 2)[0]))) for one in given
    )
    return first, second


def _inside(of: Summand) -> bool:
    return not any(v in simplex for simplex in boundary(of.complex).simplices for v in of.at)


def _glued(given: PrescribedPair) -> Verdict:
    first, second = _summands(given)
    answer = connected_sum(first, second)
    if isinstance(answer, Rejected):
        return same(False, _inside(first) or _inside(second))
    k = answer.value
    top = max(map(max, first.complex.simplices))
    rest = of_dimension(second.complex, 0)
    counts = [
        len(of_dimension(first.complex, m)) + len(of_dimension(second.complex, m)) - shared
        for m, shared in enumerate((3, 3, 2))
    ]
    return every(
        same(counts, [len(of_dimension(k, m)) for m in range(3)]),
        same({frozenset(first.at)}, set(first.complex.simplices - k.simplices)),
        same(top + len(rest) - 3, max(map(max, k.simplices))),
    )


def _added(given: PrescribedPair) -> Verdict:
    first, second = _summands(given)
    answer = connected_sum(first, second)
    if isinstance(answer, Rejected):
        return same(False, _inside(first) or _inside(second))
    (a, others), (b, more) = _at(first), _at(second)
    got = classify(answer.value)
    expected = Counter([summed(a, b), *others, *more])
    return same(expected, Counter(got.value) if isinstance(got, Accepted) else got)


def _at(of: Summand) -> tuple[SurfaceType, list[SurfaceType]]:
    """The type of the component that is glued, and those of the others."""
    answer = classify(of.complex)
    types = answer.value if isinstance(answer, Accepted) else ()
    here = [frozenset(of.at) in part.simplices for part in pieces(of.complex)]
    (glued,) = (t for t, yes in zip(types, here, strict=True) if yes)
    return glued, [t for t, yes in zip(types, here, strict=True) if not yes]


def _refused(given: PrescribedPair) -> Verdict:
    first, second = _summands(given)
    if _inside(first) or _inside(second):
        return same(True, isinstance(connected_sum(first, second), Accepted))
    clause, where = Clause.CPLX_SUM_3, AtPair(first.at, second.at)
    why = Reason.OPERATOR_NOT_APPLICABLE
    return same(Rejected(why, clause, where, "both on the boundary"), connected_sum(first, second))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "surfaces-have-the-types-they-were-made-of",
        Clause.CPLX_CLASSIFY_1,
        "A sum of tori or projective planes with discs removed is classified as such.",
        SURFACES,
        _made,
    ),
    Law(
        "euler-and-curves-are-those-of-the-type",
        Clause.CPLX_CLASSIFY_2,
        "χ and the boundary's components, counted by definition, are those of the type.",
        SURFACES,
        _counted,
    ),
    Law(
        "types-have-names-of-their-own",
        Clause.CPLX_CLASSIFY_3,
        "Two types have the same name exactly if they are the same.",
        SURFACE_PAIRS,
        _named,
    ),
    Law(
        "surfaces-are-homeomorphic-by-their-types",
        Clause.CPLX_CLASSIFY_4,
        "Two surfaces are homeomorphic exactly if they were made of the same, each as often.",
        SURFACE_PAIRS,
        _compared,
    ),
    Law(
        "what-is-no-surface-is-not-classified",
        Clause.CPLX_CLASSIFY_5,
        "Other dimensions and complexes that are no manifolds are rejected, at their fault.",
        NEAR_MANIFOLDS,
        _rejected,
    ),
    Law(
        "homology-witnesses-the-type",
        Clause.CPLX_CLASSIFY_6,
        "The Betti numbers over the rationals and two elements, and the homology over the "
        "integers with its torsion, are those of the type.",
        SURFACES,
        _witnessed,
    ),
    Law(
        "types-agree-with-genus-and-curves",
        Clause.CPLX_CLASSIFY_7,
        "On oriented surfaces the types are genus and curves of the components.",
        SMALL_SURFACES,
        _oriented,
    ),
    Law(
        "sums-lose-two-simplices-and-share-a-frontier",
        Clause.CPLX_SUM_1,
        "Of both complexes a triangle is gone, its frontier is shared, names go on from the top.",
        SURFACE_PAIRS,
        _glued,
    ),
    Law(
        "types-add-up",
        Clause.CPLX_SUM_2,
        "The sum of two surfaces has the sum of the types of the components that are glued.",
        SURFACE_PAIRS,
        _added,
    ),
    Law(
        "sums-at-two-boundaries-are-refused",
        Clause.CPLX_SUM_3,
        "Two simplices that both touch the boundary are not glued, and all others are.",
        SURFACE_PAIRS,
        _refused,
    ),
)
