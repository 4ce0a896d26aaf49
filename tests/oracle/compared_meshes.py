"""Small meshes to compare, and what is read off a comparison."""

from typing import Final

from clers.conformance import payloads as form
from clers.conformance.judging.comparing.difference import Difference
from clers.conformance.judging.meshes import (
    Compared,
    Differs,
)
from clers.generate.mesh_pairs import mesh

Face = tuple[int, int, int]
Place = tuple[float, float, float]

SOLID: Final[tuple[Face, ...]] = ((0, 1, 2), (3, 2, 1), (0, 3, 1), (2, 3, 0))
CORNERS: Final[tuple[Place, ...]] = (
    (0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0),
)  # fmt: skip


def bare(*faces: Face, vertices: int) -> form.MeshForm:
    return mesh(faces, None, vertices)


def placed(faces: tuple[Face, ...], *places: Place) -> form.MeshForm:
    return mesh(faces, places, len(places))


def only(found: Compared) -> Difference:
    assert isinstance(found, Differs)
    assert len(found.differences) == 1, found
    return found.differences[0]


def kinds(found: Compared) -> list[tuple[str, int]]:
    assert isinstance(found, Differs), found
    return [(d.kind, d.count) for d in found.differences]
