"""Compact half-edges of chapter 3's band, by hand, and each fault of each level."""

from dataclasses import replace
from typing import Final

import pytest

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList, Limits
from clers.complexes.structures.arrays import read_corner_table
from clers.complexes.structures.compact import (
    Level0,
    Level1,
    Level2,
    Level3,
    after,
    before,
    compact,
    face_list,
    integers,
)
from clers.complexes.structures.compact_invariant import level_0, level_1, level_2, level_3
from clers.complexes.structures.compact_queries import (
    Read,
    curves_2,
    curves_3,
    opposite_0,
    opposite_1,
    star_0,
    star_1,
    star_2,
)
from clers.complexes.structures.corner_invariant import corner_table
from clers.complexes.surface import Corner, Surface, Vertex, corners_listed
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtEntry, AtFace, Where

TETRAHEDRON: Final = FaceList(((0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)), 4)
BAND: Final = FaceList(((0, 1, 3), (1, 4, 3), (1, 2, 4), (2, 5, 4), (2, 0, 5), (0, 3, 5)), 6)


def accepted(given: FaceList) -> Surface:
    """The surface of a face list that is one."""
    answer = surface(given)
    assert isinstance(answer, Accepted), answer
    return answer.value


def test_the_band() -> None:
    """Sides without a counterpart: 0→1, 4→3, 1→2, 5→4, 2→0, 0→3 is inner. CPLX-COMPACT-2."""
    band = accepted(BAND)
    made = compact(band)
    assert made.cells.table.soup == Level0(tuple(v for face in BAND.faces for v in face), 6)
    assert made.cells.table.opposite == by_hand()
    assert face_list(made.cells.table.soup) == BAND
    assert [integers(x) for x in levels(made)] == [18, 36, 54, 56]


def by_hand() -> tuple[int, ...]:
    """Each side run the other way, looked up by eye in the band's faces."""
    runs = [(f[i], f[(i + 1) % 3]) for f in BAND.faces for i in range(3)]
    return tuple(runs.index((b, a)) if (b, a) in runs else -1 for a, b in runs)


def levels(of: Level3) -> tuple[Level0, Level1, Level2, Level3]:
    """All four."""
    return of.cells.table.soup, of.cells.table, of.cells, of


GOOD: Final = compact(accepted(BAND))
CELLS: Final = GOOD.cells
TABLE: Final = CELLS.table
SOUP: Final = TABLE.soup


def test_cells_of_the_band() -> None:
    """Border sides leave 0, 1, 2 for the next of these, and 4, 5, 3 likewise.

    Clauses: CPLX-COMPACT-1, CPLX-COMPACT-2.
    """
    assert CELLS.of_vertex == (0, 6, 12, 16, 4, 10)
    assert CELLS.edges == (0, 1, 2, 3, 4, 6, 7, 9, 10, 12, 13, 16)
    assert GOOD.curves == (0, 4)
    assert (after(2), before(0), after(3), before(4)) == (0, 2, 4, 3)


def test_queries_of_the_band() -> None:
    """Vertex 1 has the faces 0, 1 and 2. CPLX-COMPACT-5, CPLX-COMPACT-6, CPLX-COMPACT-7."""
    star = frozenset({0, 1, 2})
    assert star_0(SOUP, 1) == Read(star, 18)
    assert star_1(TABLE, 1) == Read(star, 2 + 3 - 2 + 3)
    assert star_2(CELLS, 1) == Read(star, 4)
    assert opposite_0(SOUP, 1) == Read(5, 2 + 6 + 2)
    assert opposite_1(TABLE, 1) == Read(5, 1)
    assert opposite_0(SOUP, 0).answer == -1
    assert curves_2(CELLS) == Read(((0, 1, 2), (4, 3, 5)), 18 + 12)
    assert curves_3(GOOD) == Read(((0, 1, 2), (4, 3, 5)), 2 + 12)


def broken(array: str, at: int) -> tuple[Reason, Where]:
    return Reason.BROKEN_INVARIANT, AtEntry(array, at)


def mismatch(array: str, at: int) -> tuple[Reason, Where]:
    return Reason.COUNT_MISMATCH, AtEntry(array, at)


def entry(array: tuple[int, ...], at: int, value: int) -> tuple[int, ...]:
    return (*array[:at], value, *array[at + 1 :])


def edges(array: tuple[int, ...]) -> Level3:
    return replace(GOOD, cells=replace(CELLS, edges=array))


def vertices(array: tuple[int, ...]) -> Level3:
    return replace(GOOD, cells=replace(CELLS, of_vertex=array))


def opposite(array: tuple[int, ...]) -> Level3:
    return replace(GOOD, cells=replace(CELLS, table=replace(TABLE, opposite=array)))


