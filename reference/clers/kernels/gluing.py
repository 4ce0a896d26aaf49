"""Spirale Reversi: decode from the last symbol to the first, checking the grammar on the way.

The machine holds the loops that bound the region still to be visited, as linked lists of edges. An
edge is named by the corner opposite to it. In a loop the edges run as the faces run them, the gate
of each loop is on a stack. Undoing a symbol puts its triangle in front of its gate. All numbers are
corners, faces and symbols.
"""

from typing import Final

from librt.vecs import append, vec
from mypy_extensions import i64

from clers.kernels.flat import flags, minus_ones, zeros
from clers.kernels.scan import C, E, L, R, Scan

SHORT_UNDER_C: Final = 12  # symbol
GLUED_UNDER_C: Final = 13  # symbol
OUTSIDE_BRANCH: Final = 14  # record
SHORT_AT_SPLIT: Final = 15  # record
NOT_FREE: Final = 16  # record
SHORT_CURVE: Final = 17  # record, and its length
LEFT_OPEN: Final = 18  # first symbol, and how many edges
SHORT_FIRST_CURVE: Final = 19  # first symbol, and how many edges
NEVER_CLOSED: Final = 20  # symbol
"""What is wrong with a stream, from its end. Clauses: EB-GRAMMAR-5 … EB-GRAMMAR-8."""

TAGGED: Final = 1  # waits to be glued to the left edge of an S
CURVE: Final = 2  # lies on a boundary curve that is complete


