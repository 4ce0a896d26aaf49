"""Each law of moves fails when what it judges is broken on purpose."""

from dataclasses import replace
from random import Random

import pytest
from hypothesis import HealthCheck, Phase, find, settings

from clers.complexes.manifolds.kind import Ball, LinkKind
from clers.complexes.simplicial import Complex, Simplex, closure, dimension, of_dimension
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails
from clers.conventions.where import AtSimplex
from clers.generate.domains import strategy_for
from clers.operators.moves import (
    laws_collapse,
    laws_common,
    laws_contract,
    laws_recognise,
    laws_stellar,
)
from clers.operators.moves.apply import apply, inverse, replay
from clers.operators.moves.bistellar import bistellar
from clers.operators.moves.collapse import collapse, expand, free_pairs
from clers.operators.moves.collapsible import Collapsibility, Collapsible, collapse_to_point
from clers.operators.moves.contract import contract, merged
from clers.operators.moves.effect import effect
from clers.operators.moves.laws import LAWS
from clers.operators.moves.move import (
    Bistellar,
    Collapse,
    Contract,
    Expand,
    Move,
    Split,
    Subdivide,
    Weld,
)
from clers.operators.moves.reach import automorphisms
from clers.operators.moves.recognise import Recognition, recognise, recognition
from clers.operators.moves.simplify import simplifying
from clers.operators.moves.split import split
from clers.operators.moves.stellar import subdivide
from clers.operators.moves.text import write

FIRST = settings(
    max_examples=400,
    database=None,
    deadline=None,
    phases=[Phase.generate],
    suppress_health_check=list(HealthCheck),
)
SHRUNK = settings(FIRST, phases=[Phase.generate, Phase.shrink], max_examples=800)

Result = Accepted[Complex] | Rejected


def named(name: str) -> AnyLaw:
    (law,) = [law for law in LAWS if law.name == name]
    return law


def failing(law: AnyLaw, how: settings = FIRST) -> object:
    """An example on which the law fails; an error where none is found."""
    domain = strategy_for(law.domain)
    assert domain is not None
    return find(
        domain, lambda drawn: isinstance(law.check(drawn), Fails), settings=how, random=Random(0)
    )


# Faults, each in one function, most of them in few cases.


def leaves_a_hole(move: Move, k: Complex) -> Result:
    """Of a subdivision, an edge of the result is forgotten."""
    result = apply(move, k)
    if isinstance(result, Accepted) and isinstance(move, Subdivide):
        edges = of_dimension(result.value, 1)
        return Accepted(Complex(result.value.simplices - set(edges[:1])))
    return result


def blames_another(move: Move, k: Complex) -> Result:
    result = apply(move, k)
    if isinstance(result, Rejected) and isinstance(result.where, AtSimplex):
        other = min(k.simplices, key=sorted)
        missing = result.reason is Reason.MISSING_SIMPLEX
        return replace(result, where=AtSimplex(tuple(sorted(other)) if missing else (1000,)))
    return result


def takes_any_operand(move: Move, k: Complex) -> Result:
    result = apply(move, k)
    if isinstance(result, Rejected) and result.reason is Reason.BAD_OPERAND:
        return replace(result, reason=Reason.MISSING_SIMPLEX)
    return result


def replays_backwards(moves: tuple[Move, ...], k: Complex) -> Result:
    return replay(moves[:1], k)


def forgets_what_is_shared(move: Move, k: Complex) -> Move:
    found = inverse(move, k)
    return replace(found, shared=()) if isinstance(found, Split) else found


def removes_only_the_simplex(move: Move, k: Complex) -> Result:
    if isinstance(move, Collapse) and isinstance(apply(move, k), Accepted):
        return Accepted(Complex(k.simplices - {frozenset(move.coface)}))
    return apply(move, k)


def counts_no_vertex(move: Move, k: Complex) -> tuple[int, ...]:
    change = effect(move, k)
    return (0, *change[1:]) if isinstance(move, Contract) else change


def contracts_anything(move: Move, k: Complex) -> Result:
    result = apply(move, k)
    if isinstance(move, Contract) and isinstance(result, Rejected):
        return Accepted(merged(k, move))
    return result


