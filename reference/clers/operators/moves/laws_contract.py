"""The laws of contractions and splits: on manifolds the condition is exact."""

from typing import Final

from clers.complexes.manifolds.incidence import rim
from clers.complexes.simplicial import Complex, Simplex, dimension, of_dimension
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import AtSimplex
from clers.operators.moves.apply import apply, inverse
from clers.operators.moves.augmented import EMPTY, in_order
from clers.operators.moves.contract import contract, merged
from clers.operators.moves.given import CLOSED_SPACES, CURVES_AND_SURFACES, SPLITS, Sited
from clers.operators.moves.laws_common import described
from clers.operators.moves.move import Contract, Split
from clers.operators.moves.split import split


def _exact(k: Complex) -> Verdict:
    """Every edge both ways: it applies exactly if what comes out is what went in.

    With boundary, and if also no two facets become one.
    """
    before = described(k)
    verdicts: list[Verdict] = []
    for edge in of_dimension(k, 1):
        move = Contract(*in_order(edge))
        image, after = merged(k, move), contract(k, move)
        is_same = described(image) == before and (
            not rim(k).simplices or _facets(k) - _facets(image) == _facets_at(k, edge)
        )
        expected = Accepted(image) if is_same else after
        where = AtSimplex(in_order(edge))
        verdicts.append(same(is_same, isinstance(after, Accepted), where))
        verdicts.append(same(expected, after, where))
    return every(*verdicts)


def _facets(k: Complex) -> int:
    return len(of_dimension(k, dimension(k)))


def _facets_at(k: Complex, edge: Simplex) -> int:
    return sum(edge <= facet for facet in of_dimension(k, dimension(k)))


def _back(k: Complex) -> Verdict:
    """Each contraction that applies, and its split."""
    verdicts: list[Verdict] = []
    for edge in of_dimension(k, 1):
        move = Contract(*in_order(edge))
        after = contract(k, move)
        if isinstance(after, Accepted):
            verdicts.append(same(Accepted(k), apply(inverse(move, k), after.value)))
    return every(*verdicts)


def _split_leads_back(sited: Sited) -> Verdict:
    k, move = sited
    if not isinstance(move, Split):
        return Fails("a split", repr(move), AtSimplex(()))
    after = split(k, move)
    if isinstance(after, Rejected):
        return Holds()
    return same(Accepted(k), contract(after.value, Contract(move.vertex, move.new)))


def _split_exact(sited: Sited) -> Verdict:
    """The split made regardless: accepted exactly if it is a manifold like the one before."""
    k, move = sited
    if not isinstance(move, Split):
        return Fails("a split", repr(move), AtSimplex(()))
    after = split(k, move)
    made = made_regardless(k, move)
    if made is None:
        return same(True, isinstance(after, Rejected))
    if described(made) == described(k):
        return same(Accepted(made), after)
    match after:
        case Rejected(Reason.LINK_CONDITION | Reason.WRONG_LINK):
            return Holds()
        case _:
            return Fails("a rejection", repr(after), AtSimplex((move.vertex,)))


def made_regardless(k: Complex, move: Split) -> Complex | None:
    """What the parts make, if they fit: seen from the result, which must contract to the complex.

    Simplices at the old vertex stay if they have a vertex that does not move or are shared.
    """
    a, b = frozenset([move.vertex]), frozenset([move.new])
    all_of_k = k.simplices | {EMPTY}
    moved = {s for s in all_of_k if any(s <= set(d) for d in move.moved)} | {EMPTY}
    shared = {s for s in all_of_k if any(s <= set(d) for d in move.shared)} | {EMPTY}
    go = {a | s for s in moved - shared}
    come = {b | s for s in moved} | {a | b | s for s in shared}
    made = Complex(frozenset((k.simplices - go) | come))
    fits = (
        b not in k.simplices
        and all((a & s) == EMPTY and a | s in k.simplices for s in moved)
        and all(set(s) in [set(m) for m in moved] for s in move.shared)
        and all(set(d) in [set(m) for m in moved] for d in move.moved)
        and all(s - {v} in made.simplices for s in made.simplices if len(s) > 1 for v in s)
        and merged(made, Contract(move.vertex, move.new)) == k
    )
    return made if fits else None


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "contraction-is-undone-by-a-split",
        Clause.OPER_CONTRACT_1,
        "Each contraction that applies to a curve or surface has a split that leads back.",
        CURVES_AND_SURFACES,
        _back,
    ),
    Law(
        "contraction-condition-is-exact",
        Clause.OPER_CONTRACT_2,
        "An edge of a curve or surface can be contracted if that gives a manifold of the same "
        "kind, and no two faces become one, and not otherwise.",
        CURVES_AND_SURFACES,
        _exact,
    ),
    Law(
        "contraction-condition-is-exact-in-space",
        Clause.OPER_CONTRACT_3,
        "The same for closed 3-manifolds, told apart by homology.",
        CLOSED_SPACES,
        _exact,
    ),
    Law(
        "split-is-undone-by-a-contraction",
        Clause.OPER_CONTRACT_4,
        "The contraction of the new edge leads back.",
        SPLITS,
        _split_leads_back,
    ),
    Law(
        "split-condition-is-exact",
        Clause.OPER_CONTRACT_6,
        "Parts of a link that fit together split a curve or surface if that gives a manifold of "
        "the same kind, and not otherwise.",
        SPLITS,
        _split_exact,
    ),
)
