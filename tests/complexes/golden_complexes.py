"""Small meshes known from books, drawn by hand; none comes from the code under test."""

from itertools import product

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted

Triangles = tuple[tuple[int, int, int], ...]


def accepted(given: FaceList) -> Surface:
    """The surface of a face list that is one."""
    answer = surface(given)
    assert isinstance(answer, Accepted), answer
    return answer.value


def grid(columns: int, rows: int, *, flip: bool = False) -> FaceList:
    """A torus: a grid of squares, each cut in two, the right side glued to the left, top to bottom.

    With `flip` the right side is glued upside down, which makes a Klein bottle.
    """

    def name(i: int, j: int) -> int:
        turned = -j if flip and i == columns else j
        return (i % columns) * rows + turned % rows

    faces: list[tuple[int, int, int]] = []
    for i, j in product(range(columns), range(rows)):
        a, b = name(i, j), name(i + 1, j)
        c, d = name(i + 1, j + 1), name(i, j + 1)
        faces += [(a, b, c), (a, c, d)]
    return FaceList(tuple(faces), columns * rows)


def beside(*parts: FaceList) -> FaceList:
    """Face lists side by side, the vertices numbered on."""
    faces: list[tuple[int, int, int]] = []
    n = 0
    for part in parts:
        faces += [(a + n, b + n, c + n) for a, b, c in part.faces]
        n += part.vertices
    return FaceList(tuple(faces), n)


def joined(first: FaceList, second: FaceList) -> FaceList:
    """The connected sum: the last face of one glued on the first of the other, both taken away."""
    a, b, c = first.faces[-1]
    x, y, z = second.faces[0]
    place = {x: a, y: c, z: b}
    others = [v for v in range(second.vertices) if v not in place]
    place |= {v: first.vertices + i for i, v in enumerate(others)}
    moved = tuple((place[u], place[v], place[w]) for u, v, w in second.faces[1:])
    return FaceList(first.faces[:-1] + moved, first.vertices + len(others))


TRIANGLE = FaceList(((0, 1, 2),), 3)
SQUARE = FaceList(((0, 1, 2), (0, 2, 3)), 4)
TETRAHEDRON = FaceList(((0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)), 4)
OCTAHEDRON = FaceList(
    (
        *((0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 1)),
        *((5, 2, 1), (5, 3, 2), (5, 4, 3), (5, 1, 4)),
    ),
    6,
)
BAND = FaceList(((0, 1, 3), (1, 4, 3), (1, 2, 4), (2, 5, 4), (2, 0, 5), (0, 3, 5)), 6)
ANNULUS = FaceList(((3, 6, 5), (1, 3, 0), (4, 0, 3), (3, 5, 4), (0, 6, 1), (0, 5, 6)), 7)
"""The annulus of the errata, vertex 2 isolated; but for names it is the band."""

TORUS_7 = FaceList(
    tuple(
        face
        for i in range(7)
        for face in ((i, (i + 1) % 7, (i + 3) % 7), (i, (i + 3) % 7, (i + 2) % 7))
    ),
    7,
)
"""Möbius' and Császár's torus: each two of its seven vertices are joined by an edge."""

TORUS_9 = grid(3, 3)
DOUBLE_TORUS = joined(TORUS_7, TORUS_9)
MOEBIUS_5 = FaceList(((0, 1, 2), (1, 2, 3), (2, 3, 4), (3, 4, 0), (4, 0, 1)), 5)
PROJECTIVE_PLANE_6 = FaceList(
    (
        *((0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5), (0, 5, 1)),
        *((1, 2, 4), (2, 3, 5), (3, 4, 1), (4, 5, 2), (5, 1, 3)),
    ),
    6,
)
KLEIN_BOTTLE = grid(3, 4, flip=True)

PILLOW = FaceList(((0, 1, 2), (0, 2, 1)), 3)
BOOK = FaceList(((0, 1, 2), (1, 0, 3), (0, 1, 4)), 5)
BOW_TIE = FaceList(((0, 1, 2), (0, 3, 4)), 5)
TWO_AT_A_VERTEX = FaceList((*TETRAHEDRON.faces, (0, 4, 5), (0, 6, 4), (4, 6, 5), (5, 6, 0)), 7)
TWO_AT_AN_EDGE = FaceList((*TETRAHEDRON.faces, (0, 1, 4), (0, 5, 1), (1, 5, 4), (4, 5, 0)), 6)