@pytest.mark.parametrize(
    ("of", "expected", "level"),
    [
        (opposite(TABLE.opposite[1:]), mismatch("opposite", 17), 1),
        (opposite((*TABLE.opposite, -1)), mismatch("opposite", 18), 1),
        (opposite(entry(TABLE.opposite, 17, -1)), broken("opposite", 17), 1),
        (opposite(entry(TABLE.opposite, 0, 0)), broken("opposite", 0), 1),
        (vertices(CELLS.of_vertex[1:]), mismatch("of_vertex", 5), 2),
        (edges(CELLS.edges[1:]), mismatch("edges", 11), 2),
        (vertices(entry(CELLS.of_vertex, 1, 3)), broken("of_vertex", 1), 2),
        (vertices(entry(CELLS.of_vertex, 5, 0)), broken("of_vertex", 5), 2),
        (vertices(entry(CELLS.of_vertex, 0, 18)), broken("of_vertex", 0), 2),
        (opposite((-1,) * 18), broken("opposite", 1), 1),
        (vertices(entry(CELLS.of_vertex, 0, -18)), broken("of_vertex", 0), 2),
        (vertices(entry(CELLS.of_vertex, 5, -1)), broken("of_vertex", 5), 2),
        (edges(entry(CELLS.edges, 11, 0)), broken("edges", 11), 2),
        (edges(entry(CELLS.edges, 11, 5)), broken("edges", 11), 2),
        (edges(entry(CELLS.edges, 0, 18)), broken("edges", 0), 2),
        (edges(entry(CELLS.edges, 0, -1)), broken("edges", 0), 2),
        (replace(GOOD, curves=(0,)), mismatch("curves", 1), 3),
        (replace(GOOD, curves=(0, 6)), broken("curves", 1), 3),
        (replace(GOOD, curves=(1, 4)), broken("curves", 0), 3),
        (replace(GOOD, curves=(-1, 4)), broken("curves", 0), 3),
    ],
)
def test_each_fault_of_compact_half_edges(
    of: Level3, expected: tuple[Reason, Where], level: int
) -> None:
    """Each level accepts what is wrong above it. Clause: CPLX-COMPACT-3."""
    soup, table, cells, whole = levels(of)
    answers = [level_0(soup), level_1(table), level_2(cells), level_3(whole)]
    assert [isinstance(answer, Accepted) for answer in answers] == [k < level for k in range(4)]
    for answer in answers[level:]:
        assert isinstance(answer, Rejected)
        assert answer.clause is Clause.CPLX_COMPACT_3
        assert (answer.reason, answer.where) == expected


def test_what_is_said_of_compact_faults() -> None:
    """Clause: CPLX-COMPACT-3."""
    said = level_1(replace(TABLE, opposite=entry(TABLE.opposite, 17, 4)))
    assert isinstance(said, Rejected)
    assert said.detail == "4"
    short = level_1(replace(TABLE, opposite=()))
    assert isinstance(short, Rejected)
    assert short.detail == "0 entries, and not 18"


def test_other_representatives_are_as_good() -> None:
    """Which half-edge of an edge or of a curve is free. Clause: CPLX-COMPACT-3."""
    assert isinstance(level_3(edges(entry(CELLS.edges, 1, 5))), Accepted)
    assert isinstance(level_3(replace(GOOD, curves=(10, 12))), Accepted)
    closed = compact(accepted(TETRAHEDRON))
    first = closed.cells.of_vertex[0]
    others = [h for h in range(12) if closed.cells.table.soup.vertex[h] == 0 and h != first]
    changed = replace(closed.cells, of_vertex=(others[0], *closed.cells.of_vertex[1:]))
    assert level_2(changed) == Accepted(changed)


def test_soups_that_are_none() -> None:
    """Clause: CPLX-COMPACT-3."""
    assert level_0(Level0((0, 1, 2, 0), 3)) == Rejected(
        Reason.COUNT_MISMATCH,
        Clause.CPLX_COMPACT_3,
        AtEntry("vertex", 3),
        "4 entries, and not 3",
    )
    assert level_0(Level0((0, 1, 3), 3)) == Rejected(
        Reason.INDEX_OUT_OF_RANGE, Clause.CPLX_REJECT_3, AtFace(0), detail()
    )
    answer = level_3(GOOD, Limits(5, 9))
    assert isinstance(answer, Rejected)
    assert answer.reason is Reason.TOO_MANY_FACES
    assert level_2(CELLS, Limits(5, 9)) == level_1(TABLE, Limits(5, 9)) == answer
    assert level_0(SOUP, Limits(5, 9)) == answer


def detail() -> str:
    """What the reader of face lists says there."""
    answer = surface(FaceList(((0, 1, 3),), 3))
    assert isinstance(answer, Rejected)
    return answer.detail


@pytest.mark.parametrize("content", [b"", b"{}", b'{"\xff":1}', b"[" * 100_000])
def test_unreadable_corner_tables(content: bytes) -> None:
    """Clause: CPLX-REFINE-3."""
    answer = read_corner_table(content)
    assert isinstance(answer, Rejected)
    assert (answer.reason, answer.clause) == (Reason.UNREADABLE_FILE, Clause.CPLX_REFINE_3)


def test_corner_tables_of_others() -> None:
    """Clause: CPLX-REFINE-2."""
    band = accepted(BAND)
    assert corner_table(band) == Accepted(band)
    wrong = corners_listed(band.vertex, (*band.opposite[:-1], Corner(2)), band.vertices)
    assert corner_table(wrong) == Rejected(
        Reason.BROKEN_INVARIANT,
        Clause.CPLX_REFINE_2,
        AtEntry("opposite", 17),
        "2, and not 1",
    )
    short = corners_listed(band.vertex, band.opposite[:-1], 6)
    assert corner_table(short) == Rejected(
        Reason.COUNT_MISMATCH, Clause.CPLX_REFINE_2, WHOLE, "18 vertices, 17 opposites"
    )
    ragged = corners_listed(band.vertex[:-1], band.opposite[:-1], 6)
    assert corner_table(ragged) == Rejected(
        Reason.COUNT_MISMATCH, Clause.CPLX_REFINE_2, WHOLE, "17 vertices, 17 opposites"
    )
    none = corners_listed((Vertex(0),) * 3, (Corner(-1),) * 3, 1)
    answer = corner_table(none)
    assert isinstance(answer, Rejected)
    assert answer.reason is Reason.REPEATED_INDEX
    small = corner_table(band, Limits(5, 9))
    assert isinstance(small, Rejected)
    assert small.reason is Reason.TOO_MANY_FACES
