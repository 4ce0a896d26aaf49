"""What operators on sheets refuse: the reason, the clause, and what is blamed."""

import pytest
from golden_sheets import (
    ANNULUS,
    DISK,
    PINCHED,
    POLYGON,
    SPIKE,
    TRIANGLE,
    TWO_TRIANGLES,
    after,
    only,
    sheet,
)

from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtSimplex, AtVertex, Where
from clers.operators.sheets.apply import apply
from clers.operators.sheets.operator import MakeEV, MakeSTV, ZeroHandlePolygon
from clers.operators.sheets.sheet import EMPTY, sheet_of
from clers.operators.sheets.surfaces import apply_to_surface

NOT = Reason.OPERATOR_NOT_APPLICABLE
TWICE = Reason.REPEATED_VERTEX
EDGE = Reason.DOUBLE_EDGE
FACE = Reason.DUPLICATE_FACE


def blamed(where: int | tuple[int, ...]) -> Where:
    return AtVertex(where) if isinstance(where, int) else AtSimplex(where)


MAKE: tuple[tuple[str, str, Reason, Clause, int | tuple[int, ...]], ...] = (
    (DISK, "zero-handle 6 7 6", TWICE, Clause.OPER_SURFACE_1, 6),
    (DISK, "zero-handle 6 7 5", NOT, Clause.OPER_SURFACE_1, 5),
    (DISK, "make-stv 0 7 8", NOT, Clause.OPER_EULER_1, 0),
    (DISK, "zero-handle-polygon 6 7", NOT, Clause.OPER_SURFACE_1, (6, 7)),
    (DISK, "zero-handle-polygon", NOT, Clause.OPER_SURFACE_1, ()),
    (DISK, "zero-handle-polygon 6 7 8 7", TWICE, Clause.OPER_SURFACE_1, 7),
    (DISK, "zero-handle-polygon 6 7 8 3", NOT, Clause.OPER_SURFACE_1, 3),
    (DISK, "make-ev 0 2 0", TWICE, Clause.OPER_EULER_2, 0),
    (DISK, "make-ev 0 2 2", TWICE, Clause.OPER_EULER_2, 2),
    (DISK, "make-ev 0 2 5", NOT, Clause.OPER_EULER_2, 5),
    (DISK, "make-ev 2 0 6", NOT, Clause.OPER_EULER_2, (0, 2)),
    (DISK, "make-te 0 2 0", TWICE, Clause.OPER_EULER_3, 0),
    (DISK, "make-te 2 0 1", NOT, Clause.OPER_EULER_3, (0, 2)),
    (DISK, "make-te 0 2 5", NOT, Clause.OPER_EULER_3, (2, 5)),
    (DISK, "make-te 1 0 2", EDGE, Clause.OPER_EULER_3, (1, 2)),
    (TRIANGLE, "make-te 2 1 0", EDGE, Clause.OPER_EULER_3, (0, 2)),
    (DISK, "complete 0 2 5", NOT, Clause.OPER_SURFACE_2, (2, 5)),
    (DISK, "complete 1 0 2", EDGE, Clause.OPER_SURFACE_2, (1, 2)),
    (SPIKE, "complete 0 3 0", TWICE, Clause.OPER_SURFACE_2, 0),
    (DISK, "make-sg 0 2 4", NOT, Clause.OPER_EULER_4, (0, 2, 4)),
    (DISK, "make-sg 0 2 2", TWICE, Clause.OPER_EULER_4, 2),
    (TRIANGLE, "make-sg 2 1 0", FACE, Clause.OPER_EULER_4, (0, 1, 2)),
    (TRIANGLE, "two-handle 1 0 2", FACE, Clause.OPER_SURFACE_7, (0, 1, 2)),
    (TRIANGLE, "two-handle 0 1 2", NOT, Clause.OPER_SURFACE_7, (0, 1, 2)),
    (DISK, "make-ekl 0 2 0 2", TWICE, Clause.OPER_EULER_5, 0),
    (DISK, "make-ekl 2 0 5 3", NOT, Clause.OPER_EULER_5, (0, 2)),
    (DISK, "make-ekl 0 2 3 5", NOT, Clause.OPER_EULER_5, (3, 5)),
    (DISK, "make-ekl 0 2 5 3", NOT, Clause.OPER_EULER_5, (3, 5)),
    (ANNULUS, "make-ekl 1 5 4 0", EDGE, Clause.OPER_EULER_5, (1, 4)),
    (DISK, "glue 0 2 2", TWICE, Clause.OPER_SURFACE_3, 2),
    (DISK, "glue 0 2 4", NOT, Clause.OPER_SURFACE_3, 4),
    (DISK, "glue 2 0 6", NOT, Clause.OPER_SURFACE_3, (0, 2)),
    (DISK, "join 1 0 4 5", NOT, Clause.OPER_SURFACE_4, (4, 5)),
    (DISK, "upper 1 0 4 5", NOT, Clause.OPER_SURFACE_6, (4, 5)),
    (ANNULUS, "lower 5 3 0 2", NOT, Clause.OPER_SURFACE_5, (0, 2)),
    (ANNULUS, "join 5 3 0 2", NOT, Clause.OPER_SURFACE_4, (0, 2)),
    (TWO_TRIANGLES, "upper 1 0 3 5", NOT, Clause.OPER_SURFACE_6, (3, 5)),
    (TWO_TRIANGLES, "lower 1 0 3 5", NOT, Clause.OPER_SURFACE_5, (3, 5)),
    (DISK, "lower 1 0 1 0", TWICE, Clause.OPER_SURFACE_5, 1),
    (DISK, "lower 1 0 0 2", TWICE, Clause.OPER_SURFACE_5, 0),
    (DISK, "lower 0 1 4 5", NOT, Clause.OPER_SURFACE_5, (0, 1)),
    (DISK, "lower 1 0 5 4", NOT, Clause.OPER_SURFACE_5, (4, 5)),
    (DISK, "lower 1 0 2 4", EDGE, Clause.OPER_SURFACE_5, (0, 2)),
    (DISK, "lower 2 4 1 0", EDGE, Clause.OPER_SURFACE_5, (1, 2)),
    (DISK, "lower-strip 2 4 1 0", EDGE, Clause.OPER_SURFACE_5, (1, 2)),
    (DISK, "lower-strip 1 0 5 3", EDGE, Clause.OPER_EULER_3, (1, 3)),
    (DISK, "upper-strip 1 0 4 5", NOT, Clause.OPER_SURFACE_6, (4, 5)),
    (DISK, "join-strip 1 0 4 5", NOT, Clause.OPER_SURFACE_4, (4, 5)),
)

