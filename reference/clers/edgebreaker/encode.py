"""Compression: Algorithms 3, 4 and 5 of the tutorial on flat arrays, linear, without recursion."""

from typing import Final

from clers.complexes.border import border_from
from clers.complexes.surface import (
    BORDER,
    Corner,
    Surface,
    Vertex,
    face_of,
    next_corner,
    previous_corner,
)
from clers.edgebreaker.stream import Encoding, Kind, Record, Side, Stream

NO_S: Final = -1


def encode(surface: Surface) -> Encoding:
    """The canonical stream of a surface, with the orders that tie the two.

    Algorithm 4: components with boundary first. Total: every surface has a stream. Linear in the
    number of faces. Clauses: EB-COMPONENT-1 … EB-COMPONENT-4, EB-TRAVERSE-1 … EB-TRAVERSE-7,
    EB-HANDLE-1 … EB-HANDLE-5, EB-ORDER-1 … EB-ORDER-3. What the symbols and records then count:
    EB-COUNT-1 … EB-COUNT-4.
    """
    walk = _Walk(surface)
    with_boundary = 0
    for c, across in enumerate(surface.opposite):
        corner = Corner(c)
        if across == BORDER and not walk.visited[face_of(corner)]:
            walk.reach_curve(next_corner(corner))
            walk.traverse(corner)
            with_boundary += 1
    for t in range(surface.faces):
        if not walk.visited[t]:
            walk.visit_root(Corner(3 * t))
            walk.traverse(surface.opposite[3 * t])
    records = tuple(walk.records[s] for s in sorted(walk.records))
    stream = Stream("".join(walk.word), records, with_boundary)
    return Encoding(stream, tuple(walk.vertex_order), tuple(walk.tip_order))


class _Walk:
    """What the walk has seen and written so far; private and mutable, never seen from outside."""

    __slots__ = (
        "closers", "left_of", "marked", "on_curve", "reached_curve", "records", "surface",
        "tip_order", "vertex_order", "visited", "word",
    )  # fmt: skip

    def __init__(self, surface: Surface) -> None:
        self.surface = surface
        self.visited = bytearray(surface.faces)
        self.marked = bytearray(surface.vertices)  # on a visited face, or on a curve reached
        self.on_curve = bytearray(surface.vertices)
        for c, across in enumerate(surface.opposite):
            if across == BORDER:
                self.on_curve[surface.vertex[next_corner(Corner(c))]] = 1
        self.word: list[str] = []
        self.vertex_order: list[Vertex] = []
        self.tip_order: list[Corner] = []
        self.records: dict[int, Record] = {}
        self.left_of: dict[Corner, int] = {}  # the corner opposite to the left edge of an S → s
        self.reached_curve: set[int] = set()  # the S, by number, that reached a curve
        self.closers = 0  # R, L and E written so far

    def reach_curve(self, corner: Corner) -> None:
        """Mark the vertices of a curve, from a corner's vertex on. Clause: EB-ORDER-2."""
        for c in border_from(self.surface.opposite, corner):
            v = self.surface.vertex[c]
            self.marked[v] = 1
            self.vertex_order.append(v)

    def visit_root(self, corner: Corner) -> None:
        """P: visited without a symbol. Clause: EB-COMPONENT-2."""
        self.visited[face_of(corner)] = 1
        self.tip_order.append(corner)
        for v in self.surface.vertex[corner : corner + 3]:
            self.marked[v] = 1
            self.vertex_order.append(v)

    def close(self, edge: Corner, side: Side) -> None:
        """Algorithm 5: is this closed edge the left edge of an S? Clauses: EB-HANDLE-1 … -4."""
        s = self.left_of.get(self.surface.opposite[edge], NO_S)
        if s != NO_S:
            kind = Kind.BOUNDARY if s in self.reached_curve else Kind.HANDLE
            self.records[s] = Record(kind, s, self.closers, side)

    def traverse(self, gate: Corner) -> None:
        """Algorithm 3, from one gate until the stack is empty. Clauses: EB-TRAVERSE-1 … -7."""
        vertex, opposite = self.surface.vertex, self.surface.opposite
        visited, marked, on_curve = self.visited, self.marked, self.on_curve
        stack: list[Corner] = []
        while True:
            visited[gate // 3] = 1
            self.tip_order.append(gate)
            v = vertex[gate]
            right, left = next_corner(gate), previous_corner(gate)
            right_gate, left_gate = opposite[right], opposite[left]
            if not (marked[v] or on_curve[v]):
                self.word.append("C")
                marked[v] = 1
                self.vertex_order.append(v)
                gate = right_gate
                continue
            right_closed = right_gate == BORDER or visited[right_gate // 3]
            left_closed = left_gate == BORDER or visited[left_gate // 3]
            if not (right_closed or left_closed):
                self.word.append("S")
                if not marked[v]:
                    self.reached_curve.add(len(self.left_of))
                    self.reach_curve(gate)
                self.left_of[left] = len(self.left_of)
                stack.append(left_gate)
                gate = right_gate
                continue
            if right_closed:
                self.close(right, Side.RIGHT)
            if left_closed:
                self.close(left, Side.LEFT)
            self.closers += 1
            if not left_closed:
                self.word.append("R")
                gate = left_gate
            elif not right_closed:
                self.word.append("L")
                gate = right_gate
            else:
                self.word.append("E")
                while stack and visited[stack[-1] // 3]:
                    stack.pop()
                if not stack:
                    return
                gate = stack.pop()
