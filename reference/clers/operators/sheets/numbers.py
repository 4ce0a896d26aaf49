"""The numbers of a sheet, always counted anew: no operator's own account is believed."""

from collections import Counter
from dataclasses import astuple, dataclass

from clers.complexes.homology import Field, rank
from clers.operators.sheets.sheet import (
    Sheet,
    cells_run,
    component,
    sides,
    sides_of,
    vertices,
)


@dataclass(frozen=True, slots=True)
class Numbers:
    """What is counted of a sheet, or by how much it differs. Clauses: OPER-SHEET-3, OPER-EFFECT-2.

    `faces` counts triangles and polygons, `genus` is summed over the components.
    """

    vertices: int = 0
    edges: int = 0
    faces: int = 0
    euler: int = 0
    components: int = 0
    genus: int = 0
    loops: int = 0

    def __sub__(self, before: "Numbers") -> "Numbers":
        """The differences."""
        return Numbers(*(x - y for x, y in zip(astuple(self), astuple(before), strict=True)))

    def __neg__(self) -> "Numbers":
        """The same, undone."""
        return Numbers() - self


def numbers(sheet: Sheet) -> Numbers:
    """Count cells; the genus is that of the closed surface with a disk in each loop.

    Clause: OPER-SHEET-3.
    """
    zero, one = len(vertices(sheet)), sum(1 for _ in sides(sheet)) // 2
    two, loops = len(sheet.triangles) + len(sheet.polygons), len(sheet.loops)
    euler = zero - one + two
    parts = len(set(component(sheet).values()))
    return Numbers(zero, one, two, euler, parts, (2 * parts - euler - loops) // 2, loops)


def betti_of_closed(sheet: Sheet, field: Field) -> tuple[int, int, int]:
    """The Betti numbers of a sheet with a disk in each loop, from chains of cells.

    No notion of corners or loops enters: a cell's boundary is the sum of its sides. OPER-SHEET-3.
    """
    zero = sorted(vertices(sheet))
    one = sorted({(min(side), max(side)) for side in sides(sheet)})
    column = {v: i for i, v in enumerate(zero)}
    row = {edge: i for i, edge in enumerate(one)}
    cells = list(cells_run(sheet))
    boundaries = []
    for cell in cells:
        chain: Counter[int] = Counter()
        for a, b in sides_of(cell):
            chain[row[min(a, b), max(a, b)]] += 1 if a < b else -1
        boundaries.append(dict(chain))
    first = rank([{column[a]: -1, column[b]: 1} for a, b in one], field)
    second = rank(boundaries, field)
    return len(zero) - first, len(one) - first - second, len(cells) - second
