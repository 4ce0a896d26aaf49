"""Manifolds with prescribed dimension, orientability, genus, curves and components.

Each is made to order, then changed by moves that keep it what it is, then renamed. It shrinks: to
fewer moves, lesser types, names from 0, and with nothing asked of it to the smallest of its type.
"""

from collections.abc import Iterable, Mapping
from random import Random
from typing import Final

from hypothesis import strategies as st

from clers.complexes.manifolds.given import Piece, Prescribed
from clers.complexes.simplicial import Complex, closure, dimension, of_dimension
from clers.conventions.result import Accepted
from clers.generate.bounds import Range
from clers.generate.complexes import SEEDS
from clers.generate.manifold_pieces import made
from clers.generate.scripts import CHOICES
from clers.operators.moves.bistellar import bistellar
from clers.operators.moves.move import Bistellar, Subdivide
from clers.operators.moves.stellar import subdivide

TRIES: Final = 12
"""So many simplices in a row are tried for a flip, before it is given up."""


def pieces(
    n: int,
    orientable: bool | None = None,
    genus: Range = (0, 1),
    curves: Range = (0, 2),
) -> st.SearchStrategy[Piece]:
    """What connected n-manifolds may be made of, within ranges (lowest, highest).

    A circle has no curve and an arc has two; in dimensions 0, 1 and even ones from 4 on all are
    orientable, and nothing is drawn where that contradicts what is asked.
    """
    if n < 2:
        ends = [2 * end for end in range(n + 1) if curves[0] <= 2 * end <= curves[1]]
        if orientable is False or genus[0] > 0 or not ends:
            return NONE
        return st.builds(Piece, st.just(True), st.just(0), st.sampled_from(ends))
    two_sided = st.builds(Piece, st.just(True), st.integers(*genus), st.integers(*curves))
    lowest = max(genus[0], 1)
    if orientable is True or (n > 2 and n % 2 == 0) or lowest > genus[1]:
        return NONE if orientable is False else two_sided
    one_sided = st.builds(
        Piece, st.just(False), st.integers(lowest, genus[1]), st.integers(*curves)
    )
    return one_sided if orientable is False else st.one_of(two_sided, one_sided)


NONE: Final[st.SearchStrategy[Piece]] = st.nothing()


def manifolds(
    n: int,
    orientable: bool | None = None,
    genus: Range = (0, 1),
    curves: Range = (0, 2),
    components: Range = (1, 2),
    moves: int = 4,
) -> st.SearchStrategy[Prescribed]:
    """n-manifolds, n ≤ 4; genus and curves are those of each component. See `pieces`.

    With `orientable` False no component can be oriented; None leaves it to each.
    """
    parts = st.lists(
        pieces(n, orientable, genus, curves), min_size=components[0], max_size=components[1]
    )
    steps = st.lists(st.tuples(st.booleans(), CHOICES), max_size=moves)
    return st.builds(_prescribed, st.just(n), parts, CHOICES, steps, SEEDS)


def _prescribed(
    n: int, parts: list[Piece], place: int, steps: list[tuple[bool, int]], seed: int
) -> Prescribed:
    k = union(*(made(n, piece, place) for piece in parts))
    for grow, choice in steps:
        k = _grown(k, choice) if grow else _flipped(k, choice)
    return Prescribed(_shuffled(k, seed), n, tuple(parts))


def _shuffled(k: Complex, seed: int) -> Complex:
    """Other names, some of them left out between; seed 0 keeps the names."""
    old = sorted(set().union(*k.simplices))
    new = list(range(len(old) + 2))
    if seed:
        Random(seed).shuffle(new)
    return renamed(k, dict(zip(old, new, strict=False)))


def renamed(k: Complex, name: Mapping[int, int]) -> Complex:
    """The complex with other names; two names made one identify vertices."""
    return Complex(frozenset(frozenset(name.get(v, v) for v in s) for s in k.simplices))


def union(*parts: Complex) -> Complex:
    """Complexes side by side, the vertices numbered on."""
    simplices: set[frozenset[int]] = set()
    free = 0
    for part in parts:
        simplices |= {frozenset(v + free for v in s) for s in part.simplices}
        free = 1 + max((max(s) for s in simplices), default=-1)
    return Complex(frozenset(simplices))


def _grown(k: Complex, choice: int) -> Complex:
    """A new vertex in some simplex that is no vertex."""
    large = sorted((tuple(sorted(s)) for s in k.simplices if len(s) > 1), reverse=True)
    if not large:
        return k
    free = 1 + max(max(s) for s in k.simplices)
    answer = subdivide(k, Subdivide(large[choice % len(large)], free))
    return answer.value if isinstance(answer, Accepted) else k


