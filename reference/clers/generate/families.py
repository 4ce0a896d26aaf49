"""Regular meshes of any size, in linear time: for benchmarks, limits and worst cases.

Each function is a plain one: the same arguments give the same faces in the same order.
`flat_families` makes most of them, and has them as index lists, for millions of faces.
"""

from collections.abc import Iterable

from clers.complexes.face_list import FaceList
from clers.complexes.index_list import buffered, listed_faces
from clers.generate import flat_families as flat
from clers.operators.net import Triangle


def grid_sphere(rings: int) -> FaceList:
    """An octahedron whose faces are grids of `rings`² triangles: 8·rings² faces, rings ≥ 1.

    Six vertices have degree 4, the others 6. Vertices go from pole to pole, faces from each pole
    to the equator.
    """
    return listed_faces(flat.grid_sphere(rings))


def sphere_of(faces: int) -> FaceList:
    """A sphere of at least `faces` faces: the smallest `grid_sphere` that has them."""
    return listed_faces(flat.sphere_of(faces))


def grid_torus(rows: int, columns: int) -> FaceList:
    """A torus of 2·rows·columns faces, both ≥ 3; each vertex has degree 6."""
    return listed_faces(flat.grid_torus(rows, columns))


def torus_chain(genus: int, rows: int, columns: int) -> FaceList:
    """A closed surface of that genus ≥ 1: grid tori joined by tubes; rows and columns ≥ 4.

    2·genus·rows·columns + 4·(genus − 1) faces.
    """
    return listed_faces(flat.torus_chain(genus, rows, columns))


def with_holes(of: FaceList, holes: int) -> FaceList:
    """The mesh without its first faces that touch neither a curve nor each other, `holes` of them.

    Each is a boundary curve of three edges. `of` is closed; where it has no room for as many holes,
    it gets fewer.
    """
    return listed_faces(flat.with_holes(buffered(of), holes))


def copies(of: FaceList, count: int) -> FaceList:
    """As many components as copies of a mesh, one after another."""
    return listed_faces(flat.copies(buffered(of), count))


def beside(parts: Iterable[FaceList]) -> FaceList:
    """Meshes beside each other, their vertices and faces in order."""
    faces: list[Triangle] = []
    vertices = 0
    for part in parts:
        faces += [(a + vertices, b + vertices, c + vertices) for a, b, c in part.faces]
        vertices += part.vertices
    return FaceList(tuple(faces), vertices)


def strip(faces: int) -> FaceList:
    """A disk: a path of triangles, all vertices on the one boundary curve."""
    path = ((k, k + 1, k + 2) if k % 2 == 0 else (k + 1, k, k + 2) for k in range(faces))
    return FaceList(tuple(path), faces + 2)


def bipyramid(sides: int) -> FaceList:
    """Two vertices of degree `sides` ≥ 3 and a cycle between: 2·sides faces, for long fans."""
    return listed_faces(flat.bipyramid(sides))


def nested_splits(depth: int) -> FaceList:
    """A sphere of 4·depth + 4 faces that Edgebreaker reads as C^(2k+1) R S^k E^(k+1), k = depth.

    From the first face: all its S are open at once, so the stack is as deep as a quarter of the
    faces.
    """
    return listed_faces(flat.nested_splits(depth))


def shuffled(given: FaceList, seed: int) -> FaceList:
    """The same mesh with faces and vertices in random order: no cache helps any more."""
    return listed_faces(flat.shuffled(buffered(given), seed))
