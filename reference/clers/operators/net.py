"""The questions that script operators ask a mesh: who runs this side, where is the border.

A *side* is a directed edge `(tail, head)` as a face runs it. In an oriented surface each side has
one face, and the face across is the one that runs the side the other way. All answers are in the
order of the faces, so that a choice by number means the same in every run. Clause: OPER-SCRIPT-7.
"""

from collections.abc import Mapping, Sequence

Triangle = tuple[int, int, int]
Side = tuple[int, int]


def sides(faces: Sequence[Triangle]) -> dict[Side, int]:
    """Each side with the number of the face that runs it."""
    return {side: t for t, (a, b, c) in enumerate(faces) for side in ((a, b), (b, c), (c, a))}


def border(of: Mapping[Side, int]) -> list[Side]:
    """The sides with no face across."""
    return [(tail, head) for tail, head in of if (head, tail) not in of]


def inner_edges(of: Mapping[Side, int]) -> list[Side]:
    """Each edge with two faces once, as the side from its lower vertex. Clause: OPER-SCRIPT-7."""
    return [(tail, head) for tail, head in of if tail < head and (head, tail) in of]


def edges(of: Mapping[Side, int]) -> list[Side]:
    """Each edge once: the side from its lower vertex, or the only side it has."""
    return [(tail, head) for tail, head in of if tail < head or (head, tail) not in of]


def joined(of: Mapping[Side, int], u: int, v: int) -> bool:
    """Is there an edge between two vertices?"""
    return (u, v) in of or (v, u) in of


def apex(faces: Sequence[Triangle], of: Mapping[Side, int], side: Side) -> int:
    """The vertex opposite to a side, in the face that runs it."""
    a, b, c = faces[of[side]]
    return a + b + c - side[0] - side[1]


def curves(border_sides: Sequence[Side]) -> list[list[int]]:
    """The boundary curves as cycles of vertices, in the direction their faces run them."""
    after = dict(border_sides)
    found: list[list[int]] = []
    while after:
        v = next(iter(after))
        curve: list[int] = []
        while v in after:
            curve.append(v)
            v = after.pop(v)
        found.append(curve)
    return found


def component_of_faces(faces: Sequence[Triangle], vertices: int) -> list[int]:
    """For each face the lowest vertex of its component: equal exactly within one component."""
    root = list(range(vertices))
    for a, b, c in faces:
        low = sorted((_find(root, a), _find(root, b), _find(root, c)))
        root[low[1]] = root[low[2]] = low[0]
    return [_find(root, face[0]) for face in faces]


def _find(root: list[int], v: int) -> int:
    """The root of a vertex, halving the path on the way."""
    while root[v] != v:
        root[v] = root[root[v]]
        v = root[v]
    return v
