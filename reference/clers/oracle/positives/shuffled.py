"""The same surface under other numbers of vertices and faces."""

from collections.abc import Callable
from random import Random

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted
from clers.operators.net import Triangle


def built(of: FaceList) -> Surface:
    """The surface of faces that are one; else the writer of the faces slipped."""
    found = surface(of)
    if not isinstance(found, Accepted):
        raise AssertionError(found.line())
    return found.value


def order(count: int, draw: Callable[[], float]) -> list[int]:
    """0 … count−1 in the order of as many random numbers."""
    keys = [draw() for _ in range(count)]
    return sorted(range(count), key=keys.__getitem__)


def turned(face: Triangle, draw: Callable[[], float]) -> Triangle:
    """A face begun at one of its three vertices."""
    a, b, c = face
    return ((a, b, c), (b, c, a), (c, a, b))[int(3 * draw())]


def in_disorder(of: FaceList, seed: int) -> FaceList:
    """Vertices and faces in another order, faces turned.

    Only `Random.random` is used: its sequence is the same in every Python.
    """
    draw = Random(seed).random
    number = order(of.vertices, draw)
    named = [(number[a], number[b], number[c]) for a, b, c in of.faces]
    faces = [turned(named[place], draw) for place in order(len(named), draw)]
    return FaceList(tuple(faces), of.vertices)


def shuffled(of: Surface, seed: int) -> Surface:
    """Vertices and all faces but face 0 in another order, these turned; the gate stays.

    Only `Random.random` is used: its sequence is the same in every Python.
    """
    draw = Random(seed).random
    number = order(of.vertices, draw)
    first, *rest = ((number[a], number[b], number[c]) for a, b, c in of.triangles())
    faces = [first, *(turned(rest[place], draw) for place in order(len(rest), draw))]
    return built(FaceList(tuple(faces), of.vertices))
