"""From glued triangles to a surface: name the vertices in the order of their creation.

All numbers are corners and vertices.
"""

from librt.vecs import vec
from mypy_extensions import i64

from clers.kernels.flat import minus_ones
from clers.kernels.scan import C, S, Scan
from clers.kernels.walk import outgoing


class Naming:
    """Names of vertices at corners, -1 where there is none yet; private and mutable."""

    def __init__(self, opposite: vec[i64]) -> None:
        self.opposite = opposite
        self.vertex = minus_ones(len(opposite))
        self.count: i64 = 0

    def name(self, corner: i64) -> None:
        """Give all corners around one vertex the next name, unless they have one."""
        vertex = self.vertex
        if vertex[corner] >= 0:
            return
        opposite = self.opposite
        name: i64 = self.count
        self.count = name + 1
        c: i64 = corner
        while vertex[c] < 0:
            vertex[c] = name
            d: i64 = opposite[c - 2 if c % 3 == 2 else c + 1]
            if d < 0:
                break
            c = d - 2 if d % 3 == 2 else d + 1
        c = corner
        while True:
            d = opposite[c - 1 if c % 3 else c + 2]
            if d < 0:
                return
            c = d - 1 if d % 3 else d + 2
            if vertex[c] >= 0:
                return
            vertex[c] = name

    def curve(self, corner: i64) -> None:
        """Name the vertices of a curve, from a corner's vertex on. Clause: EB-ORDER-1."""
        opposite = self.opposite
        c: i64 = outgoing(opposite, corner)
        start: i64 = c
        while True:
            self.name(c)
            c = outgoing(opposite, c - 2 if c % 3 == 2 else c + 1)
            if c == start:
                return


def named(scan: Scan, opposite: vec[i64]) -> Naming:
    """The vertex at each corner, in the order in which the encoder met them. EB-ORDER-1. Linear."""
    naming = Naming(opposite)
    word = scan.word
    has_records: bool = len(scan.record_of) > 0
    p: i64 = 0
    while p < scan.components:
        i: i64 = scan.start[p]
        end: i64 = scan.start[p + 1]
        tip: i64 = 3 * scan.first(p)
        if p < scan.with_boundary:
            naming.curve(tip + 1)
        else:
            root: i64 = 3 * scan.face[p]
            naming.name(root)
            naming.name(root + 1)
            naming.name(root + 2)
        while i < end:
            x: i64 = word[i]
            if x == C:
                naming.name(tip)
            elif x == S and has_records:
                r: i64 = scan.record_of[i]
                if r >= 0 and scan.records.boundary[r]:
                    naming.curve(tip)
            tip += 3
            i += 1
        p += 1
    return naming
