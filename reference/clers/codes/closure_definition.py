"""What closing the string about a tree is, by looking for something to close again and again."""

from clers.codes.closure import LEAF, Face, Side, sides
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then


def faces_by_rescanning(word: bytes) -> Accepted[tuple[Face, ...]] | Rejected:
    """The faces of the triangulation of which this is the word, the root face first. Quadratic.

    Clauses: CODE-TREE-6 … CODE-TREE-8.
    """
    return and_then(sides(word), _rescanned)


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
