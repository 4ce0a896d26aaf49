"""The same surface under other numbers of vertices and faces, begun at the same face."""

from random import Random

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted
from clers.operators.subdivide import shuffled as order


def built(of: FaceList) -> Surface:
    """The surface of faces that are one; else the writer of the faces slipped."""
    found = surface(of)
    if not isinstance(found, Accepted):
        raise AssertionError(found.line())
    return found.value


def shuffled(of: Surface, seed: int) -> Surface:
    """Vertices and all faces but face 0 in another order, these turned; the gate stays.

    Only `Random.random` is used: its sequence is the same in every Python.
    """
    draw = Random(seed).random
    number = order(of.vertices, draw)
    first, *rest = ((number[a], number[b], number[c]) for a, b, c in of.triangles())
    faces = [first]
    for place in order(len(rest), draw):
        a, b, c = rest[place]
        faces.append(((a, b, c), (b, c, a), (c, a, b))[int(3 * draw())])
    return built(FaceList(tuple(faces), of.vertices))
