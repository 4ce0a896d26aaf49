"""Bistellar moves towards the boundary of a simplex: a heuristic, whose result is a list of moves.

Nothing here need be trusted. What the moves lead to is seen by replaying them.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import combinations
from random import Random
from typing import Final

from clers.complexes.simplicial import Complex, Simplex, dimension, of_dimension
from clers.operators.moves.augmented import in_order
from clers.operators.moves.move import Bistellar

SHAKEN: Final = 4
"""From nothing to less than this many moves more follow one that does not remove facets."""

LEVEL: Final = 0.9
"""How often such a move keeps the number of facets, where it can. Found by trying."""


def simplifying(k: Complex, effort: int, seed: int = 0) -> tuple[Bistellar, ...]:
    """At most `effort` moves that apply one after the other, for a closed pure complex.

    A move that leaves fewer facets is preferred, best those that remove most; if there is none, one
    or a few are made at random that add facets or keep their number. It ends where none
    applies. The same for equal arguments. Clause: OPER-RECOGNISE-1.
    """
    n = dimension(k)
    draw = Random(seed).random
    now = _Facets(n)
    now.add(of_dimension(k, n))
    moves: list[Bistellar] = []
    shaken = 0
    while len(moves) < effort:
        by_size = now.candidates()
        down = [pairs for size, pairs in sorted(by_size.items()) if 2 * size < n + 2]
        level = [pair for size, pairs in by_size.items() if 2 * size == n + 2 for pair in pairs]
        up = [pair for size, pairs in by_size.items() if 2 * size > n + 2 for pair in pairs]
        if down and not shaken:
            chosen = down[0]
        elif level or up:
            shaken = shaken - 1 if shaken else int(SHAKEN * draw())
            chosen = level if level and (draw() < LEVEL or not up) else up
        elif down:
            shaken = 0
            continue
        else:
            break
        gone, come = chosen[int(len(chosen) * draw())]
        now.flip(gone, come)
        moves.append(Bistellar(in_order(gone), in_order(come)))
    return tuple(moves)


Pair = tuple[Simplex, Simplex]


@dataclass(slots=True)
class _Facets:
    """The n-simplices of a pure complex, with those that each of their faces lies in.

    The order of `of` is that of insertion, so that nothing depends on the order of sets.
    """

    n: int
    of: dict[Simplex, set[Simplex]] = field(default_factory=dict)

    def add(self, facets: Iterable[Simplex]) -> None:
        for facet in facets:
            for face in _faces(facet):
                self.of.setdefault(face, set()).add(facet)

    def remove(self, facets: Iterable[Simplex]) -> None:
        for facet in facets:
            for face in _faces(facet):
                self.of[face].discard(facet)
                if not self.of[face]:
                    del self.of[face]

    def candidates(self) -> dict[int, list[Pair]]:
        """All moves that apply, but those to a new vertex, by the number of vertices of A.

        A simplex of s vertices whose n+2−s facets have n+2−s vertices beside it has for its link
        the frontier of these: there are no more walls for so many facets.
        """
        found: dict[int, list[Pair]] = {}
        for a, facets in self.of.items():
            if len(facets) + len(a) == self.n + 2 > len(a) + 1:
                b = frozenset[int]().union(*facets) - a
                if len(b) == len(facets) and b not in self.of:
                    found.setdefault(len(a), []).append((a, b))
        return found

    def flip(self, a: Simplex, b: Simplex) -> None:
        self.remove([a | b - {v} for v in b])
        self.add([a - {v} | b for v in sorted(a)])


def _faces(facet: Simplex) -> Iterable[Simplex]:
    listed = sorted(facet)
    return (
        frozenset(face) for size in range(1, len(listed) + 1) for face in combinations(listed, size)
    )
