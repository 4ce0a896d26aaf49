"""Contexts that remember just enough of a word to know which symbols would end a given factor."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

from clers.edgebreaker.stream import SYMBOLS

NOWHERE: Final = -1
"""In the place of a successor: the symbol would end a factor that is ruled out."""


@dataclass(frozen=True, slots=True)
class FactorContexts:
    """The smallest automaton that rules out some factors. Clause: CODE-MINIMAX-1.

    `shortest[q]` is the first of the shortest words that lead from context 0 to context q;
    `successors[q][s]` is the context after symbol s, or NOWHERE.
    """

    shortest: tuple[str, ...]
    successors: tuple[tuple[int, ...], ...]


def factor_contexts(factors: Iterable[str]) -> FactorContexts:
    """The contexts for a set of factors of which none lies within another. CODE-MINIMAX-1.

    Aho and Corasick's automaton on their beginnings, with equivalent states made one (Moore).
    """
    ruled_out = frozenset(factors)
    begun = sorted({f[:i] for f in ruled_out for i in range(len(f))} | {""}, key=_by_length)
    after = {word: [_step(word, x, ruled_out, frozenset(begun)) for x in SYMBOLS] for word in begun}
    group = dict.fromkeys(begun, 0)
    while True:
        seen = {w: (group[w], *(None if v is None else group[v] for v in after[w])) for w in begun}
        numbers = {key: number for number, key in enumerate(dict.fromkeys(seen.values()))}
        finer = {word: numbers[seen[word]] for word in begun}
        if finer == group:
            break
        group = finer
    shortest = dict[int, str]()
    for word in begun:
        shortest.setdefault(group[word], word)
    rows = [[NOWHERE if v is None else group[v] for v in after[w]] for w in shortest.values()]
    return FactorContexts(tuple(shortest.values()), tuple(tuple(row) for row in rows))


def _by_length(word: str) -> tuple[int, str]:
    return len(word), word


def _step(word: str, symbol: str, ruled_out: frozenset[str], begun: frozenset[str]) -> str | None:
    """The longest end of the word with the symbol that begins a factor; None if it ends one."""
    ends = [(word + symbol)[i:] for i in range(len(word) + 2)]
    if not ruled_out.isdisjoint(ends):
        return None
    return next(end for end in ends if end in begun)
