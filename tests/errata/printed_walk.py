"""Section 8(d) of the tutorial as printed: Algorithms 3, 4 and 5, fault by fault.

Where a statement of the tutorial leaves something open, it is read as chapter 5 does; `as_told` is
the rule of the running text in 8(a).
"""

from dataclasses import dataclass, field

from clers.complexes.surface import BORDER, Corner, Surface, next_corner, previous_corner
from clers.complexes.topology import curve_at

Mark = int | bool
"""What `t.mark` holds: false, true, or the number of an S."""


@dataclass(slots=True)
class Written:
    """The streams that compression writes."""

    word: str = ""
    vertices: list[int] = field(default_factory=list)
    curves: list[list[int]] = field(default_factory=list)
    components_with_boundary: int = 0


@dataclass(slots=True)
class Printed:
    """Algorithms 3 and 4, with one fault at a time.

    `numbers_as_marks`: an S is marked with its number, counted from 0 as in the tutorial's example,
    and a mark is tested as true or false. `every_boundary`: line 29 asks `is_boundary(v)` alone.
    """

    surface: Surface
    numbers_as_marks: bool = False
    every_boundary: bool = False
    out: Written = field(default_factory=Written)
    face_mark: list[Mark] = field(default_factory=list)
    vertex_mark: list[bool] = field(default_factory=list)
    reached: set[int] = field(default_factory=set)
    splits: int = 0

    def compress(self) -> Written:
        """Algorithm 4."""
        surface = self.surface
        self.face_mark = [False] * surface.faces
        on_curve = self._on_curve()
        self.vertex_mark = [v in on_curve for v in range(surface.vertices)]
        for t in range(surface.faces):
            border = [c for c in range(3 * t, 3 * t + 3) if surface.opposite[c] == BORDER]
            if not self.face_mark[t] and border:
                self._write_boundary(Corner(border[0]))
                self._traverse(Corner(border[0]))
                self.out.components_with_boundary += 1
        for t in range(surface.faces):
            if not self.face_mark[t]:
                self.face_mark[t] = True
                for v in surface.vertex[3 * t : 3 * t + 3]:
                    self.out.vertices.append(v)
                    self.vertex_mark[v] = True
                self._traverse(surface.opposite[3 * t])
        return self.out

    def _on_curve(self) -> set[int]:
        vertex, opposite = self.surface.vertex, self.surface.opposite
        return {vertex[next_corner(Corner(c))] for c, d in enumerate(opposite) if d == BORDER}

    def _write_boundary(self, at: Corner) -> None:
        curve = [int(v) for v in curve_at(self.surface, at).vertices]
        self.out.curves.append(curve)
        self.out.vertices += curve
        self.reached.update(curve)

    def _closed(self, gate: Corner) -> bool:
        """`is_boundary(t.right) or t.right.mark`."""
        return gate == BORDER or bool(self.face_mark[gate // 3])

    def _traverse(self, gate: Corner) -> None:
        """Algorithm 3; `until true` is read as its comment, `infinite loop`."""
        surface, on_curve = self.surface, self._on_curve()
        stack: list[Corner] = []
        while gate != BORDER:  # the tutorial has no word for a gate that leads nowhere
            t = gate // 3
            self.face_mark[t] = True
            v = surface.vertex[gate]
            right = surface.opposite[next_corner(gate)]
            left = surface.opposite[previous_corner(gate)]
            if not self.vertex_mark[v]:
                self.out.vertices.append(v)
                self.vertex_mark[v] = True
                self.out.word += "C"
                gate = right
            elif self._closed(right) and self._closed(left):
                self.out.word += "E"
                while stack and self.face_mark[stack[-1] // 3]:
                    stack.pop()
                if not stack:
                    return
                gate = stack.pop()
            elif self._closed(right):
                self.out.word += "R"
                gate = left
            elif self._closed(left):
                self.out.word += "L"
                gate = right
            else:
                self.out.word += "S"
                if self._is_boundary_s(v, on_curve):
                    c = next(
                        c
                        for c in map(Corner, range(3 * surface.faces))
                        if surface.opposite[c] == BORDER and surface.vertex[next_corner(c)] == v
                    )
                    self._write_boundary(c)
                else:
                    stack.append(left)
                if self.numbers_as_marks:
                    self.face_mark[t] = self.splits
                self.splits += 1
                gate = right

    def _is_boundary_s(self, v: int, on_curve: set[int]) -> bool:
        """Line 29."""
        return v in on_curve and (self.every_boundary or v not in self.reached)


def as_told(surface: Surface) -> str:
    """8(a): `if the left triangle is marked, an R … continues on the right`; for closed surfaces.

    `Finally, if both adjacent triangles are marked` is tested before R and L, for it would never be
    tested after them.
    """
    visited = {0}
    marked = set(surface.vertex[:3])
    gate, stack, word = surface.opposite[0], list[Corner](), ""
    while True:
        visited.add(gate // 3)
        v = surface.vertex[gate]
        right = surface.opposite[next_corner(gate)]
        left = surface.opposite[previous_corner(gate)]
        if v not in marked:
            marked.add(v)
            word, gate = word + "C", right
        elif right // 3 in visited and left // 3 in visited:
            word += "E"
            if not stack:
                return word
            gate = stack.pop()
        elif left // 3 in visited:
            word, gate = word + "R", right
        elif right // 3 in visited:
            word, gate = word + "L", left
        else:
            stack.append(left)
            word, gate = word + "S", right
