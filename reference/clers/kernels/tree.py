"""The tree of a rooted sphere: half-edges, their orientation, and the word of the tree.

Corner c also names the half-edge from its vertex to the vertex of the next corner. All numbers are
half-edges, vertices, or how many of them there are.
"""

from typing import Final

from librt.strings import BytesWriter
from librt.vecs import append, vec
from mypy_extensions import i64

from clers.kernels.flat import minus_ones, zeros

CUT: Final = 1
UP: Final = 2


def twins(opposite: vec[i64]) -> vec[i64]:
    """For each half-edge the one that runs the other way, on a closed surface. CODE-TREE-1."""
    corners: i64 = len(opposite)
    twin = zeros(corners)
    h: i64 = 0
    while h < corners:
        d: i64 = opposite[h - 1 if h % 3 else h + 2]
        twin[h] = d - 2 if d % 3 == 2 else d + 1
        h += 1
    return twin


class Shelling:
    """The path that bounds what is left, as a linked list of vertices; private and mutable.

    `out[h]`: whether the edge of half-edge h is directed so. Linear. CODE-TREE-2, CODE-TREE-3.
    """

    def __init__(self, source: vec[i64], twin: vec[i64], vertices: i64) -> None:
        self.source = source
        self.twin = twin
        self.out = zeros(len(source))
        self.before = minus_ones(vertices)
        self.after = minus_ones(vertices)
        self.to_before = minus_ones(vertices)  # the half-edge of a vertex to the one before
        self.on_path = zeros(vertices)
        self.new = zeros(vertices)
        self.chords = zeros(vertices)
        self.todo = vec[i64]()
        self.height: i64 = 0

    def turn(self, h: i64) -> i64:
        """The next half-edge about the same vertex."""
        return self.twin[h + 2 if h % 3 == 0 else h - 1]

    def push(self, v: i64) -> None:
        """Put a vertex on the stack of those to look at."""
        if self.height < len(self.todo):
            self.todo[self.height] = v
        else:
            self.todo = append(self.todo, v)
        self.height += 1

    def run(self) -> None:
        """Take away every vertex that can be, the nearest to v1 first."""
        v0: i64 = self.source[0]
        v1: i64 = self.source[1]
        v2: i64 = self.source[2]
        self.before[v0] = v2
        self.before[v1] = v0
        self.after[v0] = v1
        self.after[v2] = v0
        self.to_before[v0] = self.turn(0)
        self.to_before[v1] = 0
        self.on_path[v0] = 1
        self.on_path[v1] = 1
        self.on_path[v2] = 1
        self.push(v0)
        while self.height > 0:
            self.height -= 1
            x: i64 = self.todo[self.height]
            inside: bool = self.before[x] >= 0 and self.after[x] >= 0
            if inside and self.on_path[x] and self.chords[x] == 0:
                self.leave(x)

    def leave(self, x: i64) -> None:
        """Take x away; the part of the path that is touched is looked at next."""
        low: i64 = self.before[x]
        high: i64 = self.after[x]
        self.on_path[x] = 0
        first: i64 = self.height
        self.push(low)
        previous: i64 = low
        start: i64 = self.to_before[x]
        h: i64 = start
        while True:
            beyond: i64 = self.twin[h - 2 if h % 3 == 2 else h + 1]
            y: i64 = self.source[beyond]
            self.before[y] = previous
            self.after[previous] = y
            self.to_before[y] = beyond
            self.push(y)
            previous = y
            h = self.turn(h)
            if y == high:
                break
            self.out[self.twin[h]] = 1
        if x != self.source[0]:
            self.out[start] = 1
            self.out[h] = 1
        last: i64 = self.height - 1
        if last == first + 1:
            self.chords[low] -= 1
            self.chords[high] -= 1
            return
        k: i64 = first + 1
        while k < last:
            self.on_path[self.todo[k]] = 1
            self.new[self.todo[k]] = 1
            k += 1
        k = first + 1
        while k < last:
            self.count_chords(self.todo[k])
            k += 1
        k = first + 1
        while k < last:
            self.new[self.todo[k]] = 0
            k += 1

    def count_chords(self, y: i64) -> None:
        """Count the edges from a new vertex of the path to others of it, not beside it."""
        start: i64 = self.to_before[y]
        h: i64 = start
        while True:
            z: i64 = self.source[self.twin[h]]
            if self.on_path[z] and z != self.before[y] and z != self.after[y]:
                self.chords[y] += 1
                self.chords[z] += 1 - self.new[z]
            h = self.turn(h)
            if h == start:
                return


