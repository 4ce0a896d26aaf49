"""A component made ready for a drawing in the plane: a disc with a border.

A sphere is opened at its last face, holes but the first are filled, handles are cut open.
"""

from dataclasses import dataclass

from clers.complexes.surface import Corner, next_corner, previous_corner
from clers.pictures.cut import cut_edges, ends, find
from clers.pictures.lettering import letters
from clers.pictures.table import Table, curves_of, filled, genus_of


@dataclass(frozen=True, slots=True)
class Disc:
    """A triangulated disc made of a component. Clause: TOOL-PICTURE-6.

    `point[c]` is the point at corner c of a table: of the component's own faces first, then of the
    fans in its holes; a vertex on a cut has several points. `points` counts them. `outer` is the
    border, run as the triangles run it. Where the surface was cut, `sides` has for each side of the
    polygon its first place in `outer` and a letter, the same for the two sides of one path.
    `outside` says that the last of the `real` faces has the border's vertices and lies outside.
    """

    point: tuple[int, ...]
    points: int
    real: int
    outer: tuple[int, ...]
    sides: tuple[tuple[int, str], ...] = ()
    outside: bool = False


def disc_of(table: Table) -> Disc:
    """The disc that a component is drawn as. Clause: TOOL-PICTURE-6."""
    curves = curves_of(table)
    if genus_of(table, len(curves)) > 0:
        return _cut_open(filled(table, curves))
    if not curves:
        outer = tuple(table.vertex[:-4:-1])
        return Disc(tuple(table.vertex), table.real_vertices, table.real, outer, outside=True)
    whole = filled(table, curves[1:])
    outer = tuple(table.vertex[next_corner(c)] for c in curves[0])
    return Disc(tuple(whole.vertex), max(whole.vertex) + 1, table.real, outer)


def _cut_open(table: Table) -> Disc:
    """A closed surface with handles, cut along short loops."""
    cut = cut_edges(table)
    point, points = _points(table, cut)
    border = _border(table, cut, point)
    valence: dict[int, int] = {}
    for c in cut:
        tail = ends(table, c)[0]
        valence[tail] = valence.get(tail, 0) + 1
    begins = [i for i, c in enumerate(border) if valence[ends(table, c)[0]] > 2]
    border = border[begins[0] :] + border[: begins[0]]
    begins = [i - begins[0] for i in begins]
    lasts = [border[i - 1] for i in (*begins[1:], 0)]
    letter_of: dict[Corner, str] = {}  # by a side's first edge; its twin ends with the other half
    sides: list[tuple[int, str]] = []
    for i, last in zip(begins, lasts, strict=True):
        twin = letter_of.get(table.opposite[last])
        if twin is None:
            twin = letter_of[border[i]] = letters(len(letter_of))
        sides.append((i, twin))
    outer = tuple(point[next_corner(c)] for c in border)
    return Disc(tuple(point), points, table.real, outer, tuple(sides))


def _points(table: Table, cut: frozenset[Corner]) -> tuple[list[int], int]:
    """Corners that meet across edges that are not cut are at one point."""
    group = list(range(len(table.vertex)))
    for c, d in enumerate(table.opposite):
        corner = Corner(c)
        if c < d and corner not in cut:
            group[find(group, next_corner(corner))] = find(group, previous_corner(d))
            group[find(group, previous_corner(corner))] = find(group, next_corner(d))
    number: dict[int, int] = {}
    point = [number.setdefault(find(group, c), len(number)) for c in range(len(group))]
    return point, len(number)


def _border(table: Table, cut: frozenset[Corner], point: list[int]) -> list[Corner]:
    """The corners opposite to the border's edges, in its order, begun with the lowest."""
    leaving = {point[next_corner(c)]: c for c in cut}
    border = [min(cut)]
    while (c := leaving[point[previous_corner(border[-1])]]) != border[0]:
        border.append(c)
    return border
