"""The tree of a rooted sphere: half-edges, their orientation, and the word of the tree.

Corner c also names the half-edge from its vertex to the vertex of the next corner. All numbers are
half-edges, vertices, or how many of them there are.
"""

from typing import Final

from librt.strings import BytesWriter
from librt.vecs import append, vec
from mypy_extensions import i64, u8

from clers.kernels.flat import flags, minus_ones, zeros

OUT: Final = 1
CUT: Final = 2
UP: Final = 3
"""What is known of a half-edge: directed so, cut off by the tree's word, or gone up by it."""


class Shelling:
    """The path that bounds what is left, as a linked list of vertices; private and mutable.

    `out[h]`: OUT if the edge of half-edge h is directed so. From h = (x, y) with the third vertex z
    the half-edge (y, x) is the one after `opposite` of (z, x), and the next about x is the one
    after `opposite` of (y, z). Linear. CODE-TREE-1, CODE-TREE-2, CODE-TREE-3.
    """

    def __init__(self, source: vec[i64], opposite: vec[i64], vertices: i64) -> None:
        self.source = source
        self.opposite = opposite
        self.out = flags(len(source))
        self.before = minus_ones(vertices)
        self.after = minus_ones(vertices)
        self.to_before = minus_ones(vertices)  # the half-edge of a vertex to the one before
        self.on_path = flags(vertices)
        self.new = flags(vertices)
        self.chords = zeros(vertices)
        self.todo = vec[i64]()
        self.height: i64 = 0

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
        self.to_before[v0] = turned(self.opposite, 0)
        self.to_before[v1] = 0
        self.on_path[v0] = 1
        self.on_path[v1] = 1
        self.on_path[v2] = 1
        self.push(v0)
        before = self.before
        after = self.after
        on_path = self.on_path
        chords = self.chords
        while self.height > 0:
            self.height -= 1
            x: i64 = self.todo[self.height]
            if on_path[x] != 0 and chords[x] == 0 and before[x] >= 0 and after[x] >= 0:
                self.leave(x)

    def leave(self, x: i64) -> None:
        """Take x away; the part of the path that is touched is looked at next."""
        opposite = self.opposite
        source = self.source
        before = self.before
        after = self.after
        to_before = self.to_before
        out = self.out
        low: i64 = before[x]
        high: i64 = after[x]
        self.on_path[x] = 0
        first: i64 = self.height
        self.push(low)
        previous: i64 = low
        start: i64 = to_before[x]
        h: i64 = start
        while True:
            d: i64 = opposite[h]
            beyond: i64 = d - 2 if d % 3 == 2 else d + 1
            y: i64 = source[beyond]
            before[y] = previous
            after[previous] = y
            to_before[y] = beyond
            self.push(y)
            previous = y
            d = opposite[h - 2 if h % 3 == 2 else h + 1]
            h = d - 2 if d % 3 == 2 else d + 1
            if y == high:
                break
            d = opposite[h - 1 if h % 3 else h + 2]
            out[d - 2 if d % 3 == 2 else d + 1] = OUT
        if x != source[0]:
            out[start] = OUT
            out[h] = OUT
        last: i64 = self.height - 1
        if last == first + 1:
            self.chords[low] -= 1
            self.chords[high] -= 1
            return
        todo = self.todo
        k: i64 = first + 1
        while k < last:
            self.on_path[todo[k]] = 1
            self.new[todo[k]] = 1
            k += 1
        k = first + 1
        while k < last:
            self.count_chords(todo[k])
            k += 1
        k = first + 1
        while k < last:
            self.new[todo[k]] = 0
            k += 1

    def count_chords(self, y: i64) -> None:
        """Count the edges from a new vertex of the path to others of it, not beside it."""
        opposite = self.opposite
        source = self.source
        on_path = self.on_path
        before: i64 = self.before[y]
        after: i64 = self.after[y]
        start: i64 = self.to_before[y]
        h: i64 = start
        while True:
            on: i64 = h - 2 if h % 3 == 2 else h + 1
            z: i64 = source[on]
            if on_path[z] != 0 and z != before and z != after:
                self.chords[y] += 1
                if self.new[z] == 0:
                    self.chords[z] += 1
            d: i64 = opposite[on]
            h = d - 2 if d % 3 == 2 else d + 1
            if h == start:
                return


def turned(opposite: vec[i64], h: i64) -> i64:
    """The next half-edge about the same vertex."""
    d: i64 = opposite[h - 2 if h % 3 == 2 else h + 1]
    return d - 2 if d % 3 == 2 else d + 1


def oriented(source: vec[i64], opposite: vec[i64], vertices: i64) -> vec[u8]:
    """For each half-edge OUT if its edge is directed so, else 0; the root is corner 0."""
    shelling = Shelling(source, opposite, vertices)
    shelling.run()
    return shelling.out


def word(opposite: vec[i64], out: vec[u8]) -> bytes:
    """The word of the tree, a bit in each byte: once about the tree. Linear. CODE-TREE-4.

    `out` is what `oriented` gives, and used up.
    """
    found = BytesWriter()
    d: i64 = opposite[1]
    h: i64 = turned(opposite, d - 2 if d % 3 == 2 else d + 1)
    while h != 0:
        known: u8 = out[h]
        if known != CUT:
            d = opposite[h - 1 if h % 3 else h + 2]
            twin: i64 = d - 2 if d % 3 == 2 else d + 1
            if known == UP:
                found.append(0)
                h = twin
            elif known == OUT:
                found.append(0)
                out[twin] = CUT
            else:
                found.append(1)
                h = twin
                out[h] = UP
        d = opposite[h - 2 if h % 3 == 2 else h + 1]
        h = d - 2 if d % 3 == 2 else d + 1
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
