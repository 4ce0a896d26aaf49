"""Laws of oriented simplices, of coherence, and of its certificates."""

from itertools import permutations
from math import factorial
from typing import Final

from clers.complexes.given import SMALL_SURFACES
from clers.complexes.homology import Field, coherent_chains
from clers.complexes.manifolds.certificates import is_coherent, is_one_sided, neighbours_at
from clers.complexes.manifolds.given import MANIFOLDS, NEAR_MANIFOLDS, ORDERINGS, Prescribed
from clers.complexes.manifolds.incidence import flaw_at_a_wall
from clers.complexes.manifolds.orient import OneSided, Oriented, orient
from clers.complexes.manifolds.orientation import (
    OrientedSimplex,
    induced,
    joined,
    next_vertex,
    opposite,
    ordering,
    oriented,
    previous_vertex,
)
from clers.complexes.simplicial import Complex, Simplex, boundary, closure, dimension, of_dimension
from clers.complexes.surface import Corner, Surface, next_corner, previous_corner
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Verdict
from clers.conventions.where import AtSimplex


def _exchanged(given: tuple[int, ...], i: int) -> tuple[int, ...]:
    return (*given[:i], given[i + 1], given[i], *given[i + 2 :])


def _parity(given: tuple[int, ...]) -> Verdict:
    match oriented(given):
        case Accepted(of):
            neighbours = [oriented(_exchanged(given, i)) for i in range(len(given) - 1)]
            return every(
                same(Accepted(OrientedSimplex(of.vertices, positive=True)), oriented(of.vertices)),
                same(of, opposite(opposite(of))),
                *(same(Accepted(opposite(of)), other) for other in neighbours),
            )
        case Rejected() as fault:
            return same("an orientation", fault)


