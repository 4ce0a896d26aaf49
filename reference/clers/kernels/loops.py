"""The loops of what was undone, with what their edges know: the machine of the context code.

As in Spirale Reversi the loops are linked lists of edges, and the gates are on a stack. Edges are
numbered as they come into a loop; each leaves it once. With the start of an edge goes the number
of triangles there, at this place of the loop. All numbers count edges, symbols or records.
"""

from typing import Final

from librt.vecs import append, extend, vec
from mypy_extensions import i64

from clers.kernels.flat import zeros

C: Final = 0
R: Final = 1
L: Final = 2
E: Final = 3
S: Final = 4
"""The symbols in the order in which they are asked for. Clause: CODE-CONTEXT-1."""

MOST: Final = 15
"""Counts are seen up to this. Clause: CODE-CONTEXT-4."""

GLUED: Final = -1
"""Follows an edge that is in no loop any more."""

RIGHT: Final = 0

ROOM: Final = 1024
"""For so many edges room is made at once."""


class Loops:
    """Loops, gates and counts; private and mutable, never seen from outside. CODE-CONTEXT-2.

    `passed`, `sides`, `between`: the handle data as it is seen from the end (CODE-HAND-1), a side
    being RIGHT or not. `expected`: about so many symbols; memory is kept for them, and not touched.
    """

    def __init__(self, passed: vec[i64], sides: vec[i64], between: vec[i64], expected: i64) -> None:
        self.expected = expected
        self.after = vec[i64](capacity=2 * expected)
        self.before = vec[i64](capacity=2 * expected)
        self.count = vec[i64](capacity=2 * expected)
        self.edges: i64 = 0  # that were numbered
        self.gates = vec[i64]()
        self.height: i64 = 0  # of the stack of gates
        self.valences: i64 = 0  # of the vertex that left a loop last, and 16 times that before
        self.records_passed = passed
        self.records_side = sides
        self.records_between = between
        self.records: i64 = len(passed)
        self.met: i64 = 0  # records used up
        self.passed: i64 = 0
        self.rights = vec[i64]()  # edges that can close an S
        self.lefts = vec[i64]()

    def gate(self) -> i64:
        """The top of the stack."""
        return self.gates[self.height - 1]

    def push(self, edge: i64) -> None:
        """Put a gate on the stack."""
        if self.height < len(self.gates):
            self.gates[self.height] = edge
        else:
            self.gates = append(self.gates, edge)
        self.height += 1

    def other(self) -> i64:
        """The edge that the left edge of an S here is glued to; GLUED if there is none."""
        if self.has_record():
            between: i64 = self.records_between[self.met]
            edges = self.rights if self.records_side[self.met] == RIGHT else self.lefts
            n: i64 = len(edges)
            return edges[n - 1 - between] if between < n else GLUED
        return self.gates[self.height - 2] if self.height > 1 else GLUED

    def has_record(self) -> bool:
        """Whether the next S has a record. Clause: CODE-HAND-1."""
        return self.met < self.records and self.records_passed[self.met] == self.passed

    def can_split(self) -> bool:
        """Whether an S can be undone. Clause: CODE-CONTEXT-3."""
        e: i64 = self.gate()
        other: i64 = self.other()
        if other in (GLUED, e):
            return False
        beyond: i64 = self.after[other]
        return beyond != GLUED and self.after[e] != other and beyond != e and beyond != other

    def undo(self, symbol: i64) -> None:
        """Put the triangle of a symbol on the gate. Clause: CODE-CONTEXT-2."""
        if self.edges + 3 > len(self.after):
            self.make_room()
        if symbol == C:
            self.create()
        elif symbol == R:
            first: i64 = self.replace()
            self.gates[self.height - 1] = first
            if self.records > 0:
                self.rights = append(self.rights, first + 1)
        elif symbol == L:
            first = self.replace()
            self.gates[self.height - 1] = first + 1
            if self.records > 0:
                self.lefts = append(self.lefts, first)
        elif symbol == E:
            self.end()
        else:
            self.split()

    def make_room(self) -> None:
        """Room for more edges."""
        room = zeros(ROOM)
        self.after = extend(self.after, room)
        self.before = extend(self.before, room)
        self.count = extend(self.count, room)

    def end(self) -> None:
        """E: a new loop: the gate, the right and the left edge."""
        after = self.after
        before = self.before
        count = self.count
        gate: i64 = self.edges
        right: i64 = gate + 1
        left: i64 = gate + 2
        self.edges = gate + 3
        after[gate] = right
        after[right] = left
        after[left] = gate
        before[gate] = left
        before[right] = gate
        before[left] = right
        count[gate] = 1
        count[right] = 1
        count[left] = 1
        self.push(gate)
        if self.records > 0:
            self.rights = append(self.rights, right)
            self.lefts = append(self.lefts, left)

    def replace(self) -> i64:
        """R and L: two edges in place of the gate, and a new vertex between; the first of them."""
        after = self.after
        before = self.before
        count = self.count
        e: i64 = self.gate()
        b: i64 = after[e]
        x: i64 = before[e]
        first: i64 = self.edges
        second: i64 = first + 1
        self.edges = first + 2
        after[x] = first
        before[first] = x
        after[first] = second
        before[second] = first
        after[second] = b
        before[b] = second
        after[e] = GLUED
        count[first] = count[e] + 1
        count[second] = 1
        count[b] += 1
        return first

    def create(self) -> None:
        """C: the start of the old gate leaves the loop; its valence is known now."""
        after = self.after
        before = self.before
        count = self.count
        e: i64 = self.gate()
        b: i64 = after[e]
        x: i64 = before[e]
        xx: i64 = before[x]
        gate: i64 = self.edges
        self.edges = gate + 1
        after[xx] = gate
        before[gate] = xx
        after[gate] = b
        before[b] = gate
        after[e] = GLUED
        after[x] = GLUED
        count[gate] = count[x] + 1
        count[b] += 1
        valence: i64 = self.count[e] + 1
        if valence > MOST:
            valence = MOST
        self.valences = 16 * (self.valences & 15) + valence
        self.gates[self.height - 1] = gate

    def split(self) -> None:
        """S: the gate's loop and that of another edge become one, or one becomes two."""
        after = self.after
        before = self.before
        e: i64 = self.gate()
        other: i64 = self.other()
        b: i64 = after[e]
        x: i64 = before[e]
        q: i64 = after[other]
        p: i64 = before[other]
        self.count[b] += 1
        self.count[q] += self.count[e] + 1
        gate: i64 = self.edges
        self.edges = gate + 1
        self.count[gate] = self.count[other] + 1
        after[p] = gate
        before[gate] = p
        after[gate] = b
        before[b] = gate
        after[x] = q
        before[q] = x
        after[e] = GLUED
        after[other] = GLUED
        if self.has_record():
            self.met += 1
            self.passed = 0
        else:
            self.passed += 1
            self.height -= 1
        self.gates[self.height - 1] = gate
