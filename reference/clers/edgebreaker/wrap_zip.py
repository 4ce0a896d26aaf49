"""Wrap and Zip: glue the dual tree forwards, and zip the border of what is wrapped as one goes.

The tutorial zips by a recursion over stars. Here the border is a linked list and a zip looks at
pairs of neighbours only, so that nothing is recursive and each edge is looked at a few times.
"""

from typing import Final

from clers.complexes.surface import BORDER
from clers.edgebreaker.outline import Outline

OPEN: Final = 0  # a gate, or an edge that waits for the handle data, or the infinite face
FREE: Final = 1  # a closed side of R, L or E: the edge it is one with is older
CREATED: Final = 2  # the left edge of a C, or an edge of P: the edge it is one with is younger


def wrap_and_zip(outlined: Outline) -> list[int]:
    """The opposite corner of each corner, of a stream that is known to be valid.

    Linear. Clauses: EB-WRAP-1, EB-WRAP-2.
    """
    word, record_of = outlined.stream.word, outlined.record_of
    border = _Border(outlined.faces)
    left_of: dict[int, int] = {}  # the closing edge of a record → the left edge of its S
    for part in outlined.parts:
        gates = [border.begin(3 * part.face, part.closed)]
        for i in range(part.start, part.stop):
            tip = 3 * outlined.face[i]
            right, left = tip + 1, tip + 2
            border.attach(tip, gates.pop())
            closing: tuple[int, ...] = ()
            match word[i]:
                case "C":
                    border.kind[left] = CREATED
                    gates.append(right)
                case "R":
                    closing = (right,)
                    gates.append(left)
                case "L":
                    closing = (left,)
                    gates.append(right)
                case "E":
                    closing = (left, right)
                case _:
                    if record_of[i] < 0:
                        gates.append(left)
                    else:
                        left_of[outlined.glue[record_of[i]]] = left
                    gates.append(right)
            for edge in closing:
                if edge in left_of:
                    border.zip(edge, left_of[edge])
                else:
                    border.kind[edge] = FREE
                    border.zip_at(edge)
    return border.opposite


class _Border:
    """The border of the wrapped part: cyclic lists of edges, run as the faces run them."""

    __slots__ = ("after", "before", "kind", "opposite")

    def __init__(self, faces: int) -> None:
        self.opposite: list[int] = [BORDER] * (3 * faces)
        self.after = [0] * (3 * faces + 2)  # two more for the infinite face: its gate and the rest
        self.before = [0] * (3 * faces + 2)
        self.kind = bytearray(3 * faces + 2)

    def link(self, first: int, second: int) -> None:
        self.after[first], self.before[second] = second, first

    def begin(self, root: int, closed: bool) -> int:
        """The border of P, or of the infinite face; the answer is the first gate."""
        gate, rest = (root, root + 1) if closed else (len(self.kind) - 2, len(self.kind) - 1)
        self.link(gate, rest)
        self.link(rest, gate)
        if closed:
            self.link(rest, root + 2)
            self.link(root + 2, gate)
            self.kind[root + 1] = self.kind[root + 2] = CREATED
        return gate

    def attach(self, tip: int, gate: int) -> None:
        """Put the right and the left edge of a new triangle in place of its gate."""
        if gate < len(self.opposite):
            self.opposite[tip], self.opposite[gate] = gate, tip
        before, after = self.before[gate], self.after[gate]
        self.link(before, tip + 1)
        self.link(tip + 1, tip + 2)
        self.link(tip + 2, after)

    def zip_at(self, edge: int) -> None:
        """Zip an edge with the one after it, if they fit. Clause: EB-WRAP-2."""
        after = self.after[edge]
        if self.kind[edge] == FREE and self.kind[after] == CREATED:
            self.zip(edge, after)

    def zip(self, edge: int, other: int) -> None:
        """Make two edges of the border one, and go on where that makes neighbours that fit."""
        todo = [(edge, other)]
        while todo:
            f, e = todo.pop()
            if self.opposite[f] != BORDER or self.opposite[e] != BORDER:
                continue
            self.opposite[f], self.opposite[e] = e, f
            before_f, after_f, before_e, after_e = (
                self.before[f], self.after[f], self.before[e], self.after[e]
            )  # fmt: skip
            for first, second in ((before_f, after_e), (before_e, after_f)):
                if first in (e, f) or second in (e, f):
                    continue
                self.link(first, second)
                if self.kind[first] == FREE and self.kind[second] == CREATED:
                    todo.append((first, second))
