"""The forward scan of a stream: components, faces, and which edges the handle data glues.

Everything counts symbols, records, corners; numbers of records are below 2^62 (`Records`).
"""

from typing import Final

from librt.vecs import append, vec
from mypy_extensions import i64

from clers.kernels.flat import minus_ones

C: Final = 67
L: Final = 76
E: Final = 69
R: Final = 82
S: Final = 83
"""The symbols, in ASCII."""

SOUND: Final = 0
EMPTY: Final = 1
UNKNOWN: Final = 2  # at symbol `where`
DISORDERED: Final = 3  # at record `where`
NO_SUCH_SPLIT: Final = 4  # record, and how many S there are
UNFINISHED: Final = 5  # and how many E lack at least
FEW_COMPONENTS: Final = 6  # and how many there are
NO_SUCH_CLOSER: Final = 7  # record, and how many closing symbols there are
OTHER_SIDE: Final = 8  # record, and the symbol
BEFORE_SPLIT: Final = 9  # record, and the symbol
IN_CLOSED_COMPONENT: Final = 10  # record
TWICE: Final = 11  # record
"""What is wrong with a stream, by the forward scan. Clauses: EB-GRAMMAR-1 … EB-GRAMMAR-4."""


class Records:
    """The handle data: for each record its S, its closing symbol, 1 if left, 1 if boundary.

    Clauses: EB-HANDLE-1 … EB-HANDLE-4.
    """

    def __init__(self, s: vec[i64], at: vec[i64], left: vec[i64], boundary: vec[i64]) -> None:
        self.s = s
        self.at = at
        self.left = left
        self.boundary = boundary


class Scan:
    """What the scan tells. `fault` is SOUND, or what is wrong, `where`, and a number to `detail`.

    Of component p: its symbols from `start[p]` up to `start[p + 1]`, its first face `face[p]`. The
    first `with_boundary` components have a boundary; in the others P comes before the face of the
    first symbol. `record_of[i]`: the record of the S at symbol i, or -1; empty if there are none.
    `glue[r]`: for record r the corner opposite to the closing triangle's edge.
    """

    def __init__(self, word: bytes, records: Records, with_boundary: i64) -> None:
        self.word = word
        self.records = records
        self.with_boundary = with_boundary
        self.start = vec[i64]()
        self.face = vec[i64]()
        self.faces: i64 = 0
        self.components: i64 = 0
        self.record_of = vec[i64]()
        self.splits = vec[i64]()
        self.glue = vec[i64]()
        self.fault: i64 = SOUND
        self.where: i64 = 0
        self.detail: i64 = 0

    def blame(self, fault: i64, where: i64, detail: i64) -> bool:
        """Say what is wrong."""
        self.fault = fault
        self.where = where
        self.detail = detail
        return False

    def symbols(self) -> bool:
        """Whether there are symbols, and no others. Clause: EB-GRAMMAR-1."""
        word = self.word
        n: i64 = len(word)
        if n == 0:
            return self.blame(EMPTY, 0, 0)
        i: i64 = 0
        while i < n:
            x: i64 = word[i]
            if x != C and x != R and x != L and x != S and x != E:
                return self.blame(UNKNOWN, i, 0)
            i += 1
        return True

    def records_of_splits(self) -> bool:
        """Give each S its record. Clause: EB-GRAMMAR-2."""
        s = self.records.s
        count: i64 = len(s)
        if count == 0:
            return True
        r: i64 = 1
        while r < count:
            if s[r - 1] >= s[r]:
                return self.blame(DISORDERED, r, 0)
            r += 1
        word = self.word
        n: i64 = len(word)
        i: i64 = 0
        while i < n:
            if word[i] == S:
                self.splits = append(self.splits, i)
            i += 1
        splits: i64 = len(self.splits)
        self.record_of = minus_ones(n)
        r = 0
        while r < count:
            if s[r] < 0 or s[r] >= splits:
                return self.blame(NO_SUCH_SPLIT, r, splits)
            self.record_of[self.splits[s[r]]] = r
            r += 1
        return True

    def cut(self) -> bool:
        """Cut the word into components by the depth of the stack. Clause: EB-GRAMMAR-3."""
        word = self.word
        n: i64 = len(word)
        has_records: bool = len(self.record_of) > 0
        depth: i64 = 1
        start: i64 = 0
        face: i64 = 0
        i: i64 = 0
        while i < n:
            x: i64 = word[i]
            if x == S:
                if not has_records or self.record_of[i] < 0:
                    depth += 1
            elif x == E:
                depth -= 1
                if depth == 0:
                    self.start = append(self.start, start)
                    self.face = append(self.face, face)
                    face += i + 1 - start
                    if self.components >= self.with_boundary:
                        face += 1
                    self.components += 1
                    start = i + 1
                    depth = 1
            i += 1
        self.start = append(self.start, start)
        self.faces = face
        if start < n:
            return self.blame(UNFINISHED, n - 1, depth)
        if self.with_boundary < 0 or self.with_boundary > self.components:
            return self.blame(FEW_COMPONENTS, 0, self.components)
        return True

    def first(self, component: i64) -> i64:
        """The face of a component's first symbol."""
        face: i64 = self.face[component]
        return face if component < self.with_boundary else face + 1

    def close(self) -> bool:
        """The closing edge of each record, each edge once, after its S. Clause: EB-GRAMMAR-4."""
        records = self.records
        count: i64 = len(records.s)
        if count == 0:
            return True
        word = self.word
        n: i64 = len(word)
        closers = vec[i64](capacity=n)
        face_of = vec[i64](capacity=n)
        p: i64 = 0
        while p < self.components:
            i: i64 = self.start[p]
            face: i64 = self.first(p)
            while i < self.start[p + 1]:
                x: i64 = word[i]
                if x in (R, L, E):
                    closers = append(closers, i)
                face_of = append(face_of, face)
                face += 1
                i += 1
            p += 1
        taken = minus_ones(3 * self.faces)
        open_part: i64 = self.start[self.with_boundary]
        r: i64 = 0
        while r < count:
            at: i64 = records.at[r]
            if at < 0 or at >= len(closers):
                return self.blame(NO_SUCH_CLOSER, r, len(closers))
            i = closers[at]
            x = word[i]
            left: i64 = records.left[r]
            if x == (R if left else L):
                return self.blame(OTHER_SIDE, r, i)
            split: i64 = self.splits[records.s[r]]
            if i < split:
                return self.blame(BEFORE_SPLIT, r, i)
            if records.boundary[r] and split >= open_part:
                return self.blame(IN_CLOSED_COMPONENT, r, 0)
            edge: i64 = 3 * face_of[i] + 1 + left
            if taken[edge] >= 0:
                return self.blame(TWICE, r, 0)
            taken[edge] = r
            self.glue = append(self.glue, edge)
            r += 1
        return True

    def run(self) -> bool:
        """Whether the stream is sound as far as a forward scan can tell. Linear."""
        return self.symbols() and self.records_of_splits() and self.cut() and self.close()