def writes_half(moves: tuple[Move, ...]) -> str:
    return write(moves).replace(" /", " ", 1)


def collapses_all(k: Complex, move: Collapse) -> Result:
    """As if the coface alone had to be maximal."""
    result = collapse(k, move)
    if isinstance(result, Rejected) and result.reason is Reason.NOT_FREE:
        return Accepted(Complex(k.simplices - {frozenset(move.free), frozenset(move.coface)}))
    return result


def expands_all(k: Complex, move: Expand) -> Result:
    result = expand(k, move)
    if isinstance(result, Rejected) and result.reason is Reason.MISSING_SIMPLEX:
        return Accepted(k)
    return result


def drops_a_pair(k: Complex) -> tuple[tuple[Simplex, Simplex], ...]:
    return free_pairs(k)[1:]


def takes_the_coface_alone(k: Complex, move: Collapse) -> Result:
    return Accepted(Complex(k.simplices - {frozenset(move.coface)}))


def always_collapses(k: Complex, budget: int = 50) -> Collapsibility:
    found = collapse_to_point(k, budget)
    return found if isinstance(found, Collapsible) else Collapsible(())


def depends_on_size(k: Complex, budget: int = 50) -> Collapsibility:
    found = collapse_to_point(k, budget)
    return found if len(k.simplices) % 4 == 1 else always_collapses(k, budget)


def loses_the_link(k: Complex, move: Subdivide) -> Result:
    return subdivide(closure([move.simplex]), move)


def welds_nothing(k: Complex, move: Weld) -> Result:
    return Rejected(Reason.WRONG_LINK, Clause.OPER_STELLAR_2)


def contracts_nothing(k: Complex, move: Contract) -> Result:
    return Rejected(Reason.LINK_CONDITION, Clause.OPER_CONTRACT_1)


def flips_to_the_same(k: Complex, move: Bistellar) -> Result:
    result = bistellar(k, move)
    return Accepted(k) if isinstance(result, Accepted) else result


def doubles(move: Move, k: Complex) -> tuple[int, ...]:
    return tuple(2 * change for change in effect(move, k))


def contracts_most(k: Complex, move: Contract) -> Result:
    """Without the cone over the boundary."""
    result = contract(k, move)
    if isinstance(result, Rejected) and result.reason is Reason.LINK_CONDITION:
        return Accepted(merged(k, move)) if isinstance(result.where, AtSimplex) else result
    return result


def contracts_over_triangles(k: Complex, move: Contract) -> Result:
    result = contract(k, move)
    return Accepted(merged(k, move)) if isinstance(result, Rejected) else result


def splits_too_much(k: Complex, move: Split) -> Result:
    result = split(k, move)
    return Accepted(k) if isinstance(result, Rejected) else result


def moves_all(k: Complex, move: Split) -> Result:
    result = split(k, move)
    return Accepted(k) if isinstance(result, Accepted) else result


def wanders(k: Complex, effort: int, seed: int = 0) -> tuple[Bistellar, ...]:
    moves = simplifying(k, effort, seed)
    return (*moves, *moves[:1])


def sees_balls(k: Complex) -> LinkKind:
    return Ball(3) if recognise(k) != Ball(3) else Ball(4)


def shows_nothing(k: Complex) -> Recognition:
    return replace(recognition(k), moves=recognition(k).moves[1:])


def all_alike(k: Complex) -> int:
    return dimension(k)


def one_more(k: Complex) -> int:
    return automorphisms(k) + 1


def its_facets(k: Complex) -> object:
    return of_dimension(k, 2)


common, collapses, stellar = laws_common, laws_collapse, laws_stellar
contracts, recognises = laws_contract, laws_recognise

