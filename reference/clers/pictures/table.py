"""One component as a corner table that can be extended: its holes are filled with fans."""

from dataclasses import dataclass

from clers.complexes.border import border_from
from clers.complexes.surface import BORDER, Corner, Surface, next_corner, previous_corner


@dataclass(frozen=True, slots=True)
class Table:
    """A corner table with its own numbers: of `faces` faces the first `real` are the component's.

    The others are fans around vertices from `real_vertices` on, one for each hole that was filled.
    """

    vertex: list[int]
    opposite: list[Corner]
    real: int
    real_vertices: int

    @property
    def faces(self) -> int:
        """Those of the component and those of the fans."""
        return len(self.vertex) // 3


def table_of(surface: Surface, tips: tuple[Corner, ...]) -> Table:
    """The faces with these tips, each from its tip on; a component, its vertices in their order."""
    number_of: dict[Corner, Corner] = {}
    for tip in tips:
        for c in (tip, next_corner(tip), previous_corner(tip)):
            number_of[c] = Corner(len(number_of))
    used = sorted({surface.vertex[c] for c in number_of})
    vertex_of = {v: i for i, v in enumerate(used)}
    vertex = [vertex_of[surface.vertex[c]] for c in number_of]
    opposite = [number_of.get(surface.opposite[c], BORDER) for c in number_of]
    return Table(vertex, opposite, len(tips), len(used))


def curves_of(table: Table) -> list[list[Corner]]:
    """The boundary curves, each as the corners opposite to its edges, by their lowest corners."""
    done: set[Corner] = set()
    found: list[list[Corner]] = []
    for c, across in enumerate(table.opposite):
        if across == BORDER and c not in done:
            leaving = border_from(table.opposite, next_corner(Corner(c)))
            found.append([previous_corner(corner) for corner in leaving])
            done.update(found[-1])
    return found


def genus_of(table: Table, curves: int) -> int:
    """By Euler's formula, for a table that was not filled yet."""
    border = table.opposite.count(BORDER)
    edges = (len(table.opposite) + border) // 2
    return (2 - curves - (table.real_vertices - edges + table.real)) // 2


def filled(table: Table, curves: list[list[Corner]]) -> Table:
    """The same with a fan of triangles in each of these holes, around a new vertex."""
    vertex, opposite = list(table.vertex), list(table.opposite)
    for curve in curves:
        centre = max(vertex) + 1
        first = len(vertex)
        for i, c in enumerate(curve):
            after, before = (i + 1) % len(curve), (i - 1) % len(curve)
            tail, head = vertex[next_corner(c)], vertex[previous_corner(c)]
            vertex += (centre, head, tail)
            opposite[c] = Corner(first + 3 * i)
            opposite += (c, Corner(first + 3 * before + 2), Corner(first + 3 * after + 1))
    return Table(vertex, opposite, table.real, table.real_vertices)
