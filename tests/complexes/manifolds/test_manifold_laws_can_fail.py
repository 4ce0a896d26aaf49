"""Each law of manifolds, with a fault planted in what it judges: it must say so, and only then."""

from types import ModuleType

import pytest

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.known import (
    ANNULUS,
    BALLS,
    BOOK,
    BOW_TIE,
    FIGURE_8,
    MOEBIUS_BAND,
    PROJECTIVE,
    SPHERES,
    SUSPENDED_TORUS,
    TORUS,
    TWO_SPHERES,
)
from clers.complexes.manifolds import laws_classification, laws_manifold, laws_orientation
from clers.complexes.manifolds.classification import (
    Distinct,
    Homeomorphic,
    Types,
    classify,
)
from clers.complexes.manifolds.connected_sum import Summand, connected_sum
from clers.complexes.manifolds.given import Piece, Prescribed
from clers.complexes.manifolds.kind import Ball, Flaw, LinkKind, NotManifold, Sphere
from clers.complexes.manifolds.laws import LAWS
from clers.complexes.manifolds.manifold import Manifold, UndecidedAt, manifold
from clers.complexes.manifolds.orient import OneSided, Oriented, orient
from clers.complexes.manifolds.orientation import OrientedSimplex, ordering
from clers.complexes.manifolds.spheres import recognise
from clers.complexes.manifolds.surface_type import Orientable, SurfaceType
from clers.complexes.simplicial import Complex, closure
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds


def made(k: Complex, n: int, *pieces: Piece) -> Prescribed:
    return Prescribed(k, n, pieces)


TWO_SIDED, CAPPED = Piece(True, 0, 0), Piece(False, 1, 0)
SPHERE = made(SPHERES[2].complex, 2, TWO_SIDED)
DISC = made(BALLS[2].complex, 2, Piece(True, 0, 1))
PLANE = made(PROJECTIVE.complex, 2, CAPPED)
BAND_OF_ONE_SIDE = made(MOEBIUS_BAND.complex, 2, Piece(False, 1, 1))
RING = made(ANNULUS.complex, 2, Piece(True, 0, 2))
RINGED_TORUS = made(TORUS.complex, 2, Piece(True, 1, 0))
MANIFOLDS = (SPHERE, DISC, PLANE, BAND_OF_ONE_SIDE, RING, RINGED_TORUS)
FOUR = made(BALLS[4].complex, 4, Piece(True, 0, 1))
NEAR = (
    *(BOOK.complex, BOW_TIE.complex, FIGURE_8.complex, TWO_SPHERES.complex),
    *(SUSPENDED_TORUS.complex, SPHERES[3].complex, BALLS[3].complex, MOEBIUS_BAND.complex),
    *(PROJECTIVE.complex, SPHERES[2].complex, BALLS[2].complex, SPHERES[1].complex),
    *(SPHERES[0].complex, ANNULUS.complex, closure([[0], [1], [2]])),
)
NEAR_FOUR = (BALLS[4].complex, SPHERES[4].complex)
SURFACE_OF_BAND = surface(
    FaceList(((0, 1, 3), (1, 4, 3), (1, 2, 4), (2, 5, 4), (2, 0, 5), (0, 3, 5)), 6)
)
EXAMPLES: dict[str, tuple[object, ...]] = {
    "prescribed-manifolds": MANIFOLDS,
    "prescribed-surfaces": MANIFOLDS,
    "prescribed-surface-pairs": tuple((a, b) for a in MANIFOLDS for b in MANIFOLDS),
    "near-manifolds": NEAR,
    "prescribed-4-manifolds": (FOUR,),
    "near-4-manifolds": (
        *NEAR_FOUR,
        closure([(0, 1, 2, 3, 4), (4, 5, 6, 7, 8)]),
        closure([(0, 1, 2, 3, 4), (4, 5)]),
    ),
    "orderings": ((3,), (1, 2), (2, 1), (3, 1, 2), (0, 3, 1, 2)),
    "small-surfaces": tuple(
        built.value for built in (SURFACE_OF_BAND,) if isinstance(built, Accepted)
    ),
}


def always_sphere(k: Complex) -> LinkKind:
    return Sphere(2)