def oriented(source: vec[i64], twin: vec[i64], vertices: i64) -> vec[i64]:
    """For each half-edge 1 if its edge is directed so, else 0; the root is corner 0."""
    shelling = Shelling(source, twin, vertices)
    shelling.run()
    return shelling.out


def word(twin: vec[i64], out: vec[i64]) -> bytes:
    """The word of the tree, a bit in each byte: once about the tree. Linear. CODE-TREE-4."""
    met = zeros(len(twin))
    found = BytesWriter()
    h: i64 = twin[twin[2] - 1 if twin[2] % 3 else twin[2] + 2]
    while h != 0:
        if met[h] == UP:
            found.append(0)
            h = twin[h]
        elif met[h] == CUT:
            pass
        elif out[h]:
            found.append(0)
            met[h] = CUT
            met[twin[h]] = CUT
        else:
            found.append(1)
            h = twin[h]
            met[h] = UP
        h = twin[h - 1 if h % 3 else h + 2]
    return found.getvalue()


LEAF: Final = -1
AT_ROOT: Final = -1
UNFINISHED: Final = -2
CLOSED_ROOT: Final = -3


class Closure:
    """The string about a tree, closed by a stack; private and mutable. CODE-TREE-5 … -8.

    `faces`: the vertices of the faces, three for each, the root face first. `fault`: 0, or what is
    wrong: AT_ROOT at bit `where`, UNFINISHED, CLOSED_ROOT. `vertices`, `open`: of the tree, and how
    many of them are not finished.
    """

    def __init__(self) -> None:
        self.faces = vec[i64]()
        self.starts = vec[i64]()
        self.ends = vec[i64]()
        self.height: i64 = 0
        self.sides: i64 = 0
        self.fault: i64 = 0
        self.where: i64 = 0
        self.vertices: i64 = 1
        self.open: i64 = 0

    def face(self, a: i64, b: i64, c: i64) -> None:
        """One face more."""
        self.faces = append(self.faces, a)
        self.faces = append(self.faces, b)
        self.faces = append(self.faces, c)

    def side(self, start: i64, end: i64) -> None:
        """The next side of the string: put on the stack, and closed as often as can be."""
        self.sides += 1
        while self.height > 1 and end != LEAF:
            h: i64 = self.height
            if self.ends[h - 1] == LEAF or self.ends[h - 2] != LEAF:
                break
            middle: i64 = self.ends[h - 1]
            start = self.starts[h - 2]
            self.face(start, end, middle)
            self.height = h - 2
        if self.height < len(self.starts):
            self.starts[self.height] = start
            self.ends[self.height] = end
        else:
            self.starts = append(self.starts, start)
            self.ends = append(self.ends, end)
        self.height += 1

    def run(self, bits: bytes) -> bool:
        """Whether the bits, one in each byte, are the word of a tree. Linear."""
        n: i64 = len(bits)
        path = vec[i64]([0])
        zeros_at = vec[i64]([0])
        height: i64 = 1
        outer: i64 = 1
        i: i64 = 0
        while i < n:
            outer += bits[i]
            i += 1
        self.face(0, outer, outer + 1)
        self.side(0, LEAF)
        i = 0
        while i < n:
            x: i64 = path[height - 1]
            if bits[i]:
                y: i64 = self.vertices
                self.vertices += 1
                zeros_at = append(zeros_at, 0)
                if height < len(path):
                    path[height] = y
                else:
                    path = append(path, y)
                height += 1
                self.side(x, y)
            elif x == 0:
                self.fault = AT_ROOT
                self.where = i
                return False
            else:
                zeros_at[x] += 1
                if zeros_at[x] > 2:
                    height -= 1
                    self.side(x, path[height - 1])
                else:
                    self.side(x, LEAF)
            i += 1
        self.open = height - 1
        if height > 1 or self.vertices == 1:
            self.fault = UNFINISHED
            return False
        self.side(0, LEAF)
        if self.ends[0] != LEAF:
            self.fault = CLOSED_ROOT
            return False
        self.join(outer)
        return True

    def join(self, first: i64) -> None:
        """The faces at v1 and v2: leaves up to a vertex with two go to v2. Clause: CODE-TREE-8."""
        outer: i64 = first + 1
        k: i64 = 0
        while k < self.height - 1:
            x: i64 = self.starts[k]
            y: i64 = self.ends[k]
            if y != LEAF:
                self.face(x, outer, y)
            elif self.ends[k + 1] == LEAF:
                self.face(x, outer, first)
                outer = first
            k += 1