UNDO: tuple[tuple[str, str, Clause, tuple[int, ...]], ...] = (
    (DISK, "undo-zero-handle 0 1 2", Clause.OPER_SURFACE_1, (0, 1, 2)),
    (TRIANGLE, "undo-zero-handle 2 1 0", Clause.OPER_SURFACE_1, (0, 1, 2)),
    (DISK, "kill-stv 0 1 2", Clause.OPER_EULER_1, (0, 1, 2)),
    (TRIANGLE, "undo-zero-handle-polygon 0 1 2", Clause.OPER_SURFACE_1, (0, 1, 2)),
    (TRIANGLE, "undo-zero-handle-polygon 2 1 0", Clause.OPER_SURFACE_1, (0, 1, 2)),
    (POLYGON, "undo-zero-handle-polygon", Clause.OPER_SURFACE_1, ()),
    (
        f"{POLYGON}; glue 0 1 4",
        "undo-zero-handle-polygon 0 1 2 3",
        Clause.OPER_SURFACE_1,
        (0, 1, 2, 3),
    ),
    (DISK, "kill-ev 0 2 6", Clause.OPER_EULER_2, (0, 6)),
    (DISK, "kill-ev 0 4 2", Clause.OPER_EULER_2, (0, 2)),
    (SPIKE, "kill-ev 0 1 3", Clause.OPER_EULER_2, (0, 3)),
    (f"{TRIANGLE}; kill-te 0 1 2; kill-ev 1 2 0", "kill-ev 1 2 2", Clause.OPER_EULER_2, (1, 2)),
    (DISK, "kill-te 2 0 1", Clause.OPER_EULER_3, (1, 2)),
    (DISK, "kill-te 0 2 1", Clause.OPER_EULER_3, (0, 1, 2)),
    (DISK, "undo-complete 2 0 1", Clause.OPER_SURFACE_2, (1, 2)),
    (DISK, "kill-sg 0 2 1", Clause.OPER_EULER_4, (0, 1, 2)),
    (DISK, "undo-two-handle 0 2 4", Clause.OPER_SURFACE_7, (0, 2, 4)),
    (DISK, "kill-ekl 2 5 0 4", Clause.OPER_EULER_5, (0, 2)),
    (DISK, "kill-ekl 0 4 2 4", Clause.OPER_EULER_5, (0, 2)),
    (DISK, "kill-ekl 0 2 2 4", Clause.OPER_EULER_5, (0, 2)),
    (SPIKE, "kill-ekl 0 2 3 0", Clause.OPER_EULER_5, (0, 3)),
    (SPIKE, "kill-ekl 3 0 0 2", Clause.OPER_EULER_5, (0, 3)),
    (f"{TWO_TRIANGLES}; make-ekl 1 0 3 5", "kill-ekl 1 2 3 5", Clause.OPER_EULER_5, (1, 3)),
    (f"{TWO_TRIANGLES}; make-ekl 1 0 3 5", "kill-ekl 1 0 3 4", Clause.OPER_EULER_5, (1, 3)),
    (DISK, "undo-glue 4 3 6", Clause.OPER_SURFACE_3, (3, 4, 6)),
    (DISK, "undo-glue 2 1 3", Clause.OPER_SURFACE_3, (2, 3)),
    (DISK, "undo-glue 2 3 4", Clause.OPER_SURFACE_3, (3, 4)),
    (DISK, "undo-lower 1 0 4 5", Clause.OPER_SURFACE_5, (0, 1, 4)),
    (PINCHED, "undo-lower 1 0 4 3", Clause.OPER_SURFACE_5, (3, 4)),
    (PINCHED, "undo-lower 4 1 0 2", Clause.OPER_SURFACE_5, (0, 1)),
    (PINCHED, "undo-lower 0 4 1 0", Clause.OPER_SURFACE_5, (0, 1)),
    (DISK, "undo-lower 4 3 5 3", Clause.OPER_SURFACE_5, (3, 4, 5)),
    (PINCHED, "undo-join 1 0 4 5", Clause.OPER_SURFACE_4, (0, 4)),
    (PINCHED, "undo-upper 1 0 4 5", Clause.OPER_SURFACE_6, (0, 4)),
    (DISK, "undo-upper 4 3 6 3", Clause.OPER_SURFACE_6, (3, 4, 6)),
    (DISK, "undo-upper 4 3 5 3", Clause.OPER_SURFACE_6, (3, 5)),
    (DISK, "undo-upper 2 1 3 4", Clause.OPER_SURFACE_6, (2, 3)),
    (f"{TWO_TRIANGLES}; join 1 0 3 5", "undo-upper 1 0 3 5", Clause.OPER_SURFACE_6, (0, 1, 3)),
    (f"{TWO_TRIANGLES}; join 1 0 3 5", "undo-join 1 0 3 4", Clause.OPER_SURFACE_4, (3, 4)),
    (f"{ANNULUS}; upper 5 3 0 2", "undo-join 5 3 0 2", Clause.OPER_SURFACE_4, (0, 3, 5)),
    (ANNULUS, "undo-lower-strip 1 0 4 3", Clause.OPER_EULER_3, (1, 3, 4)),
    (ANNULUS, "undo-upper-strip 1 0 4 5", Clause.OPER_SURFACE_6, (0, 4)),
)  # fmt: skip


