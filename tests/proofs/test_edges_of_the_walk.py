"""What the note on the decoders says of edges that no gate and no record glues, on all small ones.

Zip and Fast Zip find the younger half of such an edge by its older one, the *created* one.
"""

import pytest

from clers.complexes.surface import BORDER, Surface
from clers.conventions.result import Accepted
from clers.edgebreaker.decode import decode
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import ANNULUS, CUBE, TETRAHEDRON, TORUS
from clers.edgebreaker.outline import Outline, outline
from clers.generate.exhaustive import connected_surfaces, rooted_surfaces

CREATED = {"C": (2,)}
FREE = {"R": (1,), "L": (2,), "E": (1, 2)}


def both(surface: Surface) -> tuple[Outline, Surface]:
    """The outline of a surface's stream, and the surface in the order of creation."""
    stream = encode(surface).stream
    match outline(stream), decode(stream):
        case Accepted(outlined), Accepted(decoded):
            return outlined, decoded
        case refused:
            raise AssertionError(refused)


def check(surface: Surface) -> int:
    """Judge one surface; the answer is how many edges were found."""
    outlined, decoded = both(surface)
    vertex, opposite = decoded.vertex, decoded.opposite
    on_curves = {
        vertex[d] for c, o in enumerate(opposite) if o == BORDER
        for d in (c - c % 3 + (c + 1) % 3, c - c % 3 + (c + 2) % 3)
    }  # fmt: skip
    created: set[int] = set()
    free: set[int] = set()
    corners_of_p = {3 * part.face for part in outlined.parts if part.closed}
    for p in corners_of_p:
        created |= {p + 1, p + 2}
    for symbol, face in zip(outlined.stream.word, outlined.face, strict=True):
        created |= {3 * face + i for i in CREATED.get(symbol, ())}
        free |= {3 * face + i for i in FREE.get(symbol, ())}
    free -= set(outlined.glue)
    begins = [tail(decoded, c) for c in created]
    assert len(begins) == len(set(begins))
    assert not on_curves & set(begins)
    assert not {vertex[p + 1] for p in corners_of_p} & set(begins)
    begun = dict(zip(begins, created, strict=True))
    for c in free:
        if opposite[c] == BORDER:
            assert head(decoded, c) in on_curves
        else:
            assert opposite[c] == begun[head(decoded, c)]
    for c in created:
        end = head(decoded, c)
        assert end not in begun or end < tail(decoded, c) or c - c % 3 in corners_of_p
    return len(created)


def tail(of: Surface, corner: int) -> int:
    """Where the edge opposite to a corner begins, as its face runs it."""
    return of.vertex[corner - corner % 3 + (corner + 1) % 3]


def head(of: Surface, corner: int) -> int:
    """Where it ends."""
    return of.vertex[corner - corner % 3 + (corner + 2) % 3]


@pytest.mark.parametrize("surface", [TETRAHEDRON, CUBE, ANNULUS, TORUS])
def test_examples(surface: Surface) -> None:
    """Clauses: EB-WRAP-2, EB-FAST-1."""
    check(surface)


def test_all_small_surfaces() -> None:
    """Clauses: EB-WRAP-2, EB-FAST-1."""
    found = [check(rooted) for faces in connected_surfaces(7) for rooted in rooted_surfaces(faces)]
    assert len(found) > 1000
    assert sum(found) > 1000