FAULTS = [
    ("moves-ask-for-operands", common, "apply", takes_any_operand),
    ("moves-make-complexes", common, "apply", leaves_a_hole),
    ("moves-blame-what-is-so", common, "apply", blames_another),
    ("moves-run-in-order", common, "replay", replays_backwards),
    ("moves-are-undone", common, "inverse", forgets_what_is_shared),
    ("moves-keep-homology", common, "apply", removes_only_the_simplex),
    ("moves-change-numbers-by-formula", common, "effect", counts_no_vertex),
    ("moves-keep-manifolds", common, "apply", contracts_anything),
    ("moves-text-round-trip", common, "write", writes_half),
    ("free-simplices-are-found", collapses, "free_pairs", drops_a_pair),
    ("collapse-applies-exactly", collapses, "collapse", collapses_all),
    ("expansion-applies-exactly", collapses, "expand", expands_all),
    ("collapse-removes-one-of-each", collapses, "collapse", takes_the_coface_alone),
    ("collapsibility-has-a-proof", collapses, "collapse_to_point", always_collapses),
    ("no-choice-matters-below-three", collapses, "collapse_to_point", depends_on_size),
    ("subdivision-is-a-cone-in-place-of-a-star", stellar, "subdivide", loses_the_link),
    ("weld-applies-exactly", stellar, "weld", welds_nothing),
    ("subdivision-is-undone-by-contraction", stellar, "contract", contracts_nothing),
    ("flip-is-a-subdivision-and-a-weld", stellar, "bistellar", flips_to_the_same),
    ("flip-is-the-edge-flip-of-scripts", stellar, "bistellar", flips_to_the_same),
    ("flips-change-numbers-by-the-table", stellar, "effect", doubles),
    ("contraction-is-undone-by-a-split", contracts, "inverse", forgets_what_is_shared),
    ("contraction-condition-is-exact", contracts, "contract", contracts_most),
    ("contraction-condition-is-exact", contracts, "contract", contracts_nothing),
    ("contraction-condition-is-exact-in-space", contracts, "contract", contracts_over_triangles),
    ("split-is-undone-by-a-contraction", contracts, "split", splits_too_much),
    ("split-condition-is-exact", contracts, "split", splits_too_much),
    ("split-condition-is-exact", contracts, "split", moves_all),
    ("simplifying-moves-apply", recognises, "simplifying", wanders),
    ("recognised-is-right", recognises, "recognise", sees_balls),
    ("recognised-has-a-proof", recognises, "recognition", shows_nothing),
    ("canonical-forms-are-those-of-isomorphic-complexes", recognises, "canonical", all_alike),
    ("canonical-forms-are-those-of-isomorphic-complexes", recognises, "canonical", its_facets),
    ("automorphisms-are-renamings", recognises, "automorphisms", one_more),
]


@pytest.mark.parametrize(("name", "module", "function", "fault"), FAULTS)
def test_law_fails(
    name: str, module: object, function: str, fault: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With the fault an example is found on which the law fails; without it holds there."""
    law = named(name)
    monkeypatch.setattr(module, function, fault)
    example = failing(law)
    monkeypatch.undo()
    assert not isinstance(law.check(example), Fails)


def test_every_law_is_shown_to_fail() -> None:
    assert {name for name, *_ in FAULTS} == {law.name for law in LAWS}


def test_a_contraction_without_the_cone_shrinks_to_few_simplices(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """An arc of one edge, or a triangle: nothing smaller has a boundary and an edge."""
    monkeypatch.setattr(laws_contract, "contract", contracts_most)
    found = failing(named("contraction-condition-is-exact"), SHRUNK)
    assert isinstance(found, Complex)
    assert len(found.simplices) <= 7


def test_a_collapse_of_what_is_not_free_shrinks_to_an_arc(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Two edges at a vertex: the least complex with an edge at a vertex that is not free."""
    monkeypatch.setattr(laws_collapse, "collapse", collapses_all)
    found = failing(named("collapse-applies-exactly"), SHRUNK)
    assert isinstance(found, Complex)
    assert len(found.simplices) <= 7


def test_a_wrong_bistellar_move_shrinks_to_few_simplices(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A path of two edges is the least complex with a bistellar move that changes it."""
    monkeypatch.setattr(laws_stellar, "bistellar", flips_to_the_same)
    found = failing(named("flip-is-a-subdivision-and-a-weld"), SHRUNK)
    assert isinstance(found, tuple)
    k, move = found
    assert isinstance(k, Complex)
    assert isinstance(move, Bistellar)
    assert len(k.simplices) <= 7
