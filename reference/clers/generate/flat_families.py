"""Regular meshes of any size as index lists, in linear time and without an object for each number.

The same arguments give the same faces in the same order. `families` has them as face lists.
"""

from math import isqrt
from random import Random

import numpy as np
import numpy.typing as npt

from clers.complexes.index_list import IndexList
from clers.operators.tube import tube_around

Numbers = npt.NDArray[np.int64]
"""Vertices or faces in a row; or the three vertices of each face, a face in a row."""


def faces_of(given: IndexList) -> Numbers:
    """A copy of the faces, which may be changed."""
    return np.frombuffer(given.buffer, "<u4").reshape(-1, 3).astype(np.int64)


def list_of(faces: Numbers, vertices: int) -> IndexList:
    """The index list of faces, whose numbers are from 0 to 2^32 - 1. Clause: CPLX-INPUT-5."""
    return IndexList(faces.astype("<u4").tobytes(), vertices)


def _faces(*corners: Numbers | int) -> Numbers:
    """The faces whose first vertices are given, and their second ones, and their third ones."""
    return np.stack(np.broadcast_arrays(*corners), axis=-1).astype(np.int64)


def _in_turn(*parts: Numbers) -> Numbers:
    """The first face of each part, then the second of each, and so on."""
    return np.stack(parts, axis=-2).reshape(*parts[0].shape[:-2], -1, 3)


def grid_sphere(rings: int) -> IndexList:
    """An octahedron whose faces are grids of `rings`² triangles: 8·rings² faces, rings ≥ 1.

    Six vertices have degree 4, the others 6. Vertices go from pole to pole, faces from each pole
    to the equator.
    """
    size = [1, *(4 * min(k, 2 * rings - k) for k in range(1, 2 * rings)), 1]
    first = [0]
    for count in size:
        first.append(first[-1] + count)
    # The smaller ring k inside ring k + 1; then, from the other pole on, inside ring k - 1.
    belts = [_belt(first[k], k, first[k + 1], turned=False) for k in range(rings)]
    belts += [
        _belt(first[k], 2 * rings - k, first[k - 1], turned=True)
        for k in range(2 * rings, rings, -1)
    ]
    return list_of(np.concatenate(belts), first[-1])


def _belt(inner: int, m: int, outer: int, *, turned: bool) -> Numbers:
    """The faces between a ring of 4m vertices (one, if m = 0) and a ring of 4n, n = m + 1.

    In each quarter n faces that have an edge of the outer ring, and between them m others.
    """
    n, around = m + 1, max(4 * m, 1)
    quarter, i = np.arange(4)[:, None], np.arange(n)
    a, b = outer + quarter * n + i, outer + (quarter * n + i + 1) % (4 * n)
    c, d = inner + (quarter * m + i) % around, inner + (quarter * m + i + 1) % around
    up = _faces(b, a, c) if turned else _faces(a, b, c)
    down = _faces(d, b, c) if turned else _faces(d, c, b)
    return _in_turn(up, down)[:, : n + m].reshape(-1, 3)


def sphere_of(faces: int) -> IndexList:
    """A sphere of at least `faces` faces: the smallest `grid_sphere` that has them."""
    rings = max(isqrt(max(faces, 1) // 8), 1)
    return grid_sphere(rings if 8 * rings * rings >= faces else rings + 1)


def grid_torus(rows: int, columns: int) -> IndexList:
    """A torus of 2·rows·columns faces, both ≥ 3; each vertex has degree 6."""
    i, j = np.arange(rows)[:, None], np.arange(columns)
    here, there, k = i * columns, (i + 1) % rows * columns, (j + 1) % columns
    a, b, c, d = here + j, here + k, there + k, there + j
    return list_of(_in_turn(_faces(a, b, c), _faces(a, c, d)), rows * columns)


def torus_chain(genus: int, rows: int, columns: int) -> IndexList:
    """A closed surface of that genus ≥ 1: grid tori joined by tubes; rows and columns ≥ 4.

    2·genus·rows·columns + 4·(genus − 1) faces.
    """
    one = faces_of(grid_torus(rows, columns))
    vertices, last = rows * columns, len(one) // 2 + columns  # far from face 0, and no vertex of it
    tori = one + vertices * np.arange(genus)[:, None, None]
    kept = np.ones((genus, len(one)), np.bool_)
    kept[1:, 0] = kept[:-1, last] = False
    here, there = (tuple(map(int, face)) for face in (one[last], one[0] + vertices))
    tube = np.array(tube_around((here[0], here[1], here[2]), (there[0], there[1], there[2]), 0))
    tubes = tube + vertices * np.arange(genus - 1)[:, None, None]
    return list_of(np.concatenate([tori[kept], tubes.reshape(-1, 3)]), genus * vertices)


def with_holes(of: IndexList, holes: int) -> IndexList:
    """The mesh without its first faces that touch neither a curve nor each other, `holes` of them.

    Each is a boundary curve of three edges. `of` is closed; where it has no room for as many holes,
    it gets fewer.
    """
    taken = bytearray(of.vertices)
    faces = faces_of(of)
    gone: list[int] = []
    for t in range(len(faces)):
        if len(gone) == holes:
            break
        a, b, c = faces[t].tolist()
        if not (taken[a] or taken[b] or taken[c]):
            taken[a] = taken[b] = taken[c] = 1
            gone.append(t)
    return list_of(np.delete(faces, gone, axis=0), of.vertices)


def copies(of: IndexList, count: int) -> IndexList:
    """As many components as copies of a mesh, one after another."""
    moved = faces_of(of) + of.vertices * np.arange(count)[:, None, None]
    return list_of(moved.reshape(-1, 3), count * of.vertices)


def bipyramid(sides: int) -> IndexList:
    """Two vertices of degree `sides` ≥ 3 and a cycle between: 2·sides faces, for long fans."""
    a = np.arange(sides)
    b = (a + 1) % sides
    upper, lower = _faces(a, b, sides), _faces(b, a, sides + 1)
    return list_of(np.concatenate([upper, lower]), sides + 2)


def nested_splits(depth: int) -> IndexList:
    """A sphere of 4·depth + 4 faces that Edgebreaker reads as C^(2k+1) R S^k E^(k+1), k = depth.

    From the first face: all its S are open at once, so the stack is as deep as a quarter of the
    faces. A fan about b reaches v₁ … v_N (N = 2k + 1); a fan about r reaches every second of them.
    """
    a, b, r = 0, 1, 2
    last = 2 * depth + 1
    v = np.array([a, *range(3, 3 + last)])
    odd = v[1::2]
    faces = (
        [[r, b, a]],
        _faces(v[1:], v[:-1], b),
        [[r, v[last], b]],
        _faces(odd[:-1], odd[1:], r)[::-1],
        [[a, v[1], r]],
        _faces(odd[:-1], v[2::2], odd[1:]),
    )
    return list_of(np.concatenate(faces), 3 + last)


def shuffled(given: IndexList, seed: int) -> IndexList:
    """The same mesh with faces and vertices in random order: no cache helps any more."""
    random = Random(seed)
    name = list(range(given.vertices))
    random.shuffle(name)
    order = list(range(given.faces))
    random.shuffle(order)
    faces = np.array(name)[faces_of(given)]
    return list_of(faces[order], given.vertices)
