"""The smallest surfaces there are, to be tried before anything else. Clause: ORCL-SHRINK-7."""

from collections.abc import Iterator
from functools import cache
from typing import Final

from clers.generate.exhaustive import Faces, connected_surfaces
from clers.oracle.fuzz.behind import Net

EXHAUSTED: Final = 6
"""All connected surfaces of so many faces are tried."""

PAIRED: Final = 2
"""And all pairs of those of so many."""

TETRAHEDRON: Final[Faces] = ((0, 1, 2), (0, 3, 1), (1, 3, 2), (0, 2, 3))
TRIANGLE: Final[Faces] = ((0, 1, 2),)
TORUS: Final[Faces] = tuple(
    face
    for k in range(7)
    for face in ((k, (k + 1) % 7, (k + 3) % 7), (k, (k + 3) % 7, (k + 2) % 7))
)
"""On seven vertices, each next to each: the translates of two faces modulo 7."""


def _without(faces: Faces, vertex: int) -> Faces:
    """The faces without the star of a vertex; the last vertex takes its name."""
    last = max(v for face in faces for v in face)

    def name(v: int) -> int:
        return vertex if v == last else v

    kept = (face for face in faces if vertex not in face)
    return tuple((name(a), name(b), name(c)) for a, b, c in kept)


TORUS_WITH_A_CURVE: Final = _without(TORUS, 0)
"""On six vertices: the torus on seven without the star of one."""


def beside(first: Faces, second: Faces) -> Faces:
    """Two surfaces as one, the second's vertices after the first's."""
    n = 1 + max(v for face in first for v in face)
    return (*first, *((a + n, b + n, c + n) for a, b, c in second))


@cache
def smallest() -> tuple[Net, ...]:
    """By the number of faces, then of vertices. Clause: ORCL-SHRINK-7."""
    connected = sorted(connected_surfaces(EXHAUSTED), key=lambda faces: (len(faces), faces))
    few = [faces for faces in connected if len(faces) <= PAIRED]
    pairs = [beside(a, b) for i, a in enumerate(few) for b in few[i:]]
    others = (
        TORUS_WITH_A_CURVE,
        beside(TETRAHEDRON, TRIANGLE),
        beside(TRIANGLE, TETRAHEDRON),
        beside(TETRAHEDRON, TETRAHEDRON),
        TORUS,
    )
    nets = [
        Net(faces, 1 + max(v for face in faces for v in face))
        for faces in (*connected, *pairs, *others)
    ]
    return tuple(sorted(nets, key=lambda net: (len(net.faces), net.vertices)))


def small_ones(net: Net) -> Iterator[Net]:
    """Those that have fewer faces, each with the positions of a mesh that has some."""
    for other in smallest():
        if len(other.faces) < len(net.faces):
            if net.places is not None and len(net.places) >= other.vertices:
                places = net.places[: other.vertices]
                yield Net(other.faces, other.vertices, net.precision, places)
            yield other
