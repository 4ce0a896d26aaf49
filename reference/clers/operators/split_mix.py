"""Numbers by a seed that every language makes alike: SplitMix64, and the shuffle drawn by it."""

from collections.abc import Iterator
from itertools import count
from typing import Final

_WORD: Final = (1 << 64) - 1
_STEP: Final = 0x9E3779B97F4A7C15


def split_mix(seed: int) -> Iterator[int]:
    """The words of 64 bits that a seed gives, without end. Clause: OPER-REFINE-5."""
    for k in count(1):
        z = (seed + k * _STEP) & _WORD
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9 & _WORD
        z = (z ^ z >> 27) * 0x94D049BB133111EB & _WORD
        yield z ^ z >> 31


def shuffled(size: int, words: Iterator[int]) -> list[int]:
    """0 … size−1 in an order by size − 1 words: Fisher–Yates. Clause: OPER-REFINE-5."""
    order = list(range(size))
    for i in range(size - 1, 0, -1):
        j = next(words) % (i + 1)
        order[i], order[j] = order[j], order[i]
    return order
