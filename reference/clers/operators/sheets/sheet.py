"""Sheets: oriented surfaces under construction, as sets of triangles, polygons and loops."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Final

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Rejected
from clers.conventions.where import AtSimplex, AtVertex, Where

Cell = tuple[int, ...]
"""A cyclic list of vertices, begun where that makes it least."""

Side = tuple[int, int]
"""A directed edge, from its tail to its head."""

SHORTEST_RING: Final = 3
SHORTEST_LOOP: Final = 2


@dataclass(frozen=True, slots=True)
class Sheet:
    """Triangles, infinite faces and loops, each cell begun where it is least. OPER-SHEET-1.

    Made by `sheet_of` and by operators; equal exactly where the sets of cyclic lists are equal.
    """

    triangles: frozenset[Cell] = frozenset()
    polygons: frozenset[Cell] = frozenset()
    loops: frozenset[Cell] = frozenset()


EMPTY: Final = Sheet()


def turned(cell: Iterable[int]) -> Cell:
    """The cyclic list begun where that makes it least. Clause: OPER-SHEET-1."""
    once = tuple(cell)
    least = min(once)
    return min(once[i:] + once[:i] for i, v in enumerate(once) if v == least)


def sheet_of(
    triangles: Iterable[Iterable[int]],
    loops: Iterable[Iterable[int]],
    polygons: Iterable[Iterable[int]] = (),
) -> Sheet:
    """Cyclic lists, begun anywhere, as a sheet; nothing is checked. Clause: OPER-SHEET-1."""
    sets = (frozenset(map(turned, cells)) for cells in (triangles, polygons, loops))
    return Sheet(*sets)


def sides_of(cell: Cell) -> Iterator[Side]:
    """The sides that a cyclic list runs, in order."""
    return zip(cell, cell[1:] + cell[:1], strict=True)


def faces_run(sheet: Sheet) -> Iterator[Cell]:
    """Triangles and polygons as they run their sides: polygons turned over. OPER-SHEET-1."""
    yield from sheet.triangles
    yield from (polygon[::-1] for polygon in sheet.polygons)


def cells_run(sheet: Sheet) -> Iterator[Cell]:
    """All cells as they run their sides. Clause: OPER-SHEET-1."""
    yield from faces_run(sheet)
    yield from sheet.loops


def sides(sheet: Sheet) -> Iterator[Side]:
    """Every side, as often as it is run. Clause: OPER-SHEET-1."""
    return (side for cell in cells_run(sheet) for side in sides_of(cell))


def vertices(sheet: Sheet) -> frozenset[int]:
    """The vertices of a sheet: those on its cells. Clause: OPER-SHEET-3."""
    return frozenset(v for cell in cells_run(sheet) for v in cell)


def followers(sheet: Sheet) -> Mapping[Side, Side]:
    """For each side the one that follows it in its cell."""
    return {
        side: then
        for cell in cells_run(sheet)
        for side, then in zip(sides_of(cell), sides_of((*cell[1:], cell[0])), strict=True)
    }


def component(sheet: Sheet) -> Mapping[int, int]:
    """The lowest vertex of each vertex's component. Clause: OPER-SHEET-3."""
    near: dict[int, set[int]] = {v: set() for v in vertices(sheet)}
    for a, b in sides(sheet):
        near[a].add(b)
    lowest: dict[int, int] = {}
    for v in sorted(near):
        waiting = [v] if v not in lowest else []
        while waiting:
            w = waiting.pop()
            lowest[w] = v
            waiting.extend(near[w] - lowest.keys())
    return lowest


def fault(sheet: Sheet) -> Rejected | None:
    """Why this is no sheet; None exactly for sheets. Clauses: OPER-SHEET-1, OPER-SHEET-2."""
    return _bad_cells(sheet) or _bad_sides(sheet) or _bad_stars(sheet)


def _no_sheet(reason: Reason, where: Where, detail: str) -> Rejected:
    return Rejected(reason, Clause.OPER_SHEET_1, where, detail)


def simplex(*names: int) -> AtSimplex:
    """The simplex on these vertices, to be blamed."""
    return AtSimplex(tuple(sorted(set(names))))


def _bad_cells(sheet: Sheet) -> Rejected | None:
    for cell in sorted(cells_run(sheet)):
        if any(v < 0 for v in cell):
            return _no_sheet(Reason.INDEX_OUT_OF_RANGE, simplex(*cell), "a negative vertex")
    for cell in sorted(faces_run(sheet)):
        if len(set(cell)) < len(cell):
            return _no_sheet(Reason.REPEATED_VERTEX, simplex(*cell), "a vertex twice in a face")
        if len(cell) < SHORTEST_RING:
            return _no_sheet(Reason.LOOP_TOO_SHORT, simplex(*cell), "a face of fewer edges")
    for cell in sorted(sheet.loops):
        if len(cell) < SHORTEST_LOOP:
            return _no_sheet(Reason.LOOP_TOO_SHORT, simplex(*cell), "a loop of one edge")
    times = Counter(frozenset(triangle) for triangle in sheet.triangles)
    for triangle in sorted(sheet.triangles):
        if times[frozenset(triangle)] > 1:
            return _no_sheet(Reason.DUPLICATE_FACE, simplex(*triangle), "two triangles")
        if len(triangle) > SHORTEST_RING:
            return _no_sheet(Reason.NOT_TRIANGLES, simplex(*triangle), "a triangle of more edges")
    return None


def _bad_sides(sheet: Sheet) -> Rejected | None:
    run = Counter(sides(sheet))
    for a, b in sorted(run):
        if a == b:
            return _no_sheet(Reason.REPEATED_VERTEX, AtVertex(a), "an edge to itself")
        if run[a, b] > 1:
            return _no_sheet(Reason.DOUBLE_EDGE, simplex(a, b), f"{a}→{b} is run twice")
        if (b, a) not in run:
            return _no_sheet(Reason.LOOP_NOT_CLOSED, simplex(a, b), f"{b}→{a} is not run")
    return None


def _bad_stars(sheet: Sheet) -> Rejected | None:
    """Only for cells whose sides are run once in each direction."""
    then = followers(sheet)
    valence = Counter(tail for tail, _ in then)
    for first in sorted(then):
        v, side, steps = first[0], then[first[::-1]], 1
        while side != first:
            side = then[side[::-1]]
            steps += 1
        if steps < valence[v]:
            detail = f"{steps} of {valence[v]} edges close up around it"
            return Rejected(Reason.PINCHED_VERTEX, Clause.OPER_SHEET_2, AtVertex(v), detail)
    return None
