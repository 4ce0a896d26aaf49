"""What is quoted beside codes but is none: entropies of valences and of symbols, and the limit."""

from collections import Counter, defaultdict
from math import fsum, log2
from typing import Final

from clers.complexes.surface import BORDER, Corner, Surface, next_corner
from clers.information.measure import entropy

ORDERS: Final = range(6)
PER_TRIANGLE: Final = log2(256 / 27) / 2
"""What triangulated spheres need, for each triangle. Clause: TOOL-BITS-5."""


def degrees(surface: Surface) -> list[int]:
    """The number of edges at each vertex. Linear. Clause: TOOL-BITS-5."""
    degree = [0] * surface.vertices
    for corner, v in enumerate(surface.vertex):
        degree[v] += 1
        if surface.opposite[corner] == BORDER:
            # an edge without a second face: its start has one more edge than it has faces
            degree[surface.vertex[next_corner(Corner(corner))]] += 1
    return degree


def valence_entropy(surface: Surface) -> float:
    """V times the entropy of the degrees, in bits. Clause: TOOL-BITS-5."""
    return surface.vertices * entropy(list(Counter(degrees(surface)).values()))


def order_entropy(word: str, order: int) -> float:
    """The bits of a word's symbols, each given the `order` before it. Clause: TOOL-BITS-5."""
    seen: defaultdict[str, Counter[str]] = defaultdict(Counter)
    for i, symbol in enumerate(word):
        seen[word[max(0, i - order) : i]][symbol] += 1
    tables = [list(counts.values()) for counts in seen.values()]
    return fsum(sum(table) * entropy(table) for table in tables)


def limit(surface: Surface) -> float:
    """The bits that spheres of as many triangles need. Clause: TOOL-BITS-5."""
    return PER_TRIANGLE * surface.faces
