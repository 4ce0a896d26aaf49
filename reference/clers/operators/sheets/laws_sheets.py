"""The laws of sheets: what they are, their numbers, and which of them are surfaces."""

from typing import Final

from clers.complexes.corner_table import surface as surface_of
from clers.complexes.definition import is_coherent_surface
from clers.complexes.given import SMALL_SURFACES
from clers.complexes.homology import Field
from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted
from clers.conventions.verdict import Fails, Verdict
from clers.conventions.where import WHOLE
from clers.operators.sheets.given import SHEETS
from clers.operators.sheets.numbers import Numbers, betti_of_closed, numbers
from clers.operators.sheets.sheet import Sheet, cells_run, fault, sides_of, turned
from clers.operators.sheets.surfaces import face_list, no_surface, sheet_of_surface


def _sides(sheet: Sheet) -> Verdict:
    """Each side once, and its reverse."""
    run = sorted(side for cell in cells_run(sheet) for side in sides_of(cell))
    back = sorted((b, a) for a, b in run)
    cells = (*sheet.triangles, *sheet.polygons, *sheet.loops)
    return every(
        same(len(set(run)), len(run)),
        same(run, back),
        same(cells, tuple(map(turned, cells))),
        same(len(sheet.triangles), len({frozenset(triangle) for triangle in sheet.triangles})),
    )


def _judged(sheet: Sheet) -> Verdict:
    """The predicate finds no fault, and finds one where a loop on any other cell is left out."""
    for loop in sheet.loops:
        alone = set(sides_of(loop)) == set(sides_of(loop[::-1]))
        without = Sheet(sheet.triangles, sheet.polygons, sheet.loops - {loop})
        if (fault(without) is None) != alone:
            return Fails("a fault", "none", WHOLE)
    return same(None, fault(sheet))


def _closed(sheet: Sheet) -> Verdict:
    """Chains of cells have the Betti numbers that the counts say."""
    found = numbers(sheet)
    betti = (found.components, 2 * found.genus, found.components)
    formula = 2 * found.components - 2 * found.genus - found.loops
    return every(
        same(formula, found.euler),
        same(found.vertices - found.edges + found.faces, found.euler),
        *(same(betti, betti_of_closed(sheet, field)) for field in Field),
    )


def _is_surface(sheet: Sheet) -> Verdict:
    """A sheet is a surface exactly if its triangles are one, and have these loops."""
    if not sheet.triangles or sheet.polygons:
        return same(sheet == Sheet(), no_surface(sheet) is None)
    listed = face_list(sheet)
    built = surface_of(listed)
    if not isinstance(built, Accepted):
        return every(
            same(False, is_coherent_surface(listed)), same(False, no_surface(sheet) is None)
        )
    names = sorted({v for triangle in sheet.triangles for v in triangle})
    found = sheet_of_surface(built.value)
    renamed = frozenset(turned(names[v] for v in loop) for loop in found.loops)
    return same(renamed == sheet.loops, no_surface(sheet) is None)


def _from_surface(surface: Surface) -> Verdict:
    """The sheet of a surface has its numbers, and is a surface with the same triangles."""
    sheet = sheet_of_surface(surface)
    parts = components(surface)
    counted = Numbers(
        surface.vertices,
        sum(part.edges for part in parts),
        surface.faces,
        sum(part.euler for part in parts),
        len(parts),
        sum(part.genus for part in parts),
        sum(part.curves for part in parts),
    )
    triangles = {turned(triangle) for triangle in surface.triangles()}
    return every(
        same(None, fault(sheet)),
        same(None, no_surface(sheet)),
        same(counted, numbers(sheet)),
        same(triangles, {turned(face) for face in face_list(sheet).faces}),
    )


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "sheet-sides-once",
        Clause.OPER_SHEET_1,
        "Triangles, polygons turned over and loops run each side once, and its reverse once.",
        SHEETS,
        _sides,
    ),
    Law(
        "sheet-has-no-fault",
        Clause.OPER_SHEET_2,
        "What operators leave is a sheet, and is none without a loop that bounds a face.",
        SHEETS,
        _judged,
    ),
    Law(
        "sheet-closed-homology",
        Clause.OPER_SHEET_3,
        "With a disk in each loop the Betti numbers are c, 2g, c, and χ = 2c − 2g − b.",
        SHEETS,
        _closed,
    ),
    Law(
        "sheet-is-surface",
        Clause.OPER_SHEET_4,
        "A sheet is a surface exactly if its triangles are one whose curves are its loops.",
        SHEETS,
        _is_surface,
    ),
    Law(
        "sheet-of-surface",
        Clause.OPER_SHEET_4,
        "The sheet of a surface has its triangles and its numbers.",
        SMALL_SURFACES,
        _from_surface,
    ),
)
