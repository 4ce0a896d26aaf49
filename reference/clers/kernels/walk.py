"""The walk of compression over a corner table: Algorithms 3, 4 and 5 of the tutorial.

Everything counts corners, faces, vertices or symbols, so nothing comes near 2^63.
"""

from typing import Final

from librt.strings import BytesWriter
from librt.vecs import append, vec
from mypy_extensions import i64

from clers.kernels.flat import flags, zeros
from clers.kernels.scan import C, E, L, R, S

UNVISITED: Final = 0
VISITED: Final = 1
SPLIT: Final = 2

UNSEEN: Final = 0
ON_CURVE: Final = 1
MARKED: Final = 2


class Walk:
    """What the walk has seen and written so far; private and mutable, never seen from outside.

    `gates`: the corners opposite to edges of the border. `visited[t]`: UNVISITED, VISITED, or SPLIT
    where an S is; `split_of[t]` is the number of that S. `mark[v]`: UNSEEN; ON_CURVE, of a curve
    not reached; MARKED, on a visited face or on a curve reached. The first `met` of `order` are the
    vertices met, the first `made` of `tips` the tips of the faces visited. Of S number s: `left_of`
    its left corner, `reaches` whether it reached a curve, `closed` 2·(closers before) + 1 if its
    left edge was closed as a left edge, + 0 as a right one, or -1.
    """

    def __init__(self, vertex: vec[i64], opposite: vec[i64], vertices: i64) -> None:
        corners: i64 = len(vertex)
        mark = flags(vertices)
        gates = vec[i64]()
        c: i64 = 0
        while c < corners:
            if opposite[c] < 0:
                mark[vertex[c - 2 if c % 3 == 2 else c + 1]] = ON_CURVE
                gates = append(gates, c)
            c += 1
        self.vertex = vertex
        self.opposite = opposite
        self.visited = flags(corners // 3)
        self.split_of = zeros(corners // 3)
        self.mark = mark
        self.gates = gates
        self.word = BytesWriter()
        self.order = zeros(vertices)
        self.met: i64 = 0
        self.tips = zeros(corners // 3)
        self.made: i64 = 0
        self.left_of = vec[i64]()
        self.reaches = vec[i64]()
        self.closed = vec[i64]()
        self.closers: i64 = 0
        self.with_boundary: i64 = 0

    def meet(self, v: i64) -> None:
        """The next vertex in the order of creation. Clause: EB-ORDER-1."""
        self.mark[v] = MARKED
        self.order[self.met] = v
        self.met += 1

    def reach_curve(self, corner: i64) -> None:
        """Mark the vertices of a curve, from a corner's vertex on. Clauses: EB-ORDER-2, -CURVE."""
        opposite = self.opposite
        c = outgoing(opposite, corner)
        start = c
        while True:
            v: i64 = self.vertex[c]
            self.meet(v)
            c = outgoing(opposite, c - 2 if c % 3 == 2 else c + 1)
            if c == start:
                return

    def visit_root(self, corner: i64) -> None:
        """P: visited without a symbol. Clause: EB-COMPONENT-2."""
        self.visited[corner // 3] = VISITED
        self.tips[self.made] = corner
        self.made += 1
        k: i64 = 0
        while k < 3:
            self.meet(self.vertex[corner + k])
            k += 1

    def close(self, across: i64, at: i64) -> None:
        """Algorithm 5: is the closed edge the left edge of this S? Clauses: EB-HANDLE-1 … -4."""
        s: i64 = self.split_of[across // 3]
        if self.left_of[s] == across:
            self.closed[s] = at

    def traverse(self, gate: i64) -> None:
        """Algorithm 3, from one gate until the stack is empty. Clauses: EB-TRAVERSE-1 … -7."""
        vertex = self.vertex
        opposite = self.opposite
        visited = self.visited
        mark = self.mark
        word = self.word
        order = self.order
        tips = self.tips
        met: i64 = self.met
        made: i64 = self.made
        closers: i64 = self.closers
        stack = vec[i64]()
        height: i64 = 0
        while True:
            face: i64 = gate // 3
            visited[face] = VISITED
            tips[made] = gate
            made += 1
            v: i64 = vertex[gate]
            turn: i64 = gate % 3
            right_gate: i64 = opposite[gate - 2 if turn == 2 else gate + 1]
            if mark[v] == UNSEEN:
                word.append(C)
                mark[v] = MARKED
                order[met] = v
                met += 1
                gate = right_gate
                continue
            left: i64 = gate - 1 if turn else gate + 2
            left_gate: i64 = opposite[left]
            right_seen: i64 = VISITED if right_gate < 0 else i64(visited[right_gate // 3])
            left_seen: i64 = VISITED if left_gate < 0 else i64(visited[left_gate // 3])
            if right_seen == UNVISITED and left_seen == UNVISITED:
                word.append(S)
                visited[face] = SPLIT
                self.split_of[face] = len(self.left_of)
                self.left_of = append(self.left_of, left)
                self.closed = append(self.closed, -1)
                if mark[v] == ON_CURVE:
                    self.reaches = append(self.reaches, 1)
                    self.met = met
                    self.reach_curve(gate)
                    met = self.met
                else:
                    self.reaches = append(self.reaches, 0)
                if height < len(stack):
                    stack[height] = left_gate
                else:
                    stack = append(stack, left_gate)
                height += 1
                gate = right_gate
                continue
            if right_seen == SPLIT:
                self.close(right_gate, 2 * closers)
            if left_seen == SPLIT:
                self.close(left_gate, 2 * closers + 1)
            closers += 1
            if left_seen == UNVISITED:
                word.append(R)
                gate = left_gate
            elif right_seen == UNVISITED:
                word.append(L)
                gate = right_gate
            else:
                word.append(E)
                while height > 0 and visited[stack[height - 1] // 3] != UNVISITED:
                    height -= 1
                if height == 0:
                    self.met = met
                    self.made = made
                    self.closers = closers
                    return
                height -= 1
                gate = stack[height]


def outgoing(opposite: vec[i64], corner: i64) -> i64:
    """The corner of the same vertex from which the border leaves along a face's edge.

    Clauses: CPLX-CORNER-4, CPLX-CURVE-1.
    """
    c = corner
    while True:
        d: i64 = opposite[c + 2 if c % 3 == 0 else c - 1]
        if d < 0:
            return c
        c = d + 2 if d % 3 == 0 else d - 1


def walked(vertex: vec[i64], opposite: vec[i64], vertices: i64) -> Walk:
    """The walk over all components. Linear.

    Clauses: EB-COMPONENT-1 … EB-COMPONENT-4.
    """
    walk = Walk(vertex, opposite, vertices)
    visited = walk.visited
    for gate in walk.gates:
        if visited[gate // 3] == UNVISITED:
            walk.reach_curve(gate - 2 if gate % 3 == 2 else gate + 1)
            walk.traverse(gate)
            walk.with_boundary += 1
    faces: i64 = len(visited)
    t: i64 = 0
    while t < faces:
        if visited[t] == UNVISITED:
            walk.visit_root(3 * t)
            walk.traverse(opposite[3 * t])
        t += 1
    return walk
