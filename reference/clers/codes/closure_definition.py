"""What closing the string about a tree is, by looking for something to close again and again."""

from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.where import WHOLE, AtSymbol

LEAF: Final = -1

Side = tuple[int, int]
"""One side of the string: (x, y) an edge from x to y, or (x, LEAF) a leaf of x."""

Face = tuple[int, int, int]


def faces_by_rescanning(word: bytes) -> Accepted[tuple[Face, ...]] | Rejected:
    """The faces of the triangulation of which this is the word, the root face first. Quadratic.

    Clauses: CODE-TREE-6 … CODE-TREE-8.
    """
    return and_then(sides(word), _rescanned)


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


def _rescanned(string: list[Side]) -> Accepted[tuple[Face, ...]] | Rejected:
    faces: list[Face] = []
    places = list(enumerate(string))  # each side with its place in the string at first
    while (at := _closable(places)) is not None:
        turned = places[at:] + places[:at]
        (_, (x, _)), (_, (_, y)), (_, (_, z)) = turned[:3]
        faces.append((x, z, y))
        places = [(-1, (x, z)), *turned[3:]]
    first = next((i for i, (place, _) in enumerate(places) if place == 0), None)
    if first is None or places[first - 1][0] != len(string) - 1:
        detail = "a leaf of the root is closed"
        return Rejected(Reason.NOT_CANONICAL, Clause.CODE_TREE_6, detail=detail)
    inner = max(x for x, _ in string)
    return Accepted(tuple(_joined([s for _, s in places[first:] + places[:first]], inner) + faces))


def _closable(places: list[tuple[int, Side]]) -> int | None:
    """The first place at which, going round, a leaf and two edges follow one another."""
    for i in range(len(places)):
        window = [places[(i + k) % len(places)][1][1] != LEAF for k in range(3)]
        if window == [False, True, True]:
            return i
    return None


def _joined(rest: list[Side], inner: int) -> list[Face]:
    """Join each leaf to v2, or to v1 from the second of two leaves on; the root face comes first.

    About the source of a leaf the next thing is an edge or another leaf; they span a face.
    """
    ends: list[Side] = []
    outer = inner + 2
    for k, (x, y) in enumerate(rest):
        if 0 < k < len(rest) and y == LEAF == rest[k - 1][1]:
            outer = inner + 1
        ends.append((x, outer if y == LEAF else y))
    return [(x, ends[k - 1][1], y) for k, (x, y) in enumerate(ends) if rest[k - 1][1] == LEAF]
