"""Half-edges of a closed surface on its corner table: across, and on about a vertex.

Corner c also names the half-edge from its vertex to the vertex of the next corner: one integer for
a corner, its triangle, and an edge with a direction.
"""

from dataclasses import dataclass

from clers.complexes.surface import Surface


@dataclass(frozen=True, slots=True)
class HalfEdges:
    """Half-edges of a closed surface, 3T entries each. Clause: CODE-TREE-1. Built by `half_edges`.

    `source[h]` is where half-edge h begins; `twin[h]` runs the other way; `turn[h]` is the next one
    about the same vertex: from (x, y) to (x, z) in the face (x, y, z).
    """

    source: tuple[int, ...]
    twin: list[int]
    turn: list[int]
    vertices: int

    def target(self, h: int) -> int:
        """Where half-edge h ends."""
        return self.source[self.twin[h]]

    def around(self, h: int) -> list[int]:
        """All half-edges about the source of h, from h on."""
        found = [h]
        while (h := self.turn[h]) != found[0]:
            found.append(h)
        return found


def half_edges(surface: Surface) -> HalfEdges:
    """The half-edges of a closed surface. Linear. Clause: CODE-TREE-1."""
    twin = [0] * len(surface.opposite)
    turn = [0] * len(twin)
    for t in range(0, len(twin), 3):
        for h, third in ((t, t + 2), (t + 1, t), (t + 2, t + 1)):
            d = surface.opposite[third]
            twin[h] = d - 2 if d % 3 == 2 else d + 1
    for t in range(0, len(twin), 3):
        turn[t], turn[t + 1], turn[t + 2] = twin[t + 2], twin[t], twin[t + 1]
    return HalfEdges(surface.vertex, twin, turn, surface.vertices)