def _representative(given: tuple[int, ...]) -> Verdict:
    """Among all orderings half are meant; of these the least is told. A point has one only."""
    of = oriented(given)
    meant = [other for other in permutations(sorted(given)) if oriented(other) == of]
    half = max(1, factorial(len(given)) // 2)
    told = ordering(of.value) if isinstance(of, Accepted) else ()
    return every(same(half, len(meant)), same(min(meant), told))


def _induction(given: tuple[int, ...]) -> Verdict:
    """Any vertex can be brought to the front: the rest is then the wall's orientation."""
    if len(given) < 2:
        return same(OrientedSimplex((), positive=True), induced(_simplex(given), given[0]))
    front = _simplex(given)
    wall = _simplex(given[1:])
    return every(
        same(wall, induced(front, given[0])),
        same(front, joined(given[0], wall)),
        *(same(front, joined(v, induced(front, v))) for v in given),
    )


def _simplex(given: tuple[int, ...]) -> OrientedSimplex:
    answer = oriented(given)
    return answer.value if isinstance(answer, Accepted) else OrientedSimplex((), positive=False)


def _certified(k: Complex) -> Verdict:
    answer = orient(k)
    match answer:
        case Oriented(simplices):
            lowest = {part[0] for part in _strong_parts(k)}
            named = [frozenset(simplex.vertices) for simplex in simplices]
            first = [s.positive for s, name in zip(simplices, named, strict=True) if name in lowest]
            return every(
                same(True, is_coherent(k, answer)),
                same(list(of_dimension(k, dimension(k))), named),
                same([True] * len(lowest), first),
            )
        case OneSided():
            return same(True, is_one_sided(k, answer))
        case Rejected():
            return same(True, flaw_at_a_wall(k) is not None)


def _strong_parts(k: Complex) -> list[list[Simplex]]:
    """The strongly connected parts, each in lexicographic order: found by spreading."""
    left = list(of_dimension(k, dimension(k)))
    walls = [neighbours_at(k, wall) for wall in of_dimension(k, dimension(k) - 1)]
    parts: list[list[Simplex]] = []
    while left:
        part = {left[0]}
        while more := {s for sides in walls if part & set(sides) for s in sides} - part:
            part |= more
        parts.append(sorted(part, key=sorted))
        left = [s for s in left if s not in part]
    return parts


def _exclusive(k: Complex) -> Verdict:
    answer = orient(k)
    if isinstance(answer, Rejected):
        return same(True, flaw_at_a_wall(k) is not None)
    parts = len(_strong_parts(k))
    return every(
        same(parts, coherent_chains(k, Field.GF2)),
        same(isinstance(answer, Oriented), coherent_chains(k, Field.Q) == parts),
    )


def _made(given: Prescribed) -> Verdict:
    two_sided = all(piece.orientable for piece in given.pieces)
    return same(two_sided, isinstance(orient(given.complex), Oriented))


def _turned(k: Complex) -> Verdict:
    """Turning one part keeps coherence, turning one of several neighbours breaks it."""
    answer = orient(k)
    if not isinstance(answer, Oriented):
        return same(True, True)
    parts = _strong_parts(k)
    alone = [[part[0]] for part in parts if len(part) > 1]
    return every(
        *(same(True, is_coherent(k, _with_turned(answer, part))) for part in parts),
        *(same(False, is_coherent(k, _with_turned(answer, part))) for part in alone),
    )


def _with_turned(of: Oriented, part: list[Simplex]) -> Oriented:
    return Oriented(
        tuple(opposite(s) if frozenset(s.vertices) in part else s for s in of.simplices)
    )


def _corners(of: Surface) -> Verdict:
    triangles = [_simplex(tuple(triangle)) for triangle in of.triangles()]
    corners = [Corner(c) for c in range(len(of.vertex))]
    return every(
        same(True, is_coherent(closure(of.triangles()), Oriented(tuple(triangles)))),
        *(
            every(
                same(Accepted(of.vertex[next_corner(c)]), next_vertex(triangle, of.vertex[c])),
                same(Accepted(of.vertex[previous_corner(c)]), previous_vertex(triangle, v)),
            )
            for c in corners
            for v, triangle in [(of.vertex[c], triangles[c // 3])]
        ),
    )


def _rejected(k: Complex) -> Verdict:
    fault, answer = flaw_at_a_wall(k), orient(k)
    if fault is None:
        return same(False, isinstance(answer, Rejected))
    at = AtSimplex(tuple(sorted(fault.simplex)))
    expected = Rejected(Reason.NOT_A_MANIFOLD, Clause.CPLX_COHERENT_8, at, fault.flaw)
    return same(expected, answer)


def _boundary(given: Prescribed) -> Verdict:
    k, answer = given.complex, orient(given.complex)
    rim = boundary(k)
    if not isinstance(answer, Oriented) or not rim.simplices:
        return same(True, True)
    walls = of_dimension(rim, given.dimension - 1)
    found = tuple(
        induced(s, v)
        for s in answer.simplices
        for v in s.vertices
        if frozenset(s.vertices) - {v} in walls
    )
    return same(True, is_coherent(rim, Oriented(found)))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "an-exchange-of-two-vertices-is-the-opposite",
        Clause.CPLX_COHERENT_1,
        "Exchanging neighbours in an ordering turns the orientation over; twice is the same.",
        ORDERINGS,
        _parity,
    ),
    Law(
        "half-of-the-orderings-are-one-orientation",
        Clause.CPLX_COHERENT_1,
        "Half of all orderings stand for an orientation, and the least of them represents it.",
        ORDERINGS,
        _representative,
    ),
    Law(
        "apex-and-induced-wall-make-up-the-simplex",
        Clause.CPLX_COHERENT_2,
        "An ordering induces on the wall without its first vertex what is left of it.",
        ORDERINGS,
        _induction,
    ),
    Law(
        "certificates-of-orientation-are-good",
        Clause.CPLX_COHERENT_4,
        "What orient answers passes the checker of orientations, or that of one-sided cycles.",
        NEAR_MANIFOLDS,
        _certified,
    ),
    Law(
        "certificates-are-good-on-manifolds",
        Clause.CPLX_COHERENT_3,
        "The same on manifolds with handles and cross-caps: the lowest of a part is positive.",
        MANIFOLDS,
        lambda given: _certified(given.complex),
    ),
    Law(
        "orientable-as-ranks-say",
        Clause.CPLX_COHERENT_5,
        "There is a coherent orientation exactly if the coherent chains over the rationals have "
        "as many dimensions as there are strongly connected parts.",
        NEAR_MANIFOLDS,
        _exclusive,
    ),
    Law(
        "manifolds-are-orientable-as-made",
        Clause.CPLX_COHERENT_5,
        "A manifold is orientable exactly if no cross-cap and no twisted handle was put in.",
        MANIFOLDS,
        _made,
    ),
    Law(
        "each-part-can-be-turned",
        Clause.CPLX_COHERENT_6,
        "Turning a strongly connected part keeps an orientation coherent; turning one simplex "
        "that has neighbours does not.",
        NEAR_MANIFOLDS,
        _turned,
    ),
    Law(
        "next-and-previous-are-those-of-the-corners",
        Clause.CPLX_COHERENT_7,
        "The triangles of a corner table are coherent, and next and previous agree with it.",
        SMALL_SURFACES,
        _corners,
    ),
    Law(
        "pseudomanifolds-are-oriented",
        Clause.CPLX_COHERENT_8,
        "Exactly what is not pure or has a wall in three is rejected, at that simplex.",
        NEAR_MANIFOLDS,
        _rejected,
    ),
    Law(
        "the-boundary-is-oriented-by-induction",
        Clause.CPLX_COHERENT_9,
        "An oriented manifold induces a coherent orientation on its boundary.",
        MANIFOLDS,
        _boundary,
    ),
)
