"""Irregular closed meshes of any size, in linear time: random splits and flips of a regular one."""

from itertools import chain, repeat
from math import isqrt
from random import Random

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import BORDER
from clers.conventions.result import Accepted
from clers.generate.families import grid_sphere
from clers.operators.tube import tetrahedron


def irregular_sphere(faces: int, seed: int) -> FaceList:
    """A sphere of `faces` faces (even, ≥ 4), half of them by random splits, then flipped twice.

    The same arguments give the same mesh: only `Random.random` is used.
    """
    rings = max(isqrt(faces // 16), 1)
    start = FaceList(tetrahedron(0), 4) if faces < 8 else grid_sphere(rings)
    split = split_at_random(start, (faces - len(start.faces)) // 2, seed)
    return flip_at_random(split, 2, seed)


def split_at_random(of: FaceList, times: int, seed: int) -> FaceList:
    """Put a vertex into each of `times` faces, drawn evenly; in rounds, if there are too few."""
    draw = Random(seed).random
    faces, vertices = list(of.faces), of.vertices
    end = vertices + times
    while vertices < end:
        old, faces = faces, []
        wanted = min(end - vertices, len(old))
        for t, (a, b, c) in enumerate(old):
            if draw() * (len(old) - t) < wanted:  # each choice of `wanted` faces is as likely
                wanted -= 1
                faces += [(a, b, vertices), (b, c, vertices), (c, a, vertices)]
                vertices += 1
            else:
                faces.append((a, b, c))
    return FaceList(tuple(faces), vertices)


def flip_at_random(of: FaceList, rounds: int, seed: int) -> FaceList:
    """Go over all edges, `rounds` times, and try to flip about two of three.

    A mesh that is no closed surface stays as it is.

    Whether the other diagonal exists is asked at its end of lower degree, so that vertices of high
    degree cost nothing much.
    """
    built = surface(of)
    if not isinstance(built, Accepted) or BORDER in built.value.opposite:
        return of
    draw = Random(seed).random
    vertex: list[int] = list(built.value.vertex)
    opposite: list[int] = list(built.value.opposite)
    degree = [0] * of.vertices
    for v in vertex:
        degree[v] += 1
    for c in chain.from_iterable(repeat(range(len(vertex)), rounds)):
        if draw() < 0.42:  # an edge has two corners: 1 − 0.58² is about two thirds
            d = opposite[c]
            low, x = (c, vertex[d]) if degree[vertex[c]] <= degree[vertex[d]] else (d, vertex[c])
            if not _is_joined(vertex, opposite, low, x):
                _flip(vertex, opposite, degree, c)
    flat = iter(vertex)
    return FaceList(tuple(zip(flat, flat, flat, strict=True)), of.vertices)


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
