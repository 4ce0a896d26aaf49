"""The laws of collapses: when they apply, and what the search for a point answers."""

from collections.abc import Iterator
from itertools import combinations
from typing import Final, assert_never

from clers.complexes.homology import Field, betti
from clers.complexes.simplicial import Complex, Simplex, dimension, star
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE, AtSimplex
from clers.operators.moves.apply import replay
from clers.operators.moves.augmented import in_order
from clers.operators.moves.candidates import new_vertex
from clers.operators.moves.collapse import collapse, expand, free_pairs
from clers.operators.moves.collapsible import (
    Collapsible,
    Exhausted,
    NotCollapsible,
    Stuck,
    Undecided,
    WrongHomology,
    collapse_to_point,
)
from clers.operators.moves.given import FEW
from clers.operators.moves.move import Collapse, Expand


def is_complex(simplices: frozenset[Simplex]) -> bool:
    """Is every face with one vertex less there? Then all faces are. Clause: CPLX-COMPLEX-1."""
    return all(s - {v} in simplices for s in simplices if len(s) > 1 for v in s)


def _pairs(of: Iterator[Simplex]) -> Iterator[tuple[Simplex, Simplex]]:
    return ((coface - {v}, coface) for coface in of for v in coface if len(coface) > 1)


def _collapses(k: Complex) -> Verdict:
    """For each simplex and face: by what is left, and by the tutorial's condition."""
    verdicts: list[Verdict] = []
    for free, coface in _pairs(iter(k.simplices)):
        applies = isinstance(collapse(k, Collapse(in_order(free), in_order(coface))), Accepted)
        where = AtSimplex(in_order(free))
        above = [s for s in star(k, free) if len(s) == len(free) + 1]
        verdicts.append(same(is_complex(k.simplices - {free, coface}), applies, where))
        verdicts.append(same(len(above) == 1, applies, where))
    return every(*verdicts)


def _free(k: Complex) -> Verdict:
    pairs = {
        (free, coface)
        for free, coface in _pairs(iter(k.simplices))
        if star(k, free) == {free, coface}
    }
    return same(pairs, set(free_pairs(k)))


def _expansions(k: Complex) -> Verdict:
    """For each set of at most four vertices, one of them perhaps new, and each of its faces."""
    names = {v for simplex in k.simplices for v in simplex} | {new_vertex(k)}
    sets = (frozenset(s) for size in (2, 3, 4) for s in combinations(sorted(names), size))
    verdicts: list[Verdict] = []
    for free, coface in _pairs(sets):
        applies = isinstance(expand(k, Expand(in_order(free), in_order(coface))), Accepted)
        new = free not in k.simplices and coface not in k.simplices
        expected = new and is_complex(k.simplices | {free, coface})
        verdicts.append(same(expected, applies, AtSimplex(in_order(coface))))
    return every(*verdicts)


def _edges(k: Complex) -> Verdict:
    """Collapses of vertices remove a vertex and an edge, of edges an edge and a triangle."""
    verdicts: list[Verdict] = []
    for free, coface in free_pairs(k):
        after = collapse(k, Collapse(in_order(free), in_order(coface)))
        if isinstance(after, Rejected):
            return Fails("a free simplex", after.line(), after.where)
        gone = sorted(len(simplex) for simplex in k.simplices - after.value.simplices)
        verdicts.append(same([len(free), len(free) + 1], gone))
    return every(*verdicts)


def _answer(k: Complex) -> Verdict:
    found = collapse_to_point(k, 50)
    match found:
        case Collapsible(moves):
            return _leaves(k, moves, 1)
        case NotCollapsible(why):
            return _refuted(k, why)
        case Undecided(budget):
            return every(same(50, budget), same(True, dimension(k) > 2))
        case _:
            assert_never(found)


def _refuted(k: Complex, why: WrongHomology | Stuck | Exhausted) -> Verdict:
    match why:
        case WrongHomology(numbers):
            point = (1,) + (0,) * dimension(k)
            return every(same(betti(k, Field.GF2), numbers), same(False, numbers == point))
        case Stuck(moves):
            proves = dimension(k) <= 2 or moves == ()
            return every(same(True, proves), _leaves(k, moves, 2))
        case Exhausted(complexes):
            return every(same(True, dimension(k) > 2), same(True, complexes > 1))
        case _:
            assert_never(why)


def _leaves(k: Complex, moves: tuple[Collapse, ...], at_least: int) -> Verdict:
    """The collapses apply and leave nothing free: one simplex, or more than one."""
    left = replay(moves, k)
    if isinstance(left, Rejected):
        return Fails("collapses that apply", left.line(), WHOLE)
    more = len(left.value.simplices) > 1
    return every(same(at_least > 1, more), same((), free_pairs(left.value)))


def _no_choice(k: Complex) -> Verdict:
    """Up to dimension 2: after any one collapse, the answer is the same."""
    if dimension(k) > 2:
        return Holds()
    answer = isinstance(collapse_to_point(k), Collapsible)
    return every(
        *(
            same(answer, isinstance(collapse_to_point(Complex(k.simplices - {*pair})), Collapsible))
            for pair in free_pairs(k)
        )
    )


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "free-simplices-are-found",
        Clause.OPER_COLLAPSE_1,
        "The free simplices are those whose star is they and one simplex with a vertex more.",
        FEW,
        _free,
    ),
    Law(
        "collapse-applies-exactly",
        Clause.OPER_COLLAPSE_2,
        "A collapse applies if what is left is a complex, if one coface has a vertex more; "
        "and not otherwise.",
        FEW,
        _collapses,
    ),
    Law(
        "expansion-applies-exactly",
        Clause.OPER_COLLAPSE_3,
        "An expansion applies if both simplices are new and the result is a complex, "
        "and not otherwise.",
        FEW,
        _expansions,
    ),
    Law(
        "collapse-removes-one-of-each",
        Clause.OPER_COLLAPSE_4,
        "A collapse removes a simplex and one with a vertex more, and nothing else.",
        FEW,
        _edges,
    ),
    Law(
        "collapsibility-has-a-proof",
        Clause.OPER_COLLAPSE_6,
        "Collapses to a point lead there; what is stuck is; the homology is as said.",
        FEW,
        _answer,
    ),
    Law(
        "no-choice-matters-below-three",
        Clause.OPER_COLLAPSE_7,
        "Up to dimension 2, no collapse changes whether there are collapses to a point.",
        FEW,
        _no_choice,
    ),
)