@pytest.mark.parametrize(("start", "operator", "reason", "clause", "where"), MAKE)
def test_refused(
    start: str, operator: str, reason: Reason, clause: Clause, where: int | tuple[int, ...]
) -> None:
    """OPER-SHEET-5."""
    result = after(start, operator)
    assert isinstance(result, Rejected)
    assert (result.reason, result.clause, result.where) == (reason, clause, blamed(where))
    assert result.detail
    if result.detail.endswith("is on no loop"):
        names = operator.split()[1:]
        assert result.detail.split()[0] in ("→".join(names[:2]), "→".join(names[2:]))


@pytest.mark.parametrize(("start", "operator", "clause", "where"), UNDO)
def test_undo_refused(start: str, operator: str, clause: Clause, where: tuple[int, ...]) -> None:
    """OPER-SHEET-6: always as not applicable."""
    result = after(start, operator)
    assert isinstance(result, Rejected)
    assert (result.reason, result.clause, result.where) == (NOT, clause, AtSimplex(where))
    assert result.detail


def test_negative_vertices_are_not_new() -> None:
    """OPER-SHEET-5."""
    for operator in (MakeSTV(1, 2, -1), ZeroHandlePolygon((1, 2, -1))):
        result = apply(operator, EMPTY)
        assert isinstance(result, Rejected)
        assert (result.reason, result.where) == (NOT, AtVertex(-1))
    assert isinstance(apply(MakeEV(0, 2, -3), sheet(DISK)), Rejected)


