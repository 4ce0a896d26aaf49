"""Regular meshes of any size, in linear time: for benchmarks, limits and worst cases.

Each function is a plain one: the same arguments give the same faces in the same order.
"""

from collections.abc import Iterable, Iterator
from math import isqrt

from clers.complexes.face_list import FaceList
from clers.operators.net import Triangle
from clers.operators.tube import tube_around


def grid_sphere(rings: int) -> FaceList:
    """An octahedron whose faces are grids of `rings`² triangles: 8·rings² faces, rings ≥ 1.

    Six vertices have degree 4, the others 6. Faces and vertices go from pole to pole.
    """
    size = [1, *(4 * min(k, 2 * rings - k) for k in range(1, 2 * rings)), 1]
    first = [0]
    for count in size:
        first.append(first[-1] + count)
    faces: list[Triangle] = []
    for k in range(rings):  # the smaller ring k inside ring k + 1
        faces += _belt(first[k], k, first[k + 1], k + 1, turned=False)
    for k in range(2 * rings - 1, rings - 1, -1):
        m = 2 * rings - k - 1
        faces += _belt(first[k + 1], m, first[k], m + 1, turned=True)
    return FaceList(tuple(faces), first[-1])


def _belt(inner: int, m: int, outer: int, n: int, *, turned: bool) -> Iterator[Triangle]:
    """The faces between a ring of 4m vertices (one, if m = 0) and a ring of 4n, n = m + 1."""
    for q in range(4):
        for i in range(n):
            a = outer + q * n + i
            b = outer + (q * n + i + 1) % (4 * n)
            c = inner + (q * m + i) % (4 * m) if m else inner
            yield (b, a, c) if turned else (a, b, c)
            if i < m:
                d = inner + (q * m + i + 1) % (4 * m)
                yield (d, b, c) if turned else (d, c, b)


def sphere_of(faces: int) -> FaceList:
    """A sphere of at least `faces` faces: the smallest `grid_sphere` that has them."""
    rings = max(isqrt(max(faces, 1) // 8), 1)
    return grid_sphere(rings if 8 * rings * rings >= faces else rings + 1)


def grid_torus(rows: int, columns: int) -> FaceList:
    """A torus of 2·rows·columns faces, both ≥ 3; each vertex has degree 6."""
    faces: list[Triangle] = []
    for i in range(rows):
        here, there = i * columns, (i + 1) % rows * columns
        for j in range(columns):
            k = (j + 1) % columns
            a, b, c, d = here + j, here + k, there + k, there + j
            faces += [(a, b, c), (a, c, d)]
    return FaceList(tuple(faces), rows * columns)


def torus_chain(genus: int, rows: int, columns: int) -> FaceList:
    """A closed surface of that genus ≥ 1: grid tori joined by tubes; rows and columns ≥ 4.

    2·genus·rows·columns + 4·(genus − 1) faces.
    """
    one = grid_torus(rows, columns)
    tubes: list[Triangle] = []
    faces: list[Triangle] = []
    last = len(one.faces) // 2 + columns  # far from face 0, and without a vertex of it
    for k in range(genus):
        moved = [_moved(face, k * one.vertices) for face in one.faces]
        if k > 0:
            before = _moved(one.faces[last], (k - 1) * one.vertices)
            tubes += tube_around(before, moved[0], 0)
        gone = {0 if k > 0 else -1, last if k < genus - 1 else -1}
        faces += [face for t, face in enumerate(moved) if t not in gone]
    return FaceList((*faces, *tubes), genus * one.vertices)


def _moved(face: Triangle, by: int) -> Triangle:
    return face[0] + by, face[1] + by, face[2] + by


def with_holes(of: FaceList, holes: int) -> FaceList:
    """The mesh without its first faces that touch neither a curve nor each other, `holes` of them.

    Each is a boundary curve of three edges. `of` is closed; where it has no room for as many holes,
    it gets fewer.
    """
    taken = bytearray(of.vertices)
    kept: list[Triangle] = []
    left = holes
    for face in of.faces:
        a, b, c = face
        if left and not (taken[a] or taken[b] or taken[c]):
            taken[a] = taken[b] = taken[c] = 1
            left -= 1
        else:
            kept.append(face)
    return FaceList(tuple(kept), of.vertices)


def copies(of: FaceList, count: int) -> FaceList:
    """As many components as copies of a mesh, one after another."""
    return beside([of] * count)


def beside(parts: Iterable[FaceList]) -> FaceList:
    """Meshes beside each other, their vertices and faces in order."""
    faces: list[Triangle] = []
    vertices = 0
    for part in parts:
        faces += [_moved(face, vertices) for face in part.faces]
        vertices += part.vertices
    return FaceList(tuple(faces), vertices)


def strip(faces: int) -> FaceList:
    """A disk: a path of triangles, all vertices on the one boundary curve."""
    path = ((k, k + 1, k + 2) if k % 2 == 0 else (k + 1, k, k + 2) for k in range(faces))
    return FaceList(tuple(path), faces + 2)


def bipyramid(sides: int) -> FaceList:
    """Two vertices of degree `sides` ≥ 3 and a cycle between: 2·sides faces, for long fans."""
    top, bottom = sides, sides + 1
    around = [(k, (k + 1) % sides) for k in range(sides)]
    upper = tuple((a, b, top) for a, b in around)
    return FaceList((*upper, *((b, a, bottom) for a, b in around)), sides + 2)


def nested_splits(depth: int) -> FaceList:
    """A sphere of 4·depth + 4 faces that Edgebreaker reads as C^(2k+1) R S^k E^(k+1), k = depth.

    From the first face: all its S are open at once, so the stack is as deep as a quarter of the
    faces. A fan about b reaches v₁ … v_N (N = 2k + 1); a fan about r reaches every second of them.
    """
    a, b, r = 0, 1, 2
    last = 2 * depth + 1
    v = [a, *range(3, 3 + last)]
    fan = [(v[k + 1], v[k], b) for k in range(last)]
    splits = [(v[k - 2], v[k], r) for k in range(last, 2, -2)]
    ends = [(v[k - 2], v[k - 1], v[k]) for k in range(3, last + 1, 2)]
    return FaceList(((r, b, a), *fan, (r, v[last], b), *splits, (a, v[1], r), *ends), 3 + last)
