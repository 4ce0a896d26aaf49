"""Sheets as values: what is none, and why; their cells, numbers and surfaces."""

import pytest
from golden_sheets import ANNULUS, DISK, PINCHED, POLYGON, SPIKE, TRIANGLE, sheet

from clers.complexes.face_list import FaceList
from clers.complexes.homology import Field
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Rejected
from clers.conventions.where import AtSimplex, AtVertex, Where
from clers.edgebreaker.examples import ANNULUS as BAND
from clers.edgebreaker.examples import CUBE
from clers.operators.sheets.numbers import Numbers, betti_of_closed, numbers
from clers.operators.sheets.sheet import (
    EMPTY,
    Sheet,
    component,
    fault,
    followers,
    sheet_of,
    turned,
    vertices,
)
from clers.operators.sheets.surfaces import face_list, no_surface, sheet_of_surface

BOTH_WAYS = [(0, 1, 2), (2, 1, 0)]

FAULTS: tuple[tuple[Sheet, Reason, Where], ...] = (
    (sheet_of([(0, -1, 2)], [(2, -1, 0)]), Reason.INDEX_OUT_OF_RANGE, AtSimplex((-1, 0, 2))),
    (sheet_of([], [(0, 1, 0, 1)]), Reason.DOUBLE_EDGE, AtSimplex((0, 1))),
    (sheet_of([(0, 1, 0)], [(0, 1)]), Reason.REPEATED_VERTEX, AtSimplex((0, 1))),
    (sheet_of([], [(0, 1)], [(0, 1)]), Reason.LOOP_TOO_SHORT, AtSimplex((0, 1))),
    (sheet_of([], [(4,)]), Reason.LOOP_TOO_SHORT, AtSimplex((4,))),
    (sheet_of(BOTH_WAYS, []), Reason.DUPLICATE_FACE, AtSimplex((0, 1, 2))),
    (sheet_of([(0, 1, 2, 3)], [(3, 2, 1, 0)]), Reason.NOT_TRIANGLES, AtSimplex((0, 1, 2, 3))),
    (sheet_of([], [(0, 1, 1)]), Reason.REPEATED_VERTEX, AtVertex(1)),
    (sheet_of([(0, 1, 2)], []), Reason.LOOP_NOT_CLOSED, AtSimplex((0, 1))),
    (sheet_of([(0, 1, 2)], [(0, 1, 2)]), Reason.DOUBLE_EDGE, AtSimplex((0, 1))),
    # Two triangles that meet at vertex 0 and nowhere else, each with a loop of its own.
    (
        sheet_of([(0, 1, 2), (0, 3, 4)], [(2, 1, 0), (4, 3, 0)]),
        Reason.PINCHED_VERTEX,
        AtVertex(0),
    ),
)


@pytest.mark.parametrize(("wrong", "reason", "where"), FAULTS)
def test_no_sheet(wrong: Sheet, reason: Reason, where: Where) -> None:
    """OPER-SHEET-1, OPER-SHEET-2."""
    found = fault(wrong)
    assert isinstance(found, Rejected)
    assert (found.reason, found.where) == (reason, where)
    pinched = reason is Reason.PINCHED_VERTEX
    assert found.clause is (Clause.OPER_SHEET_2 if pinched else Clause.OPER_SHEET_1)
    assert found.detail


def test_one_loop_around_two_triangles_at_a_vertex() -> None:
    """OPER-SHEET-2: the same two triangles with one loop are a sheet, pinched at 0."""
    pinched = sheet_of([(0, 1, 2), (0, 3, 4)], [(2, 1, 0, 4, 3, 0)])
    assert fault(pinched) is None
    assert numbers(pinched) == Numbers(5, 6, 2, 1, 1, 0, 1)
    found = no_surface(pinched)
    assert isinstance(found, Rejected)
    assert found.where == AtVertex(0)


@pytest.mark.parametrize("text", ["", TRIANGLE, DISK, ANNULUS, PINCHED, POLYGON, SPIKE])
def test_sheets(text: str) -> None:
    """OPER-SHEET-1, OPER-SHEET-2."""
    assert fault(sheet(text)) is None


def test_cells_begin_where_they_are_least() -> None:
    """OPER-SHEET-1."""
    assert turned((3, 1, 2)) == (1, 2, 3)
    assert turned((0, 5, 0, 3)) == (0, 3, 0, 5)
    assert turned((2, 0, 1, 0)) == (0, 1, 0, 2)
    assert sheet_of([(1, 2, 0)], [(1, 0, 2)]) == sheet(TRIANGLE)


def test_components_and_followers() -> None:
    """OPER-SHEET-3."""
    two = sheet("zero-handle 4 1 2; zero-handle 7 3 5; make-ev 7 5 9")
    assert component(two) == {1: 1, 2: 1, 4: 1, 3: 3, 5: 3, 7: 3, 9: 3}
    assert vertices(two) == {1, 2, 3, 4, 5, 7, 9}
    then = followers(sheet(TRIANGLE))
    assert then[0, 1] == (1, 2)
    assert then[2, 0] == (0, 1)
    assert then[1, 0] == (0, 2)
    assert followers(sheet(POLYGON))[1, 0] == (0, 3)


def test_numbers_of_nothing() -> None:
    """OPER-SHEET-3."""
    assert numbers(EMPTY) == Numbers(0, 0, 0, 0, 0, 0, 0)
    assert Numbers(1, 2, 3, 4, 5, 6, 7) - Numbers(7, 6, 5, 4, 3, 2, 1) == Numbers(
        -6, -4, -2, 0, 2, 4, 6
    )
    assert -Numbers(1, 0, 2) == Numbers(-1, 0, -2)


def test_homology_of_two_components() -> None:
    """OPER-SHEET-3: two disks, closed, are two spheres."""
    two = sheet("zero-handle 4 1 2; zero-handle-polygon 7 3 5")
    assert betti_of_closed(two, Field.Q) == (2, 0, 2)


def test_surfaces_as_sheets() -> None:
    """OPER-SHEET-4: the band of chapter 5 has two curves of three edges."""
    band = sheet_of_surface(BAND)
    assert numbers(band) == Numbers(6, 12, 6, 0, 1, 0, 2)
    assert no_surface(band) is None
    # Faces 0 = (2,5,4) and 4 = (0,5,1) run 2 → 5 and 5 → 1 on the curve 2, 5, 1.
    assert (1, 5, 2) in band.loops
    assert (0, 3, 4) in band.loops
    assert sheet_of_surface(CUBE).loops == frozenset()


def test_faces_are_numbered_in_order() -> None:
    """OPER-SHEET-4."""
    assert face_list(sheet("zero-handle 5 9 7; glue 9 5 1")) == FaceList(((0, 3, 1), (1, 3, 2)), 4)


def test_no_surfaces() -> None:
    """OPER-SHEET-4."""
    assert no_surface(EMPTY) is None
    assert no_surface(sheet(ANNULUS)) is None
    for text in (POLYGON, SPIKE, PINCHED):
        assert no_surface(sheet(text)) is not None
