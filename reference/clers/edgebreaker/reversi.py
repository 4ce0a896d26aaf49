"""Spirale Reversi: decode from the last symbol to the first, checking the grammar on the way.

The machine holds the loops that bound the region still to be visited, as linked lists of edges. An
edge is named by the corner opposite to it. In a loop the edges run as the faces run them, the gate
of each loop is on a stack. Undoing a symbol puts its triangle in front of its gate.
"""

from typing import Final

from clers.complexes.surface import BORDER
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtRecord, AtSymbol
from clers.edgebreaker.outline import Outline, Part
from clers.edgebreaker.stream import Kind

SHORTEST_LOOP_UNDER_C: Final = 4
TRIANGLE: Final = 3


def reversi(outlined: Outline) -> Accepted[list[int]] | Rejected:
    """The opposite corner of each corner, or the symbol at which no surface has this stream.

    Linear in the word: each edge enters a loop once and leaves it once.
    Clauses: EB-REVERSI-1, EB-REVERSI-2, EB-REVERSI-3, EB-GRAMMAR-5 … EB-GRAMMAR-8.
    """
    opposite: list[int] = [BORDER] * (3 * outlined.faces)
    machine = _Loops(outlined, opposite)
    for part in reversed(outlined.parts):
        fault = machine.component(part)
        if fault is not None:
            return fault
    return Accepted(opposite)