def _flipped(k: Complex, choice: int) -> Complex:
    """A bistellar flip at some simplex, where one near to the choice is found."""
    n = dimension(k)
    small = [s for m in range(n) for s in of_dimension(k, m)]
    for i in range(min(TRIES, len(small))):
        gone = small[(choice + i) % len(small)]
        come = frozenset[int]().union(*(s for s in k.simplices if s > gone)) - gone
        if len(gone) + len(come) == n + 2:
            move = Bistellar(tuple(sorted(gone)), tuple(sorted(come)))
            answer = bistellar(k, move)
            if isinstance(answer, Accepted):
                return answer.value
    return k


@st.composite
def broken(draw: st.DrawFn, of: st.SearchStrategy[Prescribed], top: int) -> Complex:
    """A manifold with a fault or two, or a cone over one, of dimension `top` at most."""
    k = draw(of).complex
    for fault, choice, other in draw(
        st.lists(st.tuples(st.integers(0, 7), CHOICES, CHOICES), min_size=1, max_size=2)
    ):
        k = _spoiled(k, fault, choice, other, top)
    return k


def _spoiled(k: Complex, fault: int, choice: int, other: int, top: int) -> Complex:
    vertices = sorted(set().union(*k.simplices))
    ordered = sorted((tuple(sorted(s)) for s in k.simplices), reverse=True)
    simplex = frozenset(ordered[choice % len(ordered)])
    v, w = vertices[choice % len(vertices)], vertices[other % len(vertices)]
    free = vertices[-1] + 1
    match fault:
        case 1:
            return renamed(k, {v: w})
        case 2:
            rest = Complex(frozenset(s for s in k.simplices if not s >= simplex))
            return rest if rest.simplices else k
        case 3:
            return closure([*k.simplices, {v, w, free}])
        case 4:
            return closure([*k.simplices, {*sorted(simplex)[:top], free}])
        case 5 | 6 if dimension(k) < top:
            return coned(k, range(free, free + fault - 4))
        case 7:
            return closure([*k.simplices, {v, w}])
        case _:
            return k


def coned(k: Complex, tips: Iterable[int]) -> Complex:
    """A complex with a cone over it for each tip: over two it is the suspension."""
    return closure([*k.simplices, *(s | {tip} for s in k.simplices for tip in tips)])


def surfaces_of_any_type() -> st.SearchStrategy[Prescribed]:
    """2-manifolds of every type: up to three handles or cross-caps, up to three curves."""
    return manifolds(2, genus=(0, 3), curves=(0, 3), components=(1, 3))


def _pairs() -> st.SearchStrategy[tuple[Prescribed, Prescribed]]:
    """Small types, which often agree."""
    small = manifolds(2, genus=(0, 2), curves=(0, 1), components=(1, 2), moves=2)
    return st.tuples(small, small)


def _up_to_three() -> st.SearchStrategy[Prescribed]:
    return st.one_of(
        manifolds(0, components=(0, 4)), manifolds(1, components=(1, 3)), manifolds(2), manifolds(3)
    )


def _cone(of: Prescribed) -> Prescribed:
    """A manifold only if it was a sphere or a ball."""
    free = 1 + max(map(max, of.complex.simplices))
    return Prescribed(coned(of.complex, (free,)), of.dimension + 1, of.pieces)


def _suspended(of: Prescribed) -> Prescribed:
    """Between two tips: a manifold only if it was a sphere or a ball."""
    free = 1 + max(map(max, of.complex.simplices))
    return Prescribed(coned(of.complex, (free, free + 1)), of.dimension + 1, of.pieces)


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "prescribed-manifolds": _up_to_three(),
    "prescribed-surfaces": surfaces_of_any_type(),
    "prescribed-surface-pairs": _pairs(),
    "near-manifolds": broken(
        st.one_of(
            manifolds(0, components=(1, 4), moves=0),
            *(manifolds(n, components=(1, 2), curves=(0, 2), moves=2) for n in (1, 2, 3)),
        ),
        3,
    ),
    "prescribed-4-manifolds": manifolds(4, genus=(0, 0), curves=(0, 2), components=(1, 2), moves=2),
    "near-4-manifolds": broken(
        st.one_of(
            manifolds(3, genus=(0, 0), components=(1, 1), moves=1).map(_suspended),
            manifolds(2, curves=(0, 1), components=(1, 1), moves=0).map(_cone).map(_suspended),
            manifolds(4, genus=(0, 0), components=(1, 1), moves=2),
        ),
        4,
    ),
    "orderings": st.lists(st.integers(0, 9), min_size=1, max_size=6, unique=True).map(tuple),
}
"""The domains of this module, by name."""
