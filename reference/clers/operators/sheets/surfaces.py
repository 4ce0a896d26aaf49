"""Sheets that are surfaces, and the operators that lead from surface to surface."""

from collections import Counter

from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.complexes.topology import curves
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtVertex
from clers.operators.sheets.apply import apply
from clers.operators.sheets.needs import refused
from clers.operators.sheets.operator import (
    Complete,
    Glue,
    JoinStrip,
    LowerStrip,
    Operator,
    TwoHandle,
    Undo,
    UpperStrip,
    ZeroHandle,
)
from clers.operators.sheets.sheet import Sheet, sheet_of, sides_of, simplex, vertices

ON_SURFACES = (ZeroHandle, Complete, Glue, JoinStrip, LowerStrip, UpperStrip, TwoHandle)
"""The seven that make a surface of a surface. Clause: OPER-SURFACE-10."""


def sheet_of_surface(surface: Surface) -> Sheet:
    """The triangles of a surface, and its boundary curves turned over. Clause: OPER-SHEET-4."""
    return sheet_of(surface.triangles(), (curve.vertices[::-1] for curve in curves(surface)), ())


def face_list(sheet: Sheet) -> FaceList:
    """The triangles, in order, with the vertices numbered in order. Clause: OPER-SHEET-4."""
    number = {v: i for i, v in enumerate(sorted(vertices(sheet)))}
    faces = tuple((number[a], number[b], number[c]) for a, b, c in sorted(sheet.triangles))
    return FaceList(faces, len(number))


def no_surface(sheet: Sheet) -> Rejected | None:
    """Why a sheet is no surface; None exactly if it is one. Clauses: OPER-SHEET-4, OPER-SURFACE-10.

    The empty sheet is one.
    """
    clause = Clause.OPER_SURFACE_10
    if sheet.polygons:
        return refused(clause, WHOLE, "it has an infinite face")
    passes = Counter(v for loop in sheet.loops for v in loop)
    pinched = [v for v, times in passes.items() if times > 1]
    if pinched:
        where = AtVertex(min(pinched))
        return Rejected(Reason.PINCHED_VERTEX, clause, where, "the loops pass it twice")
    run = {side for loop in sheet.loops for side in sides_of(loop)}
    bare = sorted(side for side in run if side[::-1] in run)
    if bare:
        return refused(clause, simplex(*bare[0]), "an edge without a triangle")
    return None


def apply_to_surface(operator: Operator, sheet: Sheet) -> Accepted[Sheet] | Rejected:
    """A surface operator: from a sheet that is a surface to another. Total. OPER-SURFACE-10."""
    clause = Clause.OPER_SURFACE_10
    what = operator.of if isinstance(operator, Undo) else operator
    if not isinstance(what, ON_SURFACES):
        return refused(clause, WHOLE, f"{type(what).__name__} is no surface operator")
    bad = no_surface(sheet)
    if bad is not None:
        return refused(clause, bad.where, f"this is no surface: {bad.detail}")
    after = apply(operator, sheet)
    if isinstance(after, Rejected):
        return after
    return no_surface(after.value) or after
