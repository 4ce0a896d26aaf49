"""The orientation of a rooted triangulation in which every inner vertex has three edges going out.

There is one without a clockwise cycle. It is found by shelling: a path from v2 to v1 bounds what is
left; a vertex on it that has no chords is taken away, always the one nearest to v1 that can be. Its
edges to its neighbours on the path go out of it, and its other edges come in.
"""

from clers.codes.half_edges import HalfEdges


def orientation(edges: HalfEdges) -> bytearray:
    """For each half-edge 1 if its edge is directed so, else 0; of a sphere rooted at corner 0.

    The edges of the root face have no direction. Linear. Clauses: CODE-TREE-2, CODE-TREE-3.
    """
    path = _Path(edges)
    todo = [edges.source[0]]
    while todo:
        x = todo.pop()
        if path.may_leave(x):
            todo += path.leave(x)
    return path.out


class _Path:
    """The path, as a linked list of vertices; private and mutable, never seen from outside."""

    __slots__ = ("after", "before", "chords", "edges", "new", "on_path", "out", "to_before")

    def __init__(self, edges: HalfEdges) -> None:
        v0, v1, v2 = edges.source[:3]
        self.edges = edges
        self.out = bytearray(len(edges.source))
        self.before = {v0: v2, v1: v0}
        self.after = {v0: v1, v2: v0}
        self.to_before = {v0: edges.turn[0], v1: 0}  # the half-edge of a vertex to the one before
        self.on_path = bytearray(edges.vertices)
        for v in (v0, v1, v2):
            self.on_path[v] = 1
        self.new = bytearray(edges.vertices)
        self.chords = [0] * edges.vertices

    def may_leave(self, x: int) -> bool:
        """Is x a vertex between the ends, without a chord?"""
        inside = x in self.before and x in self.after
        return bool(inside and self.on_path[x] and not self.chords[x])

    def leave(self, x: int) -> list[int]:
        """Take x away; the answer is the part of the path that is touched, from v2's side on."""
        source, twin, turn = self.edges.source, self.edges.twin, self.edges.turn
        low, high = self.before[x], self.after[x]
        self.on_path[x] = 0
        touched = [low]
        h = self.to_before[x]
        start = h
        while True:
            beyond = twin[h - 2 if h % 3 == 2 else h + 1]  # from the next neighbour to this one
            y = source[beyond]
            self.before[y], self.after[touched[-1]] = touched[-1], y
            self.to_before[y] = beyond
            touched.append(y)
            h = turn[h]
            if y == high:
                break
            self.out[twin[h]] = 1
        if x != source[0]:
            self.out[start] = self.out[h] = 1
        inner = touched[1:-1]
        if not inner:
            self.chords[low] -= 1
            self.chords[high] -= 1
        for y in inner:
            self.on_path[y] = self.new[y] = 1
        for y in inner:
            self._count_chords(y)
        for y in inner:
            self.new[y] = 0
        return touched

    def _count_chords(self, y: int) -> None:
        """Count the edges from a new vertex of the path to others of it, not beside it."""
        for h in self.edges.around(self.to_before[y]):
            z = self.edges.source[self.edges.twin[h]]
            if self.on_path[z] and z not in (self.before[y], self.after[y]):
                self.chords[y] += 1
                self.chords[z] += 1 - self.new[z]