class _Loops:
    """The loops of one component at a time; private and mutable, never seen from outside."""

    __slots__ = ("after", "before", "curve", "opposite", "outlined", "tagged")

    def __init__(self, outlined: Outline, opposite: list[int]) -> None:
        self.outlined = outlined
        self.opposite = opposite
        self.after = [0] * len(opposite)
        self.before = [0] * len(opposite)
        self.tagged = bytearray(len(opposite))  # waits to be glued to the left edge of an S
        self.curve = bytearray(len(opposite))  # lies on a boundary curve that is complete
        for edge in outlined.glue:
            self.tagged[edge] = 1

    def component(self, part: Part) -> Rejected | None:
        """Undo the symbols of one component, then close its first loop."""
        word, face = self.outlined.stream.word, self.outlined.face
        after, before = self.after, self.before
        gates: list[int] = []
        ends: list[int] = []  # the last symbol of the branch behind each gate
        for i in range(part.stop - 1, part.start - 1, -1):
            gate = 3 * face[i]
            right, left = gate + 1, gate + 2
            match word[i]:
                case "E":
                    after[gate], after[right], after[left] = right, left, gate
                    before[right], before[left], before[gate] = gate, right, left
                    gates.append(gate)
                    ends.append(i)
                case "R":
                    self.glue(left, gates[-1])
                    self.replace(gates[-1], gate, right)
                    gates[-1] = gate
                case "L":
                    self.glue(right, gates[-1])
                    self.replace(gates[-1], left, gate)
                    gates[-1] = gate
                case "C":
                    fault = self.undo_create(gates[-1], gate, i)
                    if fault is not None:
                        return fault
                    gates[-1] = gate
                case _:
                    r = self.outlined.record_of[i]
                    beyond = gates.pop()
                    if r < 0:
                        ends.pop()
                        self.split(gate, beyond, gates[-1])
                        gates[-1] = gate
                    else:
                        fault = self.undo_recorded(r, gate, beyond, ends[-1])
                        if fault is not None:
                            return fault
                        gates.append(gate)
        return self.close_first_loop(part, gates[0])

    def glue(self, c: int, d: int) -> None:
        """Make two edges one."""
        self.opposite[c], self.opposite[d] = d, c

    def replace(self, old: int, first: int, second: int) -> None:
        """Put two edges where one was."""
        after, before = self.after, self.before
        p, n = before[old], after[old]
        after[p], before[first] = first, p
        after[first], before[second] = second, first
        after[second], before[n] = n, second

    def undo_create(self, beyond: int, gate: int, i: int) -> Rejected | None:
        """C: the apex leaves the loop, with the two edges at it. Clause: EB-GRAMMAR-5."""
        after, before = self.after, self.before
        last = before[beyond]
        if before[before[last]] == beyond or last == beyond or before[last] == beyond:
            detail = f"a loop of {SHORTEST_LOOP_UNDER_C} edges at least must follow a C"
            return Rejected(Reason.LOOP_TOO_SHORT, Clause.EB_GRAMMAR_5, AtSymbol(i), detail)
        if self.tagged[last]:
            detail = "the left edge of this C is glued by a handle record"
            return Rejected(Reason.EDGE_CLOSED_TWICE, Clause.EB_GRAMMAR_5, AtSymbol(i), detail)
        self.glue(gate + 1, beyond)
        self.glue(gate + 2, last)
        p, n = before[last], after[beyond]
        after[p] = before[n] = gate
        before[gate], after[gate] = p, n
        return None

    def split(self, gate: int, right: int, left: int) -> None:
        """S: glue both sides; join the loops of the two edges, or cut their common loop in two."""
        after, before = self.after, self.before
        self.glue(gate + 1, right)
        self.glue(gate + 2, left)
        before_left, after_left = before[left], after[left]
        before_right, after_right = before[right], after[right]
        after[before_left], before[gate] = gate, before_left
        after[gate], before[after_right] = after_right, gate
        after[before_right], before[after_left] = after_left, before_right

    def undo_recorded(self, r: int, gate: int, right: int, end: int) -> Rejected | None:
        """An S with a record: its left edge is tagged in a loop. Clauses: EB-GRAMMAR-6, -7."""
        record = self.outlined.stream.records[r]
        left = self.outlined.glue[r]
        closer = left // 3
        if closer > self.outlined.face[end]:
            detail = "the closing triangle is not in the right branch of its S"
            return Rejected(Reason.RECORD_OUTSIDE_BRANCH, Clause.EB_GRAMMAR_6, AtRecord(r), detail)
        after, before = self.after, self.before
        if after[left] == right or before[left] == right or after[left] == left:
            detail = "no surface has so short a loop at this S"
            return Rejected(Reason.LOOP_TOO_SHORT, Clause.EB_GRAMMAR_6, AtRecord(r), detail)
        self.tagged[left] = 0
        first = after[left]
        self.split(gate, right, left)
        return self.take_curve(first, gate, r) if record.kind is Kind.BOUNDARY else None

    def take_curve(self, first: int, gate: int, r: int) -> Rejected | None:
        """The loop cut off by a boundary S is a whole curve. Clause: EB-GRAMMAR-7."""
        edge, length = first, 0
        while True:
            if edge == gate or self.tagged[edge]:
                detail = "the loop that this S cuts off is not free"
                return Rejected(Reason.NOT_A_CURVE, Clause.EB_GRAMMAR_7, AtRecord(r), detail)
            self.curve[edge] = 1
            length += 1
            edge = self.after[edge]
            if edge == first:
                break
        if length < TRIANGLE:
            detail = f"a boundary curve of {length} edges"
            return Rejected(Reason.LOOP_TOO_SHORT, Clause.EB_GRAMMAR_7, AtRecord(r), detail)
        return None

    def close_first_loop(self, part: Part, gate: int) -> Rejected | None:
        """The last loop is the first curve, or fits P; every other edge is glued. EB-GRAMMAR-8."""
        after, curve = self.after, self.curve
        here = AtSymbol(part.start)
        loop = [gate]
        while (edge := after[loop[-1]]) != gate:
            loop.append(edge)
        if part.closed:
            if len(loop) != TRIANGLE:
                detail = f"{len(loop)} edges are left open, P has {TRIANGLE}"
                return Rejected(Reason.LOOP_NOT_CLOSED, Clause.EB_GRAMMAR_8, here, detail)
            for edge, corner in zip(loop, (0, 2, 1), strict=True):
                self.glue(3 * part.face + corner, edge)
        else:
            if len(loop) < TRIANGLE:
                detail = f"a boundary curve of {len(loop)} edges"
                return Rejected(Reason.LOOP_TOO_SHORT, Clause.EB_GRAMMAR_8, here, detail)
            for edge in loop:
                curve[edge] = 1
        for i in range(part.start, part.stop):
            for edge in range(3 * self.outlined.face[i], 3 * self.outlined.face[i] + 3):
                if self.opposite[edge] == BORDER and not curve[edge]:
                    detail = "an edge of its triangle is closed by no other triangle"
                    return Rejected(
                        Reason.LOOP_NOT_CLOSED, Clause.EB_GRAMMAR_8, AtSymbol(i), detail
                    )
        return None
