"""Edge contraction with the link condition, of manifolds with and without boundary.

With boundary, a cone over it closes the manifold: a contraction may neither pinch the boundary nor
make it too short, and that the links in the closed complex know.
On manifolds the condition is exact. Clauses: OPER-CONTRACT-2, OPER-CONTRACT-3.
"""

from typing import assert_never

from clers.complexes.manifolds.incidence import rim
from clers.complexes.manifolds.kind import Ball, Neither, Sphere, Undecided
from clers.complexes.simplicial import Complex, Simplex, link
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtPair, AtSimplex
from clers.operators.moves.augmented import EMPTY, around, complex_of, in_order, joined
from clers.operators.moves.move import Contract
from clers.operators.moves.operand import bad_operand, missing
from clers.operators.moves.recognise import recognise


def contract(k: Complex, move: Contract) -> Accepted[Complex] | Rejected:
    """The vertex `gone` becomes the vertex `keep`. Clauses: OPER-CONTRACT-1, OPER-CONTRACT-5."""
    edge = frozenset([move.keep, move.gone])
    fault = (
        bad_operand((move.keep,), (move.gone,))
        or _no_edge(move)
        or missing(k, [edge], Clause.OPER_CONTRACT_1)
        or _link_condition(k, move)
    )
    if fault is not None:
        return fault
    after = merged(k, move)
    return _mended(k, after, move) or Accepted(after)


def _mended(before: Complex, after: Complex, move: Contract) -> Rejected | None:
    """Would a sphere or ball be the one vertex's link, and is not that of both ends?"""
    known = recognise(link(after, frozenset([move.keep])))
    match known:
        case Sphere() | Ball():
            pass
        case Neither() | Undecided():
            return None
        case _:
            assert_never(known)
    for vertex in (move.keep, move.gone):
        found = recognise(link(before, frozenset([vertex])))
        match found:
            case Sphere(n) | Ball(n) if n == known.dimension:
                continue
            case _:
                detail = f"its link is no ball or sphere of dimension {known.dimension}"
                where = AtSimplex((vertex,))
                return Rejected(Reason.WRONG_LINK, Clause.OPER_CONTRACT_5, where, detail)
    return None


def merged(k: Complex, move: Contract) -> Complex:
    """The image of the complex where `gone` is named `keep`. Clause: OPER-CONTRACT-1."""
    here, there = frozenset([move.keep]), frozenset([move.gone])
    return Complex(frozenset(s - there | here if there <= s else s for s in k.simplices))


def _no_edge(move: Contract) -> Rejected | None:
    if move.keep != move.gone:
        return None
    return Rejected(Reason.BAD_OPERAND, Clause.OPER_MOVE_2, WHOLE, "an edge has two ends")


def coned(k: Complex) -> tuple[Complex, int]:
    """The complex with a cone over its boundary, and the cone's top. Clause: OPER-CONTRACT-1.

    The top is −1 or, where vertices are negative, below them: no vertex that an operand can name.
    """
    top = min([0, *(v for simplex in k.simplices for v in simplex)]) - 1
    cone = joined([frozenset([top])], rim(k).simplices | {EMPTY})
    return (k if len(cone) == 1 else complex_of(k.simplices | cone)), top


def _link_condition(k: Complex, move: Contract) -> Rejected | None:
    """Blamed: the least simplex of the complex in both links, not in the link of the edge."""
    whole, top = coned(k)
    here, there = frozenset([move.keep]), frozenset([move.gone])
    odd = around(whole, here) & around(whole, there) - around(whole, here | there)
    if not odd:
        return None
    edge = in_order(here | there)
    least = min(odd, key=lambda simplex: (top in simplex, len(simplex), sorted(simplex)))
    if top in least:
        detail = "the boundary would be pinched, or would be too short"
        return Rejected(Reason.LINK_CONDITION, Clause.OPER_CONTRACT_1, AtSimplex(edge), detail)
    where = AtPair(edge, in_order(least))
    return Rejected(Reason.LINK_CONDITION, Clause.OPER_CONTRACT_1, where)


def shared_and_moved(k: Complex, move: Contract) -> tuple[frozenset[Simplex], frozenset[Simplex]]:
    """The link of the edge, and the link of `gone` without `keep`. Clause: OPER-CONTRACT-4."""
    here, there = frozenset([move.keep]), frozenset([move.gone])
    shared = around(k, here | there)
    moved = frozenset(simplex for simplex in around(k, there) if not here & simplex)
    return shared, moved