def never_closed(k: Complex) -> LinkKind:
    kind = recognise(k)
    return Ball(kind.dimension) if isinstance(kind, Sphere) else kind


def any_answer(k: Complex, recogniser: object = None) -> Manifold:
    return Manifold(2, (), ())


def undecided(k: Complex, recogniser: object = None) -> UndecidedAt:
    return UndecidedAt(frozenset({0}), "not looked at")


def blaming_the_rest(k: Complex, recogniser: object = None) -> object:
    answer = manifold(k)
    return (
        NotManifold(frozenset({99}), Flaw.BAD_LINK) if isinstance(answer, NotManifold) else answer
    )


def refuting(k: Complex, recogniser: object = None) -> NotManifold:
    return NotManifold(frozenset({0}), Flaw.WRONG_HOMOLOGY)


def whole_boundary(k: Complex) -> Complex:
    return Complex(frozenset(s for s in k.simplices if len(s) < 3))


def sorted_simplex(given: tuple[int, ...]) -> Accepted[OrientedSimplex]:
    return Accepted(OrientedSimplex(tuple(sorted(given)), positive=True))


def unturned(of: OrientedSimplex) -> OrientedSimplex:
    return of


def increasing(of: OrientedSimplex) -> tuple[int, ...]:
    return ordering(of)[::-1]


def all_positive(k: Complex) -> Oriented:
    top = max(map(len, k.simplices))
    facets = sorted(tuple(sorted(s)) for s in k.simplices if len(s) == top)
    return Oriented(tuple(OrientedSimplex(s, positive=True) for s in facets))


def no_cycle(k: Complex) -> object:
    answer = orient(k)
    return OneSided(answer.cycle[:-1]) if isinstance(answer, OneSided) else answer


def yes(k: Complex, given: object) -> bool:
    return True


def no_boundary_sign(of: OrientedSimplex, apex: int) -> OrientedSimplex:
    return OrientedSimplex(tuple(v for v in of.vertices if v != apex), positive=True)


def standing(of: OrientedSimplex, v: int) -> Accepted[int]:
    return Accepted(v)


