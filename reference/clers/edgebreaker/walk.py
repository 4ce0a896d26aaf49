"""The definition of encoding: the tutorial's rules on sets of triangles and pairs of vertices.

No corner table, no marks: a gate is a directed edge, what is visited is a set, a loop is looked for
when it is needed. Quadratic at worst, and meant to be read beside section 5.4 of the specification.
"""

from dataclasses import dataclass, field

from clers.complexes.surface import Surface
from clers.edgebreaker.stream import Kind, Record, Side, Stream

Edge = tuple[int, int]
Tipped = tuple[int, int, int]  # apex, left end, right end


@dataclass(slots=True)
class _Seen:
    """All that the walk has seen; the rules read and extend it."""

    apex: dict[Edge, int]  # directed edge of a face → the face's third vertex
    border_after: dict[int, int]  # vertex on a curve → the next one on it
    entered: set[frozenset[int]] = field(default_factory=set)
    reached: set[int] = field(default_factory=set)
    word: str = ""
    faces: list[Tipped] = field(default_factory=list)
    vertices: list[int] = field(default_factory=list)
    left_edges: list[Edge] = field(default_factory=list)  # of each S, as its triangle runs it
    reached_by_s: list[bool] = field(default_factory=list)
    records: list[Record] = field(default_factory=list)

    def closed(self, edge: Edge) -> bool:
        """EB-GATE-2, for an edge as its triangle runs it."""
        tail, head = edge
        across = self.apex.get((head, tail))
        return across is None or frozenset((tail, head, across)) in self.entered

    def reach(self, vertices: list[int]) -> None:
        """Mark vertices and number them. Clause: EB-ORDER-1."""
        self.reached.update(vertices)
        self.vertices += vertices

    def curve(self, start: int) -> list[int]:
        """The curve through a vertex, from it on. Clause: EB-ORDER-2."""
        found = [start]
        while (v := self.border_after[found[-1]]) != start:
            found.append(v)
        return found


def encode_by_definition(surface: Surface) -> tuple[Stream, tuple[int, ...], tuple[Tipped, ...]]:
    """The stream, the vertices in order, and the faces in order, tips first.

    Clauses: EB-GATE-1, EB-GATE-2, EB-COMPONENT-1 … EB-COMPONENT-4, EB-TRAVERSE-1 … EB-TRAVERSE-7,
    EB-HANDLE-1 … EB-HANDLE-5, EB-ORDER-1 … EB-ORDER-3.
    """
    triangles = list(surface.triangles())
    apex: dict[Edge, int] = {}
    for a, b, c in triangles:
        apex.update({(a, b): c, (b, c): a, (c, a): b})
    border_after: dict[int, int] = {t: h for t, h in apex if (h, t) not in apex}
    seen = _Seen(apex, border_after)
    with_boundary = 0
    for a, b, c in triangles:
        for gate in ((b, c), (c, a), (a, b)):
            if gate[::-1] not in apex and frozenset((a, b, c)) not in seen.entered:
                seen.reach(seen.curve(gate[0]))
                _traverse(seen, gate)
                with_boundary += 1
    for a, b, c in triangles:
        if frozenset((a, b, c)) not in seen.entered:
            seen.entered.add(frozenset((a, b, c)))
            seen.faces.append((a, b, c))
            seen.reach([a, b, c])
            _traverse(seen, (c, b))
    records = tuple(sorted(seen.records, key=lambda record: record.s))
    return Stream(seen.word, records, with_boundary), tuple(seen.vertices), tuple(seen.faces)


def _traverse(seen: _Seen, gate: Edge) -> None:
    """Section 5.4, rule by rule."""
    stack: list[Edge] = []
    while True:
        a, b = gate
        v = seen.apex[gate]
        right, left = (b, v), (v, a)
        seen.entered.add(frozenset((a, b, v)))
        seen.faces.append((v, a, b))
        if v not in seen.reached and v not in seen.border_after:
            seen.word += "C"
            seen.reach([v])
            gate = (v, b)
        elif seen.closed(right) and seen.closed(left):
            _close(seen, right, left)
            seen.word += "E"
            while stack and frozenset((*stack[-1], seen.apex[stack[-1]])) in seen.entered:
                stack.pop()
            if not stack:
                return
            gate = stack.pop()
        elif seen.closed(right):
            _close(seen, right, None)
            seen.word += "R"
            gate = (a, v)
        elif seen.closed(left):
            _close(seen, None, left)
            seen.word += "L"
            gate = (v, b)
        else:
            seen.word += "S"
            seen.left_edges.append(left)
            seen.reached_by_s.append(v not in seen.reached)
            if v not in seen.reached:
                seen.reach(seen.curve(v))
            stack.append((a, v))
            gate = (v, b)


def _close(seen: _Seen, right: Edge | None, left: Edge | None) -> None:
    """Section 5.5: is a closed side of this triangle the left edge of an S before it?"""
    at = sum(x in "RLE" for x in seen.word)
    for side, edge in ((Side.RIGHT, right), (Side.LEFT, left)):
        if edge is not None and edge[::-1] in seen.left_edges:
            s = seen.left_edges.index(edge[::-1])
            kind = Kind.BOUNDARY if seen.reached_by_s[s] else Kind.HANDLE
            seen.records.append(Record(kind, s, at, side))
