"""Real meshes of the corpus: small ones whole, and pieces of larger ones."""

from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Final

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.conformance import payloads as form
from clers.conventions.result import Accepted
from clers.geometry.mesh import Mesh
from clers.geometry.positions import Positions, Precision
from clers.meshfile.mesh import judged
from clers.meshfile.reading import read
from clers.oracle.positives.placed import Placed

MESHES: Final = Path(__file__).resolve().parents[4] / "corpus" / "meshes"
"""The corpus of this checkout. Clause: TOOL-CORPUS-3."""

WHOLE: Final = (
    "ring.off", "tetrahedron-and-triangle.off", "cube.ply", "two-triangles.stl", "joint.off",
    "sphere.ply", "eight.off", "helmet.off", "anchor.off", "teapot.ply", "pinion.off",
)  # fmt: skip
"""Files whose meshes are asked about as they are."""

PIECES: Final = (
    ("bunny.obj", 40), ("bunny.obj", 150), ("elephant.off", 60), ("elk.off", 80), ("head.off", 50),
    ("bones.off", 70), ("mushroom.off", 100), ("cheese.ply", 120), ("coupling.off", 90),
    ("blobby.off", 60),
)  # fmt: skip
"""Files, and about how many faces of each."""


@cache
def loaded(name: str) -> Mesh:
    """A mesh of the corpus."""
    found = read(MESHES / name)
    mesh = judged(found.value) if isinstance(found, Accepted) else found
    if not isinstance(mesh, Accepted):
        raise AssertionError(f"{MESHES / name}: {mesh.line()}")
    return mesh.value


def places_of(mesh: Mesh) -> form.Places | None:
    """The positions as a message has them. Clause: ORCL-VALUE-3."""
    if mesh.positions is None:
        return None
    return form.Places(
        precision="f32" if mesh.positions.precision is Precision.F32 else "f64",
        coordinates=mesh.positions.coordinates,
    )


def piece(mesh: Mesh, start: int, faces: int) -> Mesh | None:
    """The faces about a vertex, ring by ring, until there are so many; None if they are pinched.

    Vertices and faces keep their order. `mesh` has positions.
    """
    triangles = tuple(mesh.surface.triangles())
    at: dict[int, list[int]] = {}
    for t, triangle in enumerate(triangles):
        for v in triangle:
            at.setdefault(v, []).append(t)
    inside, ring = set[int](), {start}
    before = -1
    while before < len(inside) < faces:
        before = len(inside)
        inside |= {t for v in ring for t in at[v]}
        ring = {int(v) for t in inside for v in triangles[t]}
    kept = [triangles[t] for t in sorted(inside)]
    old = sorted({v for triangle in kept for v in triangle})
    number = {v: k for k, v in enumerate(old)}
    renamed = tuple((number[a], number[b], number[c]) for a, b, c in kept)
    found = surface(FaceList(renamed, len(old)))
    given = mesh.positions
    if given is None or not isinstance(found, Accepted):
        return None
    numbers = tuple(x for v in old for x in given.coordinates[3 * v : 3 * v + 3])
    return Mesh(found.value, Positions(given.precision, numbers))


def whole() -> Iterator[Placed]:
    """Small meshes as they are. Clause: TOOL-CORPUS-3."""
    for name in WHOLE:
        mesh = loaded(name)
        slug = name.partition(".")[0]
        yield Placed(slug, mesh.surface, places_of(mesh), "real", (), f"corpus/meshes/{name}")


def pieces() -> Iterator[Placed]:
    """Pieces of larger meshes, each about the first vertex at which it is a surface."""
    for name, faces in PIECES:
        mesh = loaded(name)
        tried = (piece(mesh, start, faces) for start in range(7, mesh.surface.vertices, 50))
        cut = next(found for found in tried if found is not None)
        slug = f"{name.partition('.')[0]}-piece-{cut.surface.faces}"
        comment = f"a piece of corpus/meshes/{name}"
        yield Placed(slug, cut.surface, places_of(cut), "real", (), comment)