def forgetful(k: Complex) -> Accepted[Types] | Rejected:
    """Takes every surface for one of two sides."""
    answer = classify(k)
    if isinstance(answer, Rejected):
        return answer
    return Accepted(
        tuple(Orientable((2 - t.curves - t.euler) // 2, t.curves) for t in answer.value)
    )


def nameless(of: SurfaceType) -> str:
    return "surface"


def same_always(k: Complex, other: Complex) -> Accepted[Homeomorphic]:
    return Accepted(Homeomorphic(()))


def distinct_always(k: Complex, other: Complex) -> Accepted[Distinct]:
    return Accepted(Distinct((), ()))


def kept(first: Summand, second: Summand) -> Accepted[Complex] | Rejected:
    """Forgets to take the first simplex out."""
    answer = connected_sum(first, second)
    if isinstance(answer, Rejected):
        return answer
    return Accepted(Complex(answer.value.simplices | {frozenset(first.at)}))


def refused(first: Summand, second: Summand) -> Rejected:
    return Rejected(Reason.OPERATOR_NOT_APPLICABLE, Clause.CPLX_SUM_3)


def glued_anyway(first: Summand, second: Summand) -> Accepted[Complex]:
    return Accepted(first.complex)


def no_curves(first: SurfaceType, second: SurfaceType) -> SurfaceType:
    return Orientable(0, 0)


MA, OR, CL = laws_manifold, laws_orientation, laws_classification
PLANTED: tuple[tuple[str, ModuleType, str, object], ...] = (
    ("low-spheres-and-balls-are-told-by-homology", MA, "recognise", always_sphere),
    ("low-spheres-and-balls-are-told-by-homology", MA, "recognise", never_closed),
    ("recognition-beyond-dimension-2-claims-nothing", MA, "recognise", always_sphere),
    ("manifolds-made-to-order-are-manifolds", MA, "manifold", refuting),
    ("low-manifolds-are-decided", MA, "manifold", undecided),
    ("the-lowest-fault-is-blamed", MA, "manifold", blaming_the_rest),
    ("the-lowest-fault-is-blamed", MA, "manifold", any_answer),
    ("low-manifolds-are-told-by-homology", MA, "manifold", any_answer),
    ("recognised-links-prove-a-manifold", MA, "manifold", undecided),
    ("homology-refutes-in-dimension-4", MA, "manifold", refuting),
    ("homology-refutes-in-dimension-4", MA, "manifold", undecided),
    ("the-lowest-unknown-link-is-named", MA, "manifold", undecided),
    ("walls-lie-in-one-or-two", MA, "of_dimension", lambda k, m: [*k.simplices]),
    ("boundary-of-a-manifold-is-closed", MA, "boundary", whole_boundary),
    ("bounding-vertices-are-those-of-the-boundary", MA, "manifold", any_answer),
    ("surfaces-are-the-2-manifolds", MA, "manifold", any_answer),
    ("an-exchange-of-two-vertices-is-the-opposite", OR, "oriented", sorted_simplex),
    ("an-exchange-of-two-vertices-is-the-opposite", OR, "opposite", unturned),
    ("half-of-the-orderings-are-one-orientation", OR, "ordering", increasing),
    ("half-of-the-orderings-are-one-orientation", OR, "oriented", sorted_simplex),
    ("apex-and-induced-wall-make-up-the-simplex", OR, "induced", no_boundary_sign),
    ("certificates-of-orientation-are-good", OR, "orient", all_positive),
    ("certificates-of-orientation-are-good", OR, "orient", no_cycle),
    ("certificates-are-good-on-manifolds", OR, "orient", all_positive),
    ("orientable-as-ranks-say", OR, "orient", all_positive),
    ("manifolds-are-orientable-as-made", OR, "orient", all_positive),
    ("each-part-can-be-turned", OR, "is_coherent", yes),
    ("each-part-can-be-turned", OR, "opposite", unturned),
    ("next-and-previous-are-those-of-the-corners", OR, "next_vertex", standing),
    (
        "next-and-previous-are-those-of-the-corners",
        OR,
        "previous_vertex",
        lambda of, v: Accepted(v),
    ),
    ("pseudomanifolds-are-oriented", OR, "orient", all_positive),
    ("the-boundary-is-oriented-by-induction", OR, "induced", no_boundary_sign),
    ("surfaces-have-the-types-they-were-made-of", CL, "classify", forgetful),
    ("euler-and-curves-are-those-of-the-type", CL, "classify", forgetful),
    ("types-have-names-of-their-own", CL, "in_words", nameless),
    ("surfaces-are-homeomorphic-by-their-types", CL, "homeomorphism", same_always),
    ("surfaces-are-homeomorphic-by-their-types", CL, "homeomorphism", distinct_always),
    ("what-is-no-surface-is-not-classified", CL, "classify", lambda k: Accepted(())),
    ("homology-witnesses-the-type", CL, "classify", forgetful),
    ("types-agree-with-genus-and-curves", CL, "classify", lambda k: Accepted((Orientable(1, 0),))),
    ("sums-lose-two-simplices-and-share-a-frontier", CL, "connected_sum", kept),
    ("sums-lose-two-simplices-and-share-a-frontier", CL, "connected_sum", refused),
    ("types-add-up", CL, "connected_sum", kept),
    ("types-add-up", CL, "summed", no_curves),
    ("sums-at-two-boundaries-are-refused", CL, "connected_sum", glued_anyway),
    ("sums-at-two-boundaries-are-refused", CL, "connected_sum", refused),
)


@pytest.mark.parametrize(("name", "module", "attribute", "fault"), PLANTED)
def test_law_fails(
    name: str,
    module: ModuleType,
    attribute: str,
    fault: object,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    (law,) = [law for law in LAWS if law.name == name]
    examples = EXAMPLES[law.domain]
    assert [law.check(example) for example in examples] == [Holds()] * len(examples)
    monkeypatch.setattr(module, attribute, fault)
    assert any(isinstance(law.check(example), Fails) for example in examples)


def test_every_law_was_seen_to_fail() -> None:
    assert {name for name, *_ in PLANTED} == {law.name for law in LAWS}
