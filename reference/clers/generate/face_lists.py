"""Face lists, valid and slightly broken: one small fault or two in a surface, or a few loose faces.

Each breakage is a total function of a face list and two integers. What it breaks depends on the
mesh, and some leave it valid; so the answer is not known beforehand, but by chapter 3's definition.
"""

from collections.abc import Callable, Mapping
from typing import Final

from hypothesis import strategies as st

from clers.complexes.face_list import FaceList
from clers.generate.bounds import Bounds
from clers.generate.scripts import CHOICES, grown
from clers.operators.net import Triangle
from clers.operators.tube import tetrahedron

Breakage = Callable[[FaceList, int, int], FaceList]


def _with_corner(mesh: FaceList, i: int, vertex: int) -> FaceList:
    """Corner i names another vertex."""
    if not mesh.faces:
        return mesh
    flat = [v for face in mesh.faces for v in face]
    flat[i % len(flat)] = vertex
    return _grouped(flat, mesh.vertices)


def _grouped(flat: list[int], vertices: int) -> FaceList:
    return FaceList(tuple(zip(flat[0::3], flat[1::3], flat[2::3], strict=True)), vertices)


def _with_face(mesh: FaceList, j: int, face: Triangle) -> FaceList:
    """One more face, put in at any place."""
    at = j % (len(mesh.faces) + 1)
    return FaceList((*mesh.faces[:at], face, *mesh.faces[at:]), mesh.vertices)


def _face(mesh: FaceList, i: int) -> Triangle:
    return mesh.faces[i % len(mesh.faces)] if mesh.faces else (0, 1, 2)


def _flipped(mesh: FaceList, i: int) -> FaceList:
    if not mesh.faces:
        return mesh
    t = i % len(mesh.faces)
    a, b, c = mesh.faces[t]
    return FaceList((*mesh.faces[:t], (a, c, b), *mesh.faces[t + 1 :]), mesh.vertices)


def _third(mesh: FaceList, i: int, j: int) -> FaceList:
    """A face on an edge that has two faces or one, to a new vertex."""
    a, b, _ = _face(mesh, i)
    more = FaceList(mesh.faces, mesh.vertices + 1)
    return _with_face(more, j, (a, b, mesh.vertices) if i % 2 else (b, a, mesh.vertices))


def _identified(mesh: FaceList, i: int, j: int) -> FaceList:
    """Two vertices become one; the numbers above close the gap."""
    if mesh.vertices < 2:
        return mesh
    keep, gone = sorted((i % mesh.vertices, j % mesh.vertices))
    if keep == gone:
        return mesh
    flat = [keep if v == gone else v - (v > gone) for face in mesh.faces for v in face]
    return _grouped(flat, mesh.vertices - 1)


def _touching(mesh: FaceList, i: int, j: int) -> FaceList:
    """A tetrahedron that shares a vertex with the mesh: always a pinch."""
    beside = (*mesh.faces, *tetrahedron(mesh.vertices))
    vertex = _face(mesh, i)[i % 3]
    return _identified(FaceList(beside, mesh.vertices + 4), vertex, mesh.vertices + j % 4)


def _moebius(mesh: FaceList) -> FaceList:
    """A Möbius strip of five faces beside the mesh."""
    n = mesh.vertices
    strip = tuple((n + k, n + (k + 1) % 5, n + (k + 2) % 5) for k in range(5))
    return FaceList((*mesh.faces, *strip), n + 5)


BREAKAGES: Final[Mapping[str, Breakage]] = {
    "none": lambda mesh, _, __: mesh,
    "face-removed": lambda mesh, i, _: FaceList(
        tuple(face for t, face in enumerate(mesh.faces) if t != i % len(mesh.faces)), mesh.vertices
    ),
    "index-too-high": lambda mesh, i, j: _with_corner(mesh, i, mesh.vertices + j),
    "index-negative": lambda mesh, i, j: _with_corner(mesh, i, -1 - j),
    "index-changed": lambda mesh, i, j: _with_corner(mesh, i, j % max(mesh.vertices, 1)),
    "count-too-low": lambda mesh, _, __: FaceList(mesh.faces, max(mesh.vertices - 1, 0)),
    "face-twice": lambda mesh, i, j: _with_face(mesh, j, _face(mesh, i)),
    "face-twice-flipped": lambda mesh, i, j: _with_face(mesh, j, _face(_flipped(mesh, i), i)),
    "face-flipped": lambda mesh, i, _: _flipped(mesh, i),
    "edge-with-a-face-more": _third,
    "vertices-identified": _identified,
    "pinched": _touching,
    "vertex-isolated": lambda mesh, i, _: FaceList(mesh.faces, mesh.vertices + 1 + i % 2),
    "strip-one-sided": lambda mesh, _, __: _moebius(mesh),
    "empty": lambda mesh, i, _: FaceList((), mesh.vertices * (i % 2)),
}
"""What can be done to a face list, by name; all but the first usually make it no surface."""


def face_lists(max_faces: int = 40) -> st.SearchStrategy[FaceList]:
    """Surfaces with up to two breakages, one time in eight loose faces on few vertices."""
    names = list(BREAKAGES)
    one = st.tuples(st.sampled_from(names), CHOICES, CHOICES)
    lists = [st.lists(one, min_size=low, max_size=high) for low, high in ((0, 1), (1, 1), (1, 2))]
    breakages = st.sampled_from(lists).flatmap(lambda chosen: chosen)
    surfaces = grown(Bounds(max_faces, (1, 2), (0, 1), (0, 3))).map(lambda result: result.mesh)
    broken = st.builds(_broken, surfaces, breakages)
    # Not `one_of`, which counts equal strategies once.
    return st.sampled_from([broken] * 7 + [loose_faces()]).flatmap(lambda chosen: chosen)


def loose_faces(max_vertices: int = 5, max_faces: int = 8) -> st.SearchStrategy[FaceList]:
    """Any triples of few vertices, so many of them one upon the other."""
    index = st.integers(0, max_vertices - 1)
    faces = st.lists(st.tuples(index, index, index), max_size=max_faces).map(tuple)
    return st.builds(FaceList, faces, st.integers(max_vertices - 1, max_vertices))


def _broken(mesh: FaceList, breakages: list[tuple[str, int, int]]) -> FaceList:
    for name, i, j in breakages:
        mesh = BREAKAGES[name](mesh, i, j)
    return mesh


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "face-lists": face_lists(),
}
"""The domains of this module, by name."""
