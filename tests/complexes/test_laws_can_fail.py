"""Laws about surfaces, on tables of corners that are none: each must say so."""

import pytest
from golden_complexes import BOW_TIE, TETRAHEDRON, accepted

from clers.complexes.face_list import FaceList
from clers.complexes.laws import LAWS
from clers.complexes.surface import BORDER, Corner, Surface, Vertex, corners_listed
from clers.conventions.verdict import Fails, Holds


def table(of: FaceList, opposite: tuple[int, ...] | None = None) -> Surface:
    """A corner table that nobody checked; all corners at the border if nothing else is said."""
    vertex = tuple(Vertex(v) for face in of.faces for v in face)
    known = (BORDER,) * len(vertex) if opposite is None else tuple(map(Corner, opposite))
    return corners_listed(vertex, known, of.vertices)


def changed(opposite: tuple[Corner, ...], **at: int) -> tuple[int, ...]:
    """Some opposites exchanged for others: `c3=7` is corner 3 and its new opposite 7."""
    return tuple(at.get(f"c{c}", d) for c, d in enumerate(opposite))


DISAGREEING = FaceList(((0, 1, 2), (0, 1, 3)), 4)
SOUND = accepted(TETRAHEDRON)

WRONG: tuple[tuple[str, Surface], ...] = (
    ("no-edge-is-run-twice", table(DISAGREEING, (-1, -1, 5, -1, -1, 2))),
    ("opposite-is-an-involution", table(DISAGREEING, (-1, -1, 5, -1, -1, 2))),
    ("opposite-is-an-involution", table(TETRAHEDRON, changed(SOUND.opposite, c0=4))),
    ("border-corners-have-no-opposite", table(TETRAHEDRON)),
    ("links-are-circles-and-arcs", table(BOW_TIE)),
    ("swings-reach-each-corner-of-a-vertex-once", table(BOW_TIE)),
    ("swings-reach-each-corner-of-a-vertex-once", table(TETRAHEDRON)),
    ("components-are-counted-as-defined", table(BOW_TIE)),
    ("euler-is-two-less-handles-and-curves", table(BOW_TIE)),
    ("homology-is-that-of-the-genus-gf2", table(TETRAHEDRON)),
    ("limits-are-kept", table(BOW_TIE)),
)


@pytest.mark.parametrize(("name", "wrong"), WRONG)
def test_law_fails(name: str, wrong: Surface) -> None:
    (law,) = [law for law in LAWS if law.name == name]
    assert isinstance(law.check(wrong), Fails)


@pytest.mark.parametrize("name", sorted({name for name, _ in WRONG}))
def test_law_holds_on_the_tetrahedron(name: str) -> None:
    (law,) = [law for law in LAWS if law.name == name]
    assert law.check(SOUND) == Holds()
