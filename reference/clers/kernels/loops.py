"""The loops of what was undone, with what their edges know: the machine of the context code.

As in Spirale Reversi the loops are linked lists of edges, and the gates are on a stack. Edges are
numbered as they come into a loop; each leaves it once. With the start of an edge goes the number
of triangles there, at this place of the loop. All numbers count edges, symbols or records.

Where there are no records each loop has one gate, and an edge that left its loop is not asked for
again. Its number is given to the next edge, so that little memory is in use at any time. A record
may name any edge, and of one that left it has to be seen that it did: there no number comes again.
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
    being RIGHT or not. `gate` is the top of the stack of gates, `below` what is below it.
    """

    def __init__(self, passed: vec[i64], sides: vec[i64], between: vec[i64]) -> None:
        self.after = vec[i64]()
        self.before = vec[i64]()
        self.count = vec[i64]()
        self.edges: i64 = 0  # numbers that were given
        self.spare: i64 = GLUED  # one to give again, after which `after` has the next
        self.gate: i64 = GLUED
        self.below = vec[i64]()
        self.height: i64 = 0  # of the stack, with the gate
        self.valences: i64 = 0  # of the vertex that left a loop last, and 16 times that before
        self.records_passed = passed
        self.records_side = sides
        self.records_between = between
        self.records: i64 = len(passed)
        self.met: i64 = 0  # records used up
        self.passed: i64 = 0
        self.rights = vec[i64]()  # edges that can close an S
        self.lefts = vec[i64]()

    def push(self, edge: i64) -> None:
        """Put a gate on the stack."""
        height: i64 = self.height
        self.height = height + 1
        if height > len(self.below):
            self.below = append(self.below, self.gate)
        elif height > 0:
            self.below[height - 1] = self.gate
        self.gate = edge

    def number(self) -> i64:
        """The number of one edge more."""
        edge: i64 = self.spare
        if edge == GLUED:
            edge = self.edges
            self.edges = edge + 1
        else:
            self.spare = self.after[edge]
        return edge

    def leave(self, edge: i64) -> None:
        """An edge is in no loop any more."""
        if self.records > 0:
            self.after[edge] = GLUED
        else:
            self.after[edge] = self.spare
            self.spare = edge

    def other(self) -> i64:
        """The edge that the left edge of an S here is glued to; GLUED if there is none."""
        if self.has_record():
            between: i64 = self.records_between[self.met]
            edges = self.rights if self.records_side[self.met] == RIGHT else self.lefts
            n: i64 = len(edges)
            return edges[n - 1 - between] if between < n else GLUED
        return self.below[self.height - 2] if self.height > 1 else GLUED

    def has_record(self) -> bool:
        """Whether the next S has a record. Clause: CODE-HAND-1."""
        return self.met < self.records and self.records_passed[self.met] == self.passed

    def can_split(self) -> bool:
        """Whether an S can be undone. Clause: CODE-CONTEXT-3."""
        e: i64 = self.gate
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
            self.gate = first
            if self.records > 0:
                self.rights = append(self.rights, self.after[first])
        elif symbol == L:
            first = self.replace()
            self.gate = self.after[first]
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
        gate: i64 = self.number()
        right: i64 = self.number()
        left: i64 = self.number()
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
        e: i64 = self.gate
        b: i64 = after[e]
        x: i64 = before[e]
        first: i64 = self.number()
        second: i64 = self.number()
        after[x] = first
        before[first] = x
        after[first] = second
        before[second] = first
        after[second] = b
        before[b] = second
        count[first] = count[e] + 1
        count[second] = 1
        count[b] += 1
        self.leave(e)
        return first

    def create(self) -> None:
        """C: the start of the old gate leaves the loop; its valence is known now."""
        after = self.after
        before = self.before
        count = self.count
        e: i64 = self.gate
        b: i64 = after[e]
        x: i64 = before[e]
        xx: i64 = before[x]
        gate: i64 = self.number()
        after[xx] = gate
        before[gate] = xx
        after[gate] = b
        before[b] = gate
        count[gate] = count[x] + 1
        count[b] += 1
        valence: i64 = count[e] + 1
        if valence > MOST:
            valence = MOST
        self.valences = 16 * (self.valences & 15) + valence
        self.gate = gate
        self.leave(e)
        self.leave(x)

    def split(self) -> None:
        """S: the gate's loop and that of another edge become one, or one becomes two."""
        after = self.after
        before = self.before
        e: i64 = self.gate
        other: i64 = self.other()
        b: i64 = after[e]
        x: i64 = before[e]
        q: i64 = after[other]
        p: i64 = before[other]
        self.count[b] += 1
        self.count[q] += self.count[e] + 1
        gate: i64 = self.number()
        self.count[gate] = self.count[other] + 1
        after[p] = gate
        before[gate] = p
        after[gate] = b
        before[b] = gate
        after[x] = q
        before[q] = x
        self.leave(e)
        self.leave(other)
        if self.has_record():
            self.met += 1
            self.passed = 0
        else:
            self.passed += 1
            self.height -= 1
        self.gate = gate
