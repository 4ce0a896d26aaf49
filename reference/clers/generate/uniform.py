"""Rooted triangulations of the sphere, each as likely as any other, in linear time.

A string of bits is shuffled and turned until it describes a tree with two leaves at each node. The
root is then put where two leaves stay open beside each other. Both times there are two ways, by the
cycle lemma, and one is drawn.
"""

from collections.abc import Callable, Mapping, Sequence
from itertools import accumulate
from random import Random
from typing import Final

from hypothesis import strategies as st

from clers.codes.closure import sphere_of
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted

FEWEST: Final = 4
"""Vertices of the tetrahedron, the least triangulation."""

_LEAF: Final = 0  # in a string about a tree; an edge is the number of its lower end, from 1 on


def uniform_sphere(vertices: int, seed: int) -> Surface:
    """A rooted triangulation with so many vertices (four at least), its root at corner 0. Linear.

    All are as likely; the same arguments give the same one, for only `Random.random` is used.
    Clauses: CODE-UNIFORM-1, CODE-UNIFORM-3.
    """
    draw = Random(seed).random
    nodes = max(vertices, FEWEST) - 2
    bits = shuffled(4 * nodes - 2, nodes - 1, draw)
    return chosen(bits, int(2 * draw()), int(2 * draw()))


def shuffled(length: int, ones: int, draw: Callable[[], float]) -> bytes:
    """So many bits with so many ones, drawn from an urn. Clause: CODE-UNIFORM-3."""
    bits = bytearray()
    for rest in range(length, 0, -1):
        bit = draw() * rest < ones
        ones -= bit
        bits.append(bit)
    return bytes(bits)


def chosen(bits: bytes, turn: int, gap: int) -> Surface:
    """The triangulation of 4n − 2 bits with n − 1 ones and two choices of 0 or 1. Linear.

    It has n + 2 vertices. Clauses: CODE-UNIFORM-1, CODE-UNIFORM-2.
    """
    start = starts([3 if bit else -1 for bit in bits])[turn]
    string = _string(bits[start:] + bits[:start])
    corner = openings([1 if side == _LEAF else -1 for side in string])[gap] + 1
    built = sphere_of(_word(string[corner:] + string[:corner]))
    if isinstance(built, Accepted):
        return built.value
    raise AssertionError(f"{bits.hex()}, {turn}, {gap}: {built.line()}")


def starts(steps: Sequence[int]) -> tuple[int, int]:
    """The turns of a walk down to −2 that come there with the last step only; steps down are 1.

    After the first time at the lowest level, and after the first time on the one above it.
    """
    levels = list(accumulate(steps, initial=0))
    lowest = min(levels)
    return levels.index(lowest) % len(steps), levels.index(lowest + 1)


def openings(steps: Sequence[int]) -> tuple[int, int]:
    """The turns of a walk up to 2 that stay above 0; steps are 1 up or 1 down.

    From the last time at the lowest level, and from the last time on the one above it.
    """
    levels = list(accumulate(steps, initial=0))
    lowest = min(levels)
    last = {level: place for place, level in enumerate(levels)}
    return last[lowest], last[lowest + 1]


def _string(bits: bytes) -> list[int]:
    """The string about the planted tree that these bits describe; its root has one leaf in front.

    At another node two zeros are leaves and the third goes back; at the root the second one ends.
    """
    string = [_LEAF]
    path, zeros = [0], [1]
    for bit in bits:
        node = path[-1]
        if bit:
            path.append(len(zeros))
            string.append(len(zeros))
            zeros.append(0)
        elif zeros[node] < 2:
            zeros[node] += 1
            string.append(_LEAF)
        elif node:
            string.append(path.pop())
    return string


def _word(string: Sequence[int]) -> bytes:
    """The tree word of a string that begins and ends with the two leaves of the root."""
    met: set[int] = {_LEAF}
    word = bytearray()
    for side in string[1:-1]:
        word.append(side not in met)
        met.add(side)
    return bytes(word)


def uniform_spheres(max_vertices: int = 40) -> st.SearchStrategy[Surface]:
    """Rooted triangulations, evenly among those of one number of vertices; shrinks to few vertices.

    How many vertices is drawn first. Clause: CODE-UNIFORM-1.
    """
    return st.builds(uniform_sphere, st.integers(FEWEST, max_vertices), st.integers(0, 1 << 32))


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "uniform-spheres": uniform_spheres(),
}
"""The domains of this module, by name."""
