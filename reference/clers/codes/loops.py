"""The loops of what was undone, with what their edges know: the machine of the context code.

As in Spirale Reversi the loops are linked lists of edges, and the gates are on a stack. Edges are
numbered as they come into a loop; each leaves it once. With the start of an edge goes the number
of triangles there, at this place of the loop.
"""

from collections.abc import Sequence
from typing import Final

from clers.codes.closings import Closing
from clers.edgebreaker.stream import Side

ORDER: Final = "CRLES"
"""The symbols in the order in which they are asked for. Clause: CODE-CONTEXT-1."""

C, R, L, E, S = range(5)

MOST: Final = 15
"""Counts are seen up to this. Clause: CODE-CONTEXT-4."""

GLUED: Final = -1
"""Follows an edge that is in no loop any more."""


class Loops:
    """Loops, gates and counts; private and mutable, never seen from outside. CODE-CONTEXT-2."""

    __slots__ = (
        "after",
        "before",
        "closings",
        "count",
        "gates",
        "lefts",
        "met",
        "passed",
        "rights",
        "valences",
    )

    def __init__(self, closings: Sequence[Closing]) -> None:
        self.after: list[int] = []
        self.before: list[int] = []
        self.count: list[int] = []
        self.gates: list[int] = []
        self.valences = 0  # of the vertex that left a loop last, and 16 times that before
        self.closings = closings
        self.met = 0  # closings used up
        self.passed = 0
        self.rights: list[int] = []  # edges that can close an S
        self.lefts: list[int] = []

    def _other(self) -> int:
        """The edge that the left edge of an S here is glued to; GLUED if there is none."""
        if self._has_record():
            closing = self.closings[self.met]
            edges = self.rights if closing.side is Side.RIGHT else self.lefts
            return edges[-1 - closing.between] if closing.between < len(edges) else GLUED
        return self.gates[-2] if len(self.gates) > 1 else GLUED

    def _has_record(self) -> bool:
        """Whether the next S has a record. Clause: CODE-HAND-1."""
        given, met = self.closings, self.met
        return met < len(given) and given[met].passed == self.passed

    def can_split(self) -> bool:
        """Whether an S can be undone. Clause: CODE-CONTEXT-3."""
        e, other, after = self.gates[-1], self._other(), self.after
        if other in (GLUED, e) or after[other] == GLUED:
            return False
        return after[e] != other and after[other] not in (e, other)

    def undo(self, symbol: int) -> None:
        """Put the triangle of a symbol on the gate. Clause: CODE-CONTEXT-2."""
        if symbol == C:
            self._create()
        elif symbol == R:
            first = self._replace()
            self.gates[-1] = first
            self.rights.append(first + 1)
        elif symbol == L:
            first = self._replace()
            self.gates[-1] = first + 1
            self.lefts.append(first)
        elif symbol == E:
            self._end()
        else:
            self._split()

    def _add(self, before: int, after: int, count: int) -> int:
        """A new edge between two others."""
        self.before.append(before)
        self.after.append(after)
        self.count.append(count)
        return len(self.after) - 1

    def _end(self) -> None:
        """E: a new loop: the gate, the right and the left edge."""
        gate = len(self.after)
        self._add(gate + 2, gate + 1, 1)
        self._add(gate, gate + 2, 1)
        self._add(gate + 1, gate, 1)
        self.gates.append(gate)
        self.rights.append(gate + 1)
        self.lefts.append(gate + 2)

    def _replace(self) -> int:
        """R and L: two edges in place of the gate, and a new vertex between; the first of them."""
        after, before, count = self.after, self.before, self.count
        e = self.gates[-1]
        b, x, first = after[e], before[e], len(after)
        before += (x, first)
        after += (first + 1, b)
        count += (count[e] + 1, 1)
        after[x], before[b] = first, first + 1
        after[e] = GLUED
        count[b] += 1
        return first

    def _create(self) -> None:
        """C: the start of the old gate leaves the loop; its valence is known now."""
        after, before, count = self.after, self.before, self.count
        e = self.gates[-1]
        b, x = after[e], before[e]
        xx = before[x]
        gate = len(after)  # `_add`, written out
        before.append(xx)
        after.append(b)
        count.append(count[x] + 1)
        after[xx] = before[b] = gate
        after[e] = after[x] = GLUED
        count[b] += 1
        self.valences = 16 * self.valences % 256 + min(count[e] + 1, MOST)
        self.gates[-1] = gate

    def _split(self) -> None:
        """S: the gate's loop and that of another edge become one, or one becomes two."""
        after, before, count = self.after, self.before, self.count
        e, other = self.gates[-1], self._other()
        b, x, q, p = after[e], before[e], after[other], before[other]
        count[b] += 1
        count[q] += count[e] + 1
        gate = self._add(p, b, count[other] + 1)
        after[p] = before[b] = gate
        after[x], before[q] = q, x
        after[e] = after[other] = GLUED
        if self._has_record():
            self.met += 1
            self.passed = 0
        else:
            self.passed += 1
            self.gates.pop()
        self.gates[-1] = gate
