"""What the note on isomorphism says of regions: undoing a symbol leaves the border of what follows.

The loops of the decoder are compared with the border of the triangles from a step on, which is
found by turning around vertices in the surface and knows nothing of words.
"""

import pytest

from clers.complexes.surface import BORDER, Surface
from clers.conventions.result import Accepted
from clers.edgebreaker.by_lists import undone
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import ANNULUS, CUBE, TETRAHEDRON, TORUS
from clers.edgebreaker.outline import outline
from clers.generate.exhaustive import connected_surfaces, rooted_surfaces

Loops = frozenset[tuple[int, ...]]


def turned(corner: int) -> int:
    return corner - corner % 3 + (corner + 1) % 3


def rotated(loop: list[int] | tuple[int, ...]) -> tuple[int, ...]:
    """A cyclic list begun at its least edge."""
    k = loop.index(min(loop))
    return (*loop[k:], *loop[:k])


def border(of: Surface, faces: range) -> Loops:
    """The loops of the border of some faces, each edge by the corner opposite to it."""
    left = {c for f in faces for c in (3 * f, 3 * f + 1, 3 * f + 2)}
    edges = {c for c in left if of.opposite[c] == BORDER or of.opposite[c] not in left}
    loops: set[tuple[int, ...]] = set()
    while edges:
        loop = [edges.pop()]
        while True:
            # The edge after that of c begins where it ends: turn around that vertex.
            after = turned(loop[-1])
            while of.opposite[after] in left:
                after = turned(of.opposite[after])
            if after == loop[0]:
                break
            edges.remove(after)
            loop.append(after)
        loops.add(rotated(loop))
    return frozenset(loops)


def check(surface: Surface) -> int:
    """Judge every step of one surface; the answer is how many loops were compared."""
    stream = encode(surface).stream
    match outline(stream), decode(stream):
        case Accepted(outlined), Accepted(decoded):
            pass
        case refused:
            raise AssertionError(refused)
    compared = 0
    for step in undone(outlined):
        if step.symbol < 0:
            continue
        part = next(p for p in outlined.parts if p.start <= step.symbol < p.stop)
        faces = range(outlined.face[step.symbol], part.first + part.stop - part.start)
        loops = frozenset(map(rotated, (*step.loops, *step.beside, *step.curves)))
        expected = border(decoded, faces)
        assert loops == expected, (stream, step)
        compared += len(expected)
    return compared


@pytest.mark.parametrize("surface", [TETRAHEDRON, CUBE, ANNULUS, TORUS])
def test_examples(surface: Surface) -> None:
    """Clauses: EB-REVERSI-1, EB-REVERSI-2."""
    assert check(surface) > 0


def test_all_small_surfaces() -> None:
    """Clauses: EB-REVERSI-1, EB-REVERSI-2."""
    found = [check(rooted) for faces in connected_surfaces(6) for rooted in rooted_surfaces(faces)]
    assert sum(found) > 1000
