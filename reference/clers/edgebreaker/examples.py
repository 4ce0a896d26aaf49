"""Small surfaces to show things on: the tutorial's tetrahedron, cube and torus, and an annulus."""

from typing import Final

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted


def _known(*faces: tuple[int, int, int]) -> Surface:
    """A surface written down by hand; a slip of the pen stops the import."""
    built = surface(FaceList(faces, 1 + max(max(face) for face in faces)))
    assert isinstance(built, Accepted), built
    return built.value


TETRAHEDRON: Final = _known((0, 1, 2), (0, 3, 1), (1, 3, 2), (0, 2, 3))
"""Figure 20, word CRE."""

CUBE: Final = _known(
    (0, 1, 2), (1, 3, 2), (1, 4, 3), (1, 5, 4), (1, 0, 5), (0, 6, 5),
    (0, 2, 6), (2, 3, 6), (3, 7, 6), (3, 4, 7), (4, 5, 7), (5, 6, 7),
)  # fmt: skip
"""Figures 14 and 15, with the figure's vertex names; word CCCRCRRCRRE."""

TORUS: Final = _known(
    (0, 3, 4), (0, 4, 1), (1, 4, 5), (1, 5, 2), (2, 5, 3), (2, 3, 0),
    (3, 6, 7), (3, 7, 4), (4, 7, 8), (4, 8, 5), (5, 8, 6), (5, 6, 3),
    (6, 0, 1), (6, 1, 7), (7, 1, 2), (7, 2, 8), (8, 2, 0), (8, 0, 6),
)  # fmt: skip
"""Figure 22: a 3 × 3 grid of squares, opposite sides one; word CCCCRCSCRSSRLSEEE."""

ANNULUS: Final = _known((2, 5, 4), (1, 2, 0), (3, 0, 2), (2, 4, 3), (0, 5, 1), (0, 4, 5))
"""Two curves of three edges; word SLRRLE."""

TRIANGLE: Final = _known((0, 1, 2))
"""The smallest surface there is; word E."""
