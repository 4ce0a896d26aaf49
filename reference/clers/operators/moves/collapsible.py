"""Does a complex collapse to a point? With the collapses as proof, or the proof that none do.

Collapses can be put in the order of falling dimension, so the search takes the highest simplices
away first. From dimension 2 downward no choice matters.
"""

from dataclasses import dataclass
from typing import Final

from clers.complexes.homology import Field, betti
from clers.complexes.simplicial import Complex, Simplex, dimension
from clers.operators.moves.augmented import in_order
from clers.operators.moves.collapse import free_pairs
from clers.operators.moves.move import Collapse

BUDGET: Final = 10000
"""How many collapses are tried before the answer is `Undecided`, if nothing else is said."""


@dataclass(frozen=True, slots=True)
class Collapsible:
    """These collapses lead to a point. Clause: OPER-COLLAPSE-6."""

    moves: tuple[Collapse, ...]


@dataclass(frozen=True, slots=True)
class WrongHomology:
    """These Betti numbers over GF(2) are not those of a point. Clause: OPER-COLLAPSE-7."""

    betti: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Stuck:
    """These collapses lead to no point and cannot be continued. Clause: OPER-COLLAPSE-7.

    A proof where the complex has dimension 2 at most, or where there are no moves.
    """

    moves: tuple[Collapse, ...]


@dataclass(frozen=True, slots=True)
class Exhausted:
    """All orders of collapses were tried, through so many complexes. Clause: OPER-COLLAPSE-7."""

    complexes: int


@dataclass(frozen=True, slots=True)
class NotCollapsible:
    """It does not collapse to a point, and why. Clause: OPER-COLLAPSE-7."""

    why: WrongHomology | Stuck | Exhausted


@dataclass(frozen=True, slots=True)
class Undecided:
    """The budget was spent. Clause: OPER-COLLAPSE-5."""

    budget: int


Collapsibility = Collapsible | NotCollapsible | Undecided


def collapse_to_point(k: Complex, budget: int = BUDGET) -> Collapsibility:
    """Collapsible, not collapsible, or undecided. Clause: OPER-COLLAPSE-5."""
    found = betti(k, Field.GF2)
    if found[:1] != (1,) or any(found[1:]):
        return NotCollapsible(WrongHomology(found))
    if dimension(k) <= 2 or not free_pairs(k):
        moves, left = greedy(k)
        return NotCollapsible(Stuck(moves)) if len(left.simplices) > 1 else Collapsible(moves)
    return _search(k, budget)


def greedy(k: Complex) -> tuple[tuple[Collapse, ...], Complex]:
    """Collapse whatever comes first, until nothing is free; and what is left.

    Clause: OPER-COLLAPSE-7.
    """
    moves: list[Collapse] = []
    while pairs := free_pairs(k):
        moves.append(_move(pairs[0]))
        k = _without(k, pairs[0])
    return tuple(moves), k


def _search(k: Complex, budget: int) -> Collapsibility:
    """Depth first, each complex once. On the stack: a complex, its next pairs, how it was made."""
    seen = {k}
    spent = 0
    path: list[Collapse] = []
    stack = [iter(_highest(k))]
    now = [k]
    while stack:
        pair = next(stack[-1], None)
        if pair is None:
            stack.pop()
            now.pop()
            del path[-1:]
            continue
        if spent == budget:
            return Undecided(budget)
        spent += 1
        after = _without(now[-1], pair)
        if after in seen:
            continue
        seen.add(after)
        if dimension(after) <= 2:
            rest, left = greedy(after)
            if len(left.simplices) == 1:
                return Collapsible((*path, _move(pair), *rest))
            continue
        path.append(_move(pair))
        stack.append(iter(_highest(after)))
        now.append(after)
    return NotCollapsible(Exhausted(len(seen)))


def _highest(k: Complex) -> list[tuple[Simplex, Simplex]]:
    """The free pairs whose coface has the dimension of the complex."""
    n = dimension(k)
    return [pair for pair in free_pairs(k) if len(pair[1]) == n + 1]


def _without(k: Complex, pair: tuple[Simplex, Simplex]) -> Complex:
    return Complex(k.simplices - set(pair))


def _move(pair: tuple[Simplex, Simplex]) -> Collapse:
    return Collapse(in_order(pair[0]), in_order(pair[1]))