SURFACES: tuple[tuple[str, str, Reason, Where], ...] = (
    (DISK, "undo-complete 0 1 2", Reason.PINCHED_VERTEX, AtVertex(1)),
    (TRIANGLE, "undo-complete 0 1 2", Reason.PINCHED_VERTEX, AtVertex(1)),
    (TRIANGLE, "undo-glue 0 1 2", NOT, AtSimplex((0, 1))),
    (TRIANGLE, "undo-glue 1 2 0", NOT, AtSimplex((1, 2))),
    (TRIANGLE, "undo-two-handle 0 1 2", Reason.PINCHED_VERTEX, AtVertex(0)),
    (DISK, "make-te 0 2 4", NOT, WHOLE),
    (DISK, "kill-te 0 1 2", NOT, WHOLE),
    (DISK, "lower 1 0 4 5", NOT, WHOLE),
    (DISK, "zero-handle-polygon 7 8 9", NOT, WHOLE),
    (PINCHED, "complete 1 4 5", NOT, AtVertex(4)),
    (SPIKE, "glue 2 1 4", NOT, AtVertex(0)),
    (f"{TRIANGLE}; kill-te 0 1 2; kill-ev 1 2 0", "glue 1 2 4", NOT, AtSimplex((1, 2))),
    (POLYGON, "glue 0 1 4", NOT, WHOLE),
    (DISK, "glue 2 0 6", NOT, AtSimplex((0, 2))),
)


@pytest.mark.parametrize(("start", "operator", "reason", "where"), SURFACES)
def test_refused_on_surfaces(start: str, operator: str, reason: Reason, where: Where) -> None:
    """OPER-SURFACE-10."""
    result = apply_to_surface(only(operator), sheet(start))
    assert isinstance(result, Rejected)
    assert (result.reason, result.where) == (reason, where)
    assert result.detail


def test_a_strip_may_not_leave_a_bare_edge() -> None:
    """OPER-SURFACE-10: two bare edges glued by a strip are two triangles; back is no surface."""
    square, strip = sheet("zero-handle 0 1 2; glue 0 2 3"), only("undo-join-strip 0 1 2 3")
    assert apply(strip, square) == Accepted(sheet_of((), [(0, 1), (2, 3)]))
    result = apply_to_surface(strip, square)
    assert isinstance(result, Rejected)
    assert (result.reason, result.where) == (NOT, AtSimplex((0, 1)))
