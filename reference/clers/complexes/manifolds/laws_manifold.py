"""Laws of spheres, balls and manifolds."""

from typing import Final

from clers.complexes.definition import is_surface
from clers.complexes.manifolds.given import (
    FOUR_MANIFOLDS,
    MANIFOLDS,
    NEAR_FOUR_MANIFOLDS,
    NEAR_MANIFOLDS,
    Prescribed,
)
from clers.complexes.manifolds.homology_type import (
    Looks,
    is_manifold_by_homology,
    looks,
    over_gf2,
    suspect,
)
from clers.complexes.manifolds.incidence import flaw_at_a_wall
from clers.complexes.manifolds.kind import (
    Ball,
    Flaw,
    LinkKind,
    Neither,
    NotManifold,
    Sphere,
    Undecided,
)
from clers.complexes.manifolds.manifold import Manifold, UndecidedAt, manifold
from clers.complexes.manifolds.spheres import recognise
from clers.complexes.simplicial import (
    Complex,
    boundary,
    dimension,
    link,
    of_dimension,
    pieces,
    star,
)
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.verdict import Verdict


def trusting(k: Complex) -> LinkKind:
    """A recogniser that takes what looks like a sphere or ball for one: right on manifolds only."""
    match looks(k, dimension(k)):
        case Looks.SPHERE:
            return Sphere(dimension(k))
        case Looks.BALL:
            return Ball(dimension(k))
        case Looks.NEITHER:
            return Neither(Flaw.WRONG_HOMOLOGY)


def shy(_: Complex) -> LinkKind:
    """A recogniser that knows nothing."""
    return Undecided("not looked at")


def _vertices(k: Complex) -> tuple[int, ...]:
    return tuple(min(v) for v in of_dimension(k, 0))


def _recognised(k: Complex) -> Verdict:
    """Of a complex and of the links in it, as far as their dimension is 2 at most."""
    parts = [k, *(link(k, v) for v in of_dimension(k, 0))]
    return every(*(same(_by_homology(p), recognise(p)) for p in parts if dimension(p) < 3))


def _by_homology(k: Complex) -> LinkKind:
    """A manifold that looks like a sphere or ball; the flaw is for the clause of manifolds."""
    kind = recognise(k)
    neither = kind if isinstance(kind, Neither) else Neither(Flaw.WRONG_HOMOLOGY)
    if not is_manifold_by_homology(k):
        return neither
    match looks(k, dimension(k), over_gf2):
        case Looks.SPHERE:
            return Sphere(dimension(k))
        case Looks.BALL:
            return Ball(dimension(k))
        case Looks.NEITHER:
            return neither


def _claims(k: Complex) -> Verdict:
    kind = recognise(k)
    if flaw_at_a_wall(k) is not None or looks(k, dimension(k)) is Looks.NEITHER:
        return same(True, isinstance(kind, Neither))
    return same(dimension(k) > 2, isinstance(kind, Undecided))


def _made(given: Prescribed) -> Verdict:
    answer = manifold(given.complex)
    got = answer.dimension if isinstance(answer, Manifold) else answer
    return same(given.dimension if given.pieces else -1, got)


def _exact(k: Complex) -> Verdict:
    answer = manifold(k, shy)
    return every(
        same(True, isinstance(answer, Manifold | NotManifold)), same(manifold(k, trusting), answer)
    )


def _two_readings(k: Complex) -> Verdict:
    return same(is_manifold_by_homology(k), isinstance(manifold(k), Manifold))


def _blamed(k: Complex) -> Verdict:
    answer = manifold(k)
    n = dimension(k)
    lowest = sorted(k.simplices, key=lambda s: (len(s), sorted(s)))
    loose = [s for s in lowest if len(s) <= n and star(k, s) == {s}]
    crowded = [s for s in lowest if len(s) == n and len(star(k, s)) > 3]
    for blamed, flaw in ((loose, Flaw.NOT_PURE), (crowded, Flaw.CROWDED_WALL)):
        if blamed:
            return same(NotManifold(blamed[0], flaw), answer)
    for v in of_dimension(k, 0):
        around = link(k, v)
        if not is_manifold_by_homology(around):
            return same(NotManifold(v, _flaw_of_link(around)), answer)
        if looks(around, n - 1, over_gf2) is Looks.NEITHER:
            several = len(pieces(around)) > 1
            flaw = Flaw.DISCONNECTED if several else Flaw.WRONG_HOMOLOGY
            return same(NotManifold(v, flaw), answer)
    return same(True, isinstance(answer, Manifold))


def _flaw_of_link(around: Complex) -> Flaw:
    """Neither a curve nor a surface: in a pure complex without crowded walls it is pinched."""
    return Flaw.BAD_LINK if dimension(around) == 2 else Flaw.CROWDED_WALL


def _walls(given: Prescribed) -> Verdict:
    k, n = given.complex, given.dimension
    facets = of_dimension(k, n)
    counts = [sum(wall < big for big in facets) for wall in of_dimension(k, n - 1)]
    return same(True, set(counts) <= {1, 2})


def _boundary(given: Prescribed) -> Verdict:
    rim = boundary(given.complex)
    expected = Manifold(given.dimension - 1, _vertices(rim), ())
    curves = sum(piece.curves for piece in given.pieces)
    return every(
        same(expected if rim.simplices else Manifold(-1, (), ()), manifold(rim)),
        same(curves, len(pieces(rim))),
    )


