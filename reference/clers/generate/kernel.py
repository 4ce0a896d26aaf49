"""What is used of manifold3d, which brings no types: solids, and the meshes they turn into.

The library's booleans give oriented manifolds by index. Solids that touch keep vertices apart that
have one place, so vertices are never joined by place, only by the library's own merge vectors.
"""

from collections.abc import Iterable
from typing import Final, Protocol

import manifold3d

from clers.complexes.face_list import FaceList

Vector = tuple[float, float, float]


class _Rows(Protocol):
    def tolist(self) -> list[list[float]]: ...


class _Indices(Protocol):
    def tolist(self) -> list[list[int]]: ...


class _RawMesh(Protocol):
    @property
    def tri_verts(self) -> _Indices: ...
    @property
    def vert_properties(self) -> _Rows: ...
    @property
    def merge_from_vert(self) -> Iterable[int]: ...
    @property
    def merge_to_vert(self) -> Iterable[int]: ...


class Solid(Protocol):
    """A solid; its boundary is a closed oriented surface, or nothing."""

    def __add__(self, other: "Solid", /) -> "Solid":
        """Union."""
        ...

    def __sub__(self, other: "Solid", /) -> "Solid":
        """Difference."""
        ...

    def __xor__(self, other: "Solid", /) -> "Solid":
        """Intersection."""
        ...

    def scale(self, v: Vector, /) -> "Solid":
        """Scaled along the axes."""
        ...

    def rotate(self, v: Vector, /) -> "Solid":
        """Turned about the axes, in degrees."""
        ...

    def translate(self, t: Vector, /) -> "Solid":
        """Moved."""
        ...

    def refine(self, n: int, /) -> "Solid":
        """The same solid, each face cut into n² faces."""
        ...

    def num_tri(self) -> int:
        """The number of triangles of its boundary; 0 for the empty solid."""
        ...

    def to_mesh64(self) -> _RawMesh:
        """Its boundary, in the library's form."""
        ...


class _Maker(Protocol):
    def tetrahedron(self) -> Solid: ...
    def cube(self, size: Vector, center: bool) -> Solid: ...
    def cylinder(
        self, height: float, radius_low: float, radius_high: float, segments: int, center: bool, /
    ) -> Solid: ...
    def sphere(self, radius: float, circular_segments: int) -> Solid: ...


_MAKER: Final[_Maker] = manifold3d.Manifold


def tetrahedron() -> Solid:
    """A tetrahedron with corners at (±1, ±1, ±1)."""
    return _MAKER.tetrahedron()


def box(size: Vector) -> Solid:
    """A box about the origin."""
    return _MAKER.cube(size, True)


def cone(height: float, low: float, high: float, sides: int) -> Solid:
    """A cylinder or a cut cone about the z axis, with that many sides."""
    return _MAKER.cylinder(height, low, high, sides, True)


def ball(radius: float, segments: int) -> Solid:
    """A geodesic ball; `segments` counts the edges of its equator, a multiple of four."""
    return _MAKER.sphere(radius, segments)


def boundary(solid: Solid) -> tuple[FaceList, tuple[Vector, ...]]:
    """The faces of a solid, and the place of each vertex, in the library's order."""
    raw = solid.to_mesh64()
    rows = raw.vert_properties.tolist()
    stands_for = list(range(len(rows)))
    for gone, kept in zip(raw.merge_from_vert, raw.merge_to_vert, strict=True):
        stands_for[int(gone)] = int(kept)
    return compact(
        [(stands_for[a], stands_for[b], stands_for[c]) for a, b, c in raw.tri_verts.tolist()],
        [(x, y, z) for x, y, z, *_ in rows],
    )


def compact(
    faces: Iterable[tuple[int, int, int]], places: list[Vector]
) -> tuple[FaceList, tuple[Vector, ...]]:
    """The faces with only the vertices they use, renumbered in order."""
    used = list(faces)
    kept = sorted({v for face in used for v in face})
    number = {v: k for k, v in enumerate(kept)}
    renumbered = tuple((number[a], number[b], number[c]) for a, b, c in used)
    return FaceList(renumbered, len(kept)), tuple(places[v] for v in kept)