class Gluing:
    """The loops of one component at a time; private and mutable, never seen from outside.

    `opposite` is the result. Each edge enters a loop once and leaves it once: linear.
    Clauses: EB-REVERSI-1, EB-REVERSI-2, EB-REVERSI-3.
    """

    def __init__(self, scan: Scan) -> None:
        corners: i64 = 3 * scan.faces
        self.scan = scan
        self.opposite = minus_ones(corners)
        self.after = zeros(corners)
        self.before = zeros(corners)
        self.state = flags(corners)
        self.fault: i64 = 0
        self.where: i64 = 0
        self.detail: i64 = 0
        r: i64 = 0
        while r < len(scan.glue):
            self.state[scan.glue[r]] = TAGGED
            r += 1

    def blame(self, fault: i64, where: i64, detail: i64) -> bool:
        """Say what is wrong."""
        self.fault = fault
        self.where = where
        self.detail = detail
        return False

    def run(self) -> bool:
        """Undo all symbols; whether some surface has this stream, up to EB-GRAMMAR-9."""
        p: i64 = self.scan.components - 1
        while p >= 0:
            if not self.component(p):
                return False
            p -= 1
        return True

    def component(self, p: i64) -> bool:
        """Undo the symbols of one component, then close its first loop."""
        scan = self.scan
        word = scan.word
        after = self.after
        before = self.before
        opposite = self.opposite
        has_records: bool = len(scan.record_of) > 0
        gates = vec[i64]()
        ends = vec[i64]()  # the face of the last symbol of the branch behind each gate
        height: i64 = 0
        start: i64 = scan.start[p]
        i: i64 = scan.start[p + 1] - 1
        face: i64 = scan.first(p) + i - start
        while i >= start:
            gate: i64 = 3 * face
            right: i64 = gate + 1
            left: i64 = gate + 2
            x: i64 = word[i]
            if x == E:
                after[gate] = right
                after[right] = left
                after[left] = gate
                before[right] = gate
                before[left] = right
                before[gate] = left
                if height < len(gates):
                    gates[height] = gate
                    ends[height] = face
                else:
                    gates = append(gates, gate)
                    ends = append(ends, face)
                height += 1
                i -= 1
                face -= 1
                continue
            beyond: i64 = gates[height - 1]
            if x in (R, L):
                first: i64 = gate if x == R else left
                second: i64 = right if x == R else gate
                closed: i64 = left if x == R else right
                opposite[closed] = beyond
                opposite[beyond] = closed
                previous: i64 = before[beyond]
                following: i64 = after[beyond]
                after[previous] = first
                before[first] = previous
                after[first] = second
                before[second] = first
                after[second] = following
                before[following] = second
            elif x == C:
                last: i64 = before[beyond]
                previous = before[last]
                if last == beyond or previous == beyond or before[previous] == beyond:
                    return self.blame(SHORT_UNDER_C, i, 0)
                if self.state[last] & TAGGED:
                    return self.blame(GLUED_UNDER_C, i, 0)
                opposite[right] = beyond
                opposite[beyond] = right
                opposite[left] = last
                opposite[last] = left
                following = after[beyond]
                after[previous] = gate
                before[following] = gate
                before[gate] = previous
                after[gate] = following
            else:
                r: i64 = scan.record_of[i] if has_records else -1
                if r < 0:
                    height -= 1
                    self.split(gate, beyond, gates[height - 1])
                elif not self.undo_recorded(r, gate, beyond, ends[height - 1]):
                    return False
            gates[height - 1] = gate
            i -= 1
            face -= 1
        return self.close_first_loop(p, gates[0])

    def split(self, gate: i64, right: i64, left: i64) -> None:
        """S: glue both sides; join the loops of the two edges, or cut their common loop in two."""
        after = self.after
        before = self.before
        self.opposite[gate + 1] = right
        self.opposite[right] = gate + 1
        self.opposite[gate + 2] = left
        self.opposite[left] = gate + 2
        before_left: i64 = before[left]
        after_left: i64 = after[left]
        before_right: i64 = before[right]
        after_right: i64 = after[right]
        after[before_left] = gate
        before[gate] = before_left
        after[gate] = after_right
        before[after_right] = gate
        after[before_right] = after_left
        before[after_left] = before_right

    def undo_recorded(self, r: i64, gate: i64, right: i64, end: i64) -> bool:
        """An S with a record: its left edge is tagged in a loop. Clauses: EB-GRAMMAR-6, -7."""
        left: i64 = self.scan.glue[r]
        if left // 3 > end:
            return self.blame(OUTSIDE_BRANCH, r, 0)
        after = self.after
        if after[left] == right or self.before[left] == right or after[left] == left:
            return self.blame(SHORT_AT_SPLIT, r, 0)
        self.state[left] -= TAGGED
        first: i64 = after[left]
        self.split(gate, right, left)
        if self.scan.records.boundary[r]:
            return self.take_curve(first, gate, r)
        return True

    def take_curve(self, first: i64, gate: i64, r: i64) -> bool:
        """The loop cut off by a boundary S is a whole curve. Clause: EB-GRAMMAR-7."""
        edge: i64 = first
        length: i64 = 0
        while True:
            if edge == gate or self.state[edge] & TAGGED:
                return self.blame(NOT_FREE, r, 0)
            self.state[edge] = CURVE
            length += 1
            edge = self.after[edge]
            if edge == first:
                break
        return length >= 3 or self.blame(SHORT_CURVE, r, length)

    def close_first_loop(self, p: i64, gate: i64) -> bool:
        """The last loop is the first curve, or fits P; every other edge is glued. EB-GRAMMAR-8."""
        scan = self.scan
        opposite = self.opposite
        start: i64 = scan.start[p]
        closed: bool = p >= scan.with_boundary
        length: i64 = 1
        edge: i64 = self.after[gate]
        while edge != gate:
            length += 1
            edge = self.after[edge]
        if closed:
            if length != 3:
                return self.blame(LEFT_OPEN, start, length)
            root: i64 = 3 * scan.face[p]
            second: i64 = self.after[gate]
            third: i64 = self.after[second]
            opposite[root] = gate
            opposite[gate] = root
            opposite[root + 2] = second
            opposite[second] = root + 2
            opposite[root + 1] = third
            opposite[third] = root + 1
        else:
            if length < 3:
                return self.blame(SHORT_FIRST_CURVE, start, length)
            while self.state[edge] != CURVE:
                self.state[edge] = CURVE
                edge = self.after[edge]
        edge = 3 * scan.first(p)
        end: i64 = edge + 3 * (scan.start[p + 1] - start)
        while edge < end:
            if opposite[edge] < 0 and self.state[edge] != CURVE:
                return self.blame(NEVER_CLOSED, start + edge // 3 - scan.first(p), 0)
            edge += 1
        return True
