"""From the word of a tree back to the rooted triangulation: leaves are joined to what they reach.

About the tree goes a string of leaves and edges. A leaf and the two edges after it make a triangle,
and its third side takes their place. A stack does all of this in one pass.
"""

from itertools import pairwise
from typing import Final

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.where import WHOLE, AtSymbol

LEAF: Final = -1

Side = tuple[int, int]
"""One side of the string: (x, y) an edge from x to y, or (x, LEAF) a leaf of x."""

Face = tuple[int, int, int]


def sphere_of(word: bytes) -> Accepted[Surface] | Rejected:
    """The triangulation of which this is the word; its root is corner 0. Linear.

    Vertices: 0 is v0, then those of the tree as the word reaches them, then v1 and v2.
    Clauses: CODE-TREE-5 … CODE-TREE-9.
    """
    faces = and_then(sides(word), closed)
    return and_then(faces, lambda found: surface(FaceList(found, len(word) // 4 + 3)))


def sides(word: bytes) -> Accepted[list[Side]] | Rejected:
    """The string that a word describes, from the first leaf of the root to its last.

    One bit in each byte. Linear. Clauses: CODE-TREE-5, CODE-TREE-6.
    """
    found: list[Side] = [(0, LEAF)]
    path, zeros = [0], [0]
    for index, bit in enumerate(word):
        x = path[-1]
        if bit:
            y = len(zeros)
            path.append(y)
            zeros.append(0)
            found.append((x, y))
        elif x == 0:
            detail = "the root has its two leaves already"
            return Rejected(Reason.NOT_CANONICAL, Clause.CODE_TREE_6, AtSymbol(index), detail)
        else:
            zeros[x] += 1
            if zeros[x] > 2:
                path.pop()
                found.append((x, path[-1]))
            else:
                found.append((x, LEAF))
    if len(path) > 1 or len(zeros) == 1:
        detail = f"the tree has {len(zeros)} vertices, {len(path) - 1} of them not finished"
        return Rejected(Reason.NOT_CANONICAL, Clause.CODE_TREE_6, WHOLE, detail)
    found.append((0, LEAF))
    return Accepted(found)


def closed(string: list[Side]) -> Accepted[tuple[Face, ...]] | Rejected:
    """The faces that a string closes to, the root face first. Linear.

    Clauses: CODE-TREE-6 … CODE-TREE-8.
    """
    inner: list[Face] = []
    stack: list[Side] = []
    for side in string:
        stack.append(side)
        while len(stack) > 2 and stack[-1][1] != LEAF != stack[-2][1] and stack[-3][1] == LEAF:
            end = stack.pop()[1]
            middle = stack.pop()[1]
            start = stack.pop()[0]
            inner.append((start, end, middle))
            stack.append((start, end))
    if stack[0][1] != LEAF:
        detail = "the first leaf of the root is closed"
        return Rejected(Reason.NOT_CANONICAL, Clause.CODE_TREE_6, WHOLE, detail)
    v1 = len(string) // 4 + 1
    return Accepted(((0, v1, v1 + 1), *inner, *_outer(stack, v1)))


def _outer(rest: list[Side], v1: int) -> list[Face]:
    """The faces at v1 and v2, but the root: leaves up to a vertex with two go to v2. CODE-TREE-8.

    What is left is leaves and edges by turns, except for two leaves of one vertex.
    """
    faces: list[Face] = []
    outer = v1 + 1
    for (x, y), (_, z) in pairwise(rest):
        if y != LEAF:
            faces.append((x, outer, y))
        elif z == LEAF:
            faces.append((x, outer, v1))
            outer = v1
    return faces
