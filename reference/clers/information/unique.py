"""Unique decodability: the test of Sardinas and Patterson, with an ambiguity as its witness."""

from collections import deque
from collections.abc import Sequence
from itertools import permutations

Ambiguity = tuple[tuple[int, ...], tuple[int, ...]]
"""Two different messages with one code."""


def ambiguity(words: Sequence[str]) -> Ambiguity | None:
    """Two different messages with one code, of fewest words; None if there are none.

    The number of dangling rests is at most the number of digits. Clauses: INFO-UNIQUE-1,
    INFO-KRAFT-1.
    """
    for symbol, word in enumerate(words):
        if word == "":
            return (), (symbol,)
    # What is left of the longer side; the shorter side; the longer side.
    waiting: deque[tuple[str, tuple[int, ...], tuple[int, ...]]] = deque(
        (words[b].removeprefix(words[a]), (a,), (b,))
        for a, b in permutations(range(len(words)), 2)
        if words[b].startswith(words[a])
    )
    seen: set[str] = set()
    while waiting:
        rest, short, long = waiting.popleft()
        if rest == "":
            return short, long
        if rest in seen:
            continue
        seen.add(rest)
        for symbol, word in enumerate(words):
            if rest.startswith(word):
                waiting.append((rest.removeprefix(word), (*short, symbol), long))
            elif word.startswith(rest):
                waiting.append((word.removeprefix(rest), long, (*short, symbol)))
    return None
