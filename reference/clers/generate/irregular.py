"""Irregular closed meshes of any size, in linear time: random splits and flips of a regular one."""

from math import isqrt
from random import Random
from typing import Final

import numpy as np

from clers.complexes.corner_table import surface_of_indices
from clers.complexes.face_list import FaceList, Limits
from clers.complexes.index_list import IndexList, buffered, listed_faces
from clers.complexes.surface import BORDER
from clers.conventions.result import Accepted
from clers.generate.flat_families import faces_of, grid_sphere, list_of
from clers.operators.tube import tetrahedron

TRIED: Final = 0.42
"""So many corners are tried. An edge has two: 1 − 0.58² is about two thirds of the edges."""


def irregular_sphere(faces: int, seed: int) -> FaceList:
    """A sphere of `faces` faces (even, ≥ 4), half of them by random splits, then flipped twice.

    The same arguments give the same mesh: only `Random.random` is used.
    """
    return listed_faces(flat_irregular_sphere(faces, seed))


def split_at_random(of: FaceList, times: int, seed: int) -> FaceList:
    """Put a vertex into each of `times` faces, drawn evenly; in rounds, if there are too few."""
    return listed_faces(_split(buffered(of), times, seed))


def flip_at_random(of: FaceList, rounds: int, seed: int) -> FaceList:
    """Go over all edges, `rounds` times, and try to flip about two of three.

    A mesh that is no closed surface stays as it is.

    Whether the other diagonal exists is asked at its end of lower degree, so that vertices of high
    degree cost nothing much.
    """
    return listed_faces(_flipped(buffered(of), rounds, seed))


def flat_irregular_sphere(faces: int, seed: int) -> IndexList:
    """The same sphere as `irregular_sphere`, as an index list."""
    rings = max(isqrt(faces // 16), 1)
    start = buffered(FaceList(tetrahedron(0), 4)) if faces < 8 else grid_sphere(rings)
    split = _split(start, (faces - start.faces) // 2, seed)
    return _flipped(split, 2, seed)


def _split(of: IndexList, times: int, seed: int) -> IndexList:
    """The vertex n, put into a face a, b, c, makes a, b, n; b, c, n; c, a, n of it."""
    draw = Random(seed).random
    faces, vertices = faces_of(of), of.vertices
    while times > 0:
        wanted = min(times, len(faces))
        times -= wanted
        chosen: list[int] = []
        for t in range(len(faces)):
            if draw() * (len(faces) - t) < wanted:  # each choice of `wanted` faces is as likely
                wanted -= 1
                chosen.append(t)
        parts = np.ones(len(faces), np.int64)
        parts[chosen] = 3
        first = (np.cumsum(parts) - parts)[chosen]
        faces = np.repeat(faces, parts, axis=0)
        faces[first + 1] = np.roll(faces[first], -1, axis=1)
        faces[first + 2] = np.roll(faces[first], -2, axis=1)
        new = vertices + np.arange(len(chosen))
        for part in range(3):
            faces[first + part, 2] = new
        vertices += len(chosen)
    return list_of(faces, vertices)


def _flipped(of: IndexList, rounds: int, seed: int) -> IndexList:
    built = surface_of_indices(of, Limits(of.faces, of.vertices))
    if not isinstance(built, Accepted) or BORDER in built.value.opposite_row.flat:
        return of
    draw = Random(seed).random
    corners = range(3 * of.faces)
    vertex: list[int] = np.asarray(built.value.vertex_row.flat).tolist()
    opposite: list[int] = np.asarray(built.value.opposite_row.flat).tolist()
    degree: list[int] = np.bincount(vertex, minlength=of.vertices).tolist()
    for _ in range(rounds):
        for c in [c for c in corners if draw() < TRIED]:
            d = opposite[c]
            w, x = vertex[c], vertex[d]
            if degree[w] <= degree[x]:
                joined = _is_joined(vertex, opposite, c, x)
            else:
                joined = _is_joined(vertex, opposite, d, w)
            if not joined:
                _flip(vertex, opposite, degree, c)
    return list_of(np.array(vertex).reshape(-1, 3), of.vertices)


def _flip(vertex: list[int], opposite: list[int], degree: list[int], c: int) -> None:
    """Flip the edge opposite to corner c, in place."""
    d = opposite[c]
    n, p = (c - 2 if c % 3 == 2 else c + 1), (c + 2 if c % 3 == 0 else c - 1)
    nd, pd = (d - 2 if d % 3 == 2 else d + 1), (d + 2 if d % 3 == 0 else d - 1)
    w, u, v, x = vertex[c], vertex[n], vertex[p], vertex[d]
    # (w, u, v), (x, v, u) become (w, u, x), (x, v, w); u→x is now in the first, v→w in the second.
    vertex[p], vertex[pd] = x, w
    beyond_ux, beyond_vw = opposite[nd], opposite[n]
    opposite[c], opposite[beyond_ux] = beyond_ux, c
    opposite[d], opposite[beyond_vw] = beyond_vw, d
    opposite[n], opposite[nd] = nd, n
    degree[u] -= 1
    degree[v] -= 1
    degree[w] += 1
    degree[x] += 1


def _is_joined(vertex: list[int], opposite: list[int], corner: int, other: int) -> bool:
    """Is `other` a neighbour of the corner's vertex, which is inside?"""
    c = corner
    while True:
        n = c - 2 if c % 3 == 2 else c + 1
        if vertex[n] == other:
            return True
        d = opposite[n]
        c = d - 2 if d % 3 == 2 else d + 1
        if c == corner:
            return False
