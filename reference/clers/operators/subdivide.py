"""Operators that leave the topology as it is: split a face or an edge, flip an edge, relabel."""

from clers.complexes.face_list import FaceList
from clers.operators.net import Triangle, apex, edges, inner_edges, joined, sides
from clers.operators.split_mix import shuffled, split_mix
from clers.operators.step import Obstacle, Step, did, idle


def split_face(mesh: FaceList, choice: int) -> Step:
    """Put a vertex into a face. Clause: OPER-REFINE-1."""
    faces = list(mesh.faces)
    t = choice % len(faces)
    a, b, c = faces[t]
    p = mesh.vertices
    faces[t] = (a, b, p)
    faces += [(b, c, p), (c, a, p)]
    return did(faces, mesh.vertices + 1)


def split_edge(mesh: FaceList, choice: int) -> Step:
    """Put a vertex on an edge, on the border or not. Clause: OPER-REFINE-2."""
    of = sides(mesh.faces)
    candidates = edges(of)
    tail, head = candidates[choice % len(candidates)]
    faces = list(mesh.faces)
    p = mesh.vertices
    for u, v in ((tail, head), (head, tail)):
        if (u, v) in of:
            w = apex(mesh.faces, of, (u, v))
            faces[of[u, v]] = (u, p, w)
            faces.append((p, v, w))
    return did(faces, mesh.vertices + 1)


def flip_edge(mesh: FaceList, choice: int) -> Step:
    """Turn an edge between two faces into the other diagonal. Clause: OPER-REFINE-3."""
    of = sides(mesh.faces)
    candidates = inner_edges(of)
    if not candidates:
        return idle(mesh, Obstacle.NO_CANDIDATE)
    u, v = candidates[choice % len(candidates)]
    w = apex(mesh.faces, of, (u, v))
    x = apex(mesh.faces, of, (v, u))
    if joined(of, w, x):
        return idle(mesh, Obstacle.EDGE_EXISTS)
    faces = list(mesh.faces)
    faces[of[u, v]] = (w, u, x)
    faces[of[v, u]] = (x, v, w)
    return did(faces, mesh.vertices)


def relabel(mesh: FaceList, seed: int) -> Step:
    """Permute vertices and faces, and turn each face, by a seed. Clause: OPER-REFINE-4."""
    if seed % (1 << 64) == 0:
        return did(list(mesh.faces), mesh.vertices)
    words = split_mix(seed)
    number = shuffled(mesh.vertices, words)
    faces: list[Triangle] = []
    for t in shuffled(len(mesh.faces), words):
        a, b, c = (number[v] for v in mesh.faces[t])
        faces.append(((a, b, c), (b, c, a), (c, a, b))[next(words) % 3])
    return did(faces, mesh.vertices)