def _inner(given: Prescribed) -> Verdict:
    k = given.complex
    bounding = _vertices(boundary(k))
    inner = tuple(v for v in _vertices(k) if v not in bounding)
    return same(Manifold(dimension(k), inner, bounding), manifold(k))


def _surfaces(k: Complex) -> Verdict:
    answer = manifold(k)
    is_two = isinstance(answer, Manifold) and answer.dimension == 2
    return same(is_surface(k) and dimension(k) == 2, is_two)


def _proved(given: Prescribed) -> Verdict:
    k = given.complex
    bounding = _vertices(boundary(k))
    inner = tuple(v for v in _vertices(k) if v not in bounding)
    return same(Manifold(4, inner, bounding), manifold(k, trusting))


def _refuted(k: Complex) -> Verdict:
    lowest = sorted(k.simplices, key=lambda s: (len(s), sorted(s)))
    suspects = [s for s in lowest if suspect(k, s)]
    answer = manifold(k, shy)
    if dimension(k) < 4 or flaw_at_a_wall(k) is not None:
        return same(manifold(k), answer)
    if suspects:
        return same(NotManifold(suspects[0], Flaw.WRONG_HOMOLOGY), answer)
    return same(UndecidedAt(lowest[0], "not looked at"), answer)


def _undecided(given: Prescribed) -> Verdict:
    """A recogniser that knows all links but those of some vertices."""
    k = given.complex
    vertices = _vertices(k)
    around = {v: link(k, frozenset({v})) for v in vertices}
    hidden = {around[v] for v in vertices[len(vertices) // 2 :]}
    first = frozenset({min(v for v in vertices if around[v] in hidden)})

    def halting(at: Complex) -> LinkKind:
        return shy(at) if at in hidden else trusting(at)

    return same(UndecidedAt(first, "not looked at"), manifold(k, halting))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "low-spheres-and-balls-are-told-by-homology",
        Clause.CPLX_SPHERE_1,
        "Up to dimension 2 a sphere or ball is recognised exactly if it is, by ranks over two "
        "elements, a manifold with the homology of one.",
        NEAR_MANIFOLDS,
        _recognised,
    ),
    Law(
        "recognition-beyond-dimension-2-claims-nothing",
        Clause.CPLX_SPHERE_3,
        "In dimension 3 what looks like neither is refuted, and all else is left undecided.",
        NEAR_MANIFOLDS,
        _claims,
    ),
    Law(
        "manifolds-made-to-order-are-manifolds",
        Clause.CPLX_MANIFOLD_1,
        "Sums of spheres, handles and balls, changed by moves, are manifolds of their dimension.",
        MANIFOLDS,
        _made,
    ),
    Law(
        "low-manifolds-are-decided",
        Clause.CPLX_MANIFOLD_2,
        "Up to dimension 3 the answer is never undecided, and no recogniser changes it.",
        NEAR_MANIFOLDS,
        _exact,
    ),
    Law(
        "the-lowest-fault-is-blamed",
        Clause.CPLX_MANIFOLD_3,
        "A complex that is no manifold is refuted at the first fault, by the order of the clause.",
        NEAR_MANIFOLDS,
        _blamed,
    ),
    Law(
        "low-manifolds-are-told-by-homology",
        Clause.CPLX_MANIFOLD_4,
        "Up to dimension 3 links recognised by counting and homology of all links agree.",
        NEAR_MANIFOLDS,
        _two_readings,
    ),
    Law(
        "recognised-links-prove-a-manifold",
        Clause.CPLX_MANIFOLD_5,
        "A 4-manifold is proved one by a recogniser that knows its links.",
        FOUR_MANIFOLDS,
        _proved,
    ),
    Law(
        "homology-refutes-in-dimension-4",
        Clause.CPLX_MANIFOLD_6,
        "Without any recogniser the lowest simplex whose link looks wrong is blamed, if there is "
        "one, and otherwise nothing is decided.",
        NEAR_FOUR_MANIFOLDS,
        _refuted,
    ),
    Law(
        "the-lowest-unknown-link-is-named",
        Clause.CPLX_MANIFOLD_7,
        "If a recogniser leaves links of a 4-manifold open, the lowest such vertex is named.",
        FOUR_MANIFOLDS,
        _undecided,
    ),
    Law(
        "walls-lie-in-one-or-two",
        Clause.CPLX_MANIFOLD_8,
        "Each (n−1)-simplex of an n-manifold is a face of one or two n-simplices.",
        MANIFOLDS,
        _walls,
    ),
    Law(
        "boundary-of-a-manifold-is-closed",
        Clause.CPLX_MANIFOLD_9,
        "The boundary is empty or a manifold of one dimension less, without boundary, with as "
        "many components as balls were removed.",
        MANIFOLDS,
        _boundary,
    ),
    Law(
        "bounding-vertices-are-those-of-the-boundary",
        Clause.CPLX_MANIFOLD_10,
        "The vertices with a ball for their link are the vertices of the boundary.",
        MANIFOLDS,
        _inner,
    ),
    Law(
        "surfaces-are-the-2-manifolds",
        Clause.CPLX_MANIFOLD_11,
        "A complex is a manifold of dimension 2 exactly if it is a surface as chapter 3 says.",
        NEAR_MANIFOLDS,
        _surfaces,
    ),
)
