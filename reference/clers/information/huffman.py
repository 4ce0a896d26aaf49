"""Huffman's code: no code of symbols is shorter in the mean."""

from collections.abc import Sequence
from heapq import heapify, heappop, heappush

from clers.conventions.result import Accepted, Rejected, and_then
from clers.information.canonical import canonical
from clers.information.prefix import Lengths, PrefixCode
from clers.information.static import bad_frequencies


def huffman(frequencies: Sequence[int]) -> Accepted[PrefixCode] | Rejected:
    """The canonical code of Huffman's lengths. Clauses: INFO-HUFFMAN-2 … INFO-HUFFMAN-5."""
    return and_then(huffman_lengths(frequencies), canonical)


def huffman_lengths(frequencies: Sequence[int]) -> Accepted[Lengths] | Rejected:
    """The depth of each symbol's leaf; k log k for k symbols. Clause: INFO-HUFFMAN-1."""
    fault = bad_frequencies(frequencies)
    if fault is not None:
        return fault
    heap = [(f, symbol) for symbol, f in enumerate(frequencies) if f > 0]
    heapify(heap)
    # Trees by number; a joined tree is made after both of its parts.
    parent: dict[int, int] = {}
    number = len(frequencies)
    while len(heap) > 1:
        first, one = heappop(heap)
        second, other = heappop(heap)
        parent[one] = parent[other] = number
        heappush(heap, (first + second, number))
        number += 1
    depth = {heap[0][1]: 0}
    for tree in sorted(parent, reverse=True):
        depth[tree] = depth[parent[tree]] + 1
    return Accepted(tuple(depth.get(symbol) for symbol in range(len(frequencies))))


def by_merging(frequencies: Sequence[int]) -> Lengths:
    """The same lengths, by counting how often a symbol's tree is joined: the definition.

    Frequencies must be good. Clause: INFO-HUFFMAN-1.
    """
    # Weight, number, and the symbols at the leaves.
    trees: list[tuple[int, int, tuple[int, ...]]] = [
        (f, symbol, (symbol,)) for symbol, f in enumerate(frequencies) if f > 0
    ]
    joined: list[int] = []
    number = len(frequencies)
    while len(trees) > 1:
        trees.sort()
        (first, _, one), (second, _, other), *trees = trees
        trees.append((first + second, number, one + other))
        joined += one + other
        number += 1
    return tuple(joined.count(s) if f > 0 else None for s, f in enumerate(frequencies))
