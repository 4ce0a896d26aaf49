"""Half-edges by hand: two triangles, each fault, and what a library would be told."""

from dataclasses import replace
from typing import Final

import msgspec
import pytest

from clers.complexes.polytopes.polygons import PolygonList
from clers.complexes.structures.arrays import read_half_edges, write_half_edges
from clers.complexes.structures.half_edge import HalfEdges, around_vertex, half_edges
from clers.complexes.structures.half_edge_definition import cycles, is_half_edge_structure
from clers.complexes.structures.half_edge_polygons import from_polygons, is_regular, polygons
from clers.complexes.structures.half_edge_queries import (
    boundary_curves,
    faces_at,
    flip,
    neighbours,
)
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtEntry

TWO: Final = HalfEdges(
    next=(1, 2, 0, 4, 5, 3, 8, 6, 9, 7),
    previous=(2, 0, 1, 5, 3, 4, 7, 9, 6, 8),
    twin=(6, 3, 7, 1, 8, 9, 0, 2, 4, 5),
    origin=(0, 1, 2, 2, 1, 3, 1, 0, 3, 2),
    face=(0, 0, 0, 1, 1, 1, -1, -1, -1, -1),
    of_vertex=(7, 6, 9, 8),
    of_face=(0, 3),
)
"""The triangles 0, 1, 2 and 2, 1, 3, drawn on paper: sides 0 to 5, border half-edges 6 to 9.

    6: 1 → 0, 7: 0 → 2, 8: 3 → 1, 9: 2 → 3; along the border 6, 7, 9, 8.
"""
MENDED: Final = replace(
    TWO, next=(1, 2, 0, 4, 5, 3, 7, 9, 6, 8), previous=(2, 0, 1, 5, 3, 4, 8, 6, 9, 7)
)


def test_two_triangles() -> None:
    """Clauses: CPLX-HALFEDGE-1, CPLX-HALFEDGE-10, CPLX-HALFEDGE-11."""
    faces = PolygonList(((0, 1, 2), (2, 1, 3)), 4)
    assert from_polygons(faces) == Accepted(MENDED)
    assert half_edges(MENDED) == Accepted(MENDED)
    assert polygons(MENDED) == faces
    assert (MENDED.vertices, MENDED.faces, MENDED.head(3), MENDED.rotated(1)) == (4, 2, 1, 6)
    assert is_regular(MENDED)


def test_the_first_drawing_was_wrong() -> None:
    """The border of TWO runs 6, 8, 9, 7, but 8 does not begin where 6 ends. CPLX-HALFEDGE-5."""
    answer = half_edges(TWO)
    assert answer == Rejected(
        Reason.BROKEN_INVARIANT,
        Clause.CPLX_HALFEDGE_5,
        AtEntry("origin", 6),
        "from 1 to 0, and the next from 3",
    )


def test_around_two_triangles() -> None:
    """Clauses: CPLX-HALFEDGE-14, CPLX-HALFEDGE-15."""
    assert tuple(around_vertex(MENDED, 6)) == (6, 4, 1)
    assert neighbours(MENDED, 1) == (0, 3, 2)
    assert faces_at(MENDED, 1) == (1, 0)
    assert faces_at(MENDED, 0) == (0,)
    assert boundary_curves(MENDED) == ((0, 1, 3, 2),)


def test_a_closed_structure_has_no_curve() -> None:
    """The tetrahedron. Clause: CPLX-HALFEDGE-15."""
    answer = from_polygons(PolygonList(((0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)), 4))
    assert isinstance(answer, Accepted)
    assert boundary_curves(answer.value) == ()
    assert len(answer.value.next) == 12
    assert answer.value.of_vertex == (0, 1, 2, 4)


def test_rejected_polygons_have_no_half_edges() -> None:
    """Clause: CPLX-HALFEDGE-11."""
    assert from_polygons(PolygonList((), 0)) == Rejected(
        Reason.EMPTY_MESH, Clause.CPLX_POLYGON_2, WHOLE
    )


def entry(array: tuple[int, ...], at: int, value: int) -> tuple[int, ...]:
    """One entry changed."""
    return (*array[:at], value, *array[at + 1 :])


M: Final = MENDED
TWO_PAIRS: Final = HalfEdges(
    next=(0, 1, 2, 3), previous=(0, 1, 2, 3), twin=(1, 0, 3, 2), origin=(0, 0, 0, 0),
    face=(0, -1, 1, -1), of_vertex=(0,), of_face=(0, 2),
)  # fmt: skip
LENS: Final = HalfEdges(
    next=(1, 0, 3, 2), previous=(1, 0, 3, 2), twin=(2, 3, 0, 1), origin=(0, 1, 1, 0),
    face=(0, 0, -1, -1), of_vertex=(3, 2), of_face=(0,),
)  # fmt: skip
"""A face of two sides, and its border."""
TWO_LENSES: Final = HalfEdges(
    next=(1, 0, 3, 2, 5, 4, 7, 6), previous=(1, 0, 3, 2, 5, 4, 7, 6), twin=(2, 3, 0, 1, 6, 7, 4, 5),
    origin=(0, 1, 1, 0, 0, 1, 1, 0), face=(0, 0, -1, -1, 1, 1, -1, -1), of_vertex=(3, 2),
    of_face=(0, 4),
)  # fmt: skip
"""Two of them, said to have their two vertices in common."""
BOW_TIE: Final = HalfEdges(
    next=(1, 2, 0, 4, 5, 3, 11, 6, 7, 8, 9, 10),
    previous=(2, 0, 1, 5, 3, 4, 7, 8, 9, 10, 11, 6),
    twin=(6, 7, 8, 9, 10, 11, 0, 1, 2, 3, 4, 5),
    origin=(0, 1, 2, 0, 3, 4, 1, 2, 0, 3, 4, 0),
    face=(0, 0, 0, 1, 1, 1, -1, -1, -1, -1, -1, -1),
    of_vertex=(8, 6, 7, 9, 10),
    of_face=(0, 3),
)
"""Two triangles that touch in vertex 0, around which the border passes twice."""

FAULTS: Final = (
    (replace(M, previous=M.previous[1:]), 2, "previous", 9),
    (replace(M, twin=(*M.twin, 0)), 2, "twin", 10),
    (replace(M, origin=M.origin[1:]), 2, "origin", 9),
    (replace(M, face=()), 2, "face", 0),
    (replace(M, next=entry(M.next, 3, 10)), 2, "next", 3),
    (replace(M, next=entry(M.next, 3, -1)), 2, "next", 3),
    (replace(M, previous=entry(M.previous, 3, 10)), 2, "previous", 3),
    (replace(M, twin=entry(M.twin, 0, -1)), 2, "twin", 0),
    (replace(M, origin=entry(M.origin, 9, 4)), 2, "origin", 9),
    (replace(M, face=entry(M.face, 9, 2)), 2, "face", 9),
    (replace(M, face=entry(M.face, 9, -2)), 2, "face", 9),
    (replace(M, of_vertex=entry(M.of_vertex, 3, 10)), 2, "of_vertex", 3),
    (replace(M, of_face=entry(M.of_face, 1, -1)), 2, "of_face", 1),
    (replace(M, next=entry(M.next, 3, 5)), 3, "next", 3),
    (replace(M, twin=entry(M.twin, 1, 4)), 4, "twin", 1),
    (replace(M, twin=(6, 1, *M.twin[2:])), 4, "twin", 1),
    (replace(M, origin=entry(M.origin, 9, 1)), 5, "origin", 5),
    (TWO_PAIRS, 5, "origin", 0),
    (replace(M, face=entry(M.face, 4, 0)), 6, "face", 3),
    (replace(M, of_face=(0, 1)), 6, "of_face", 1),
    (replace(M, of_face=(0,), face=(0,) * 6 + (-1,) * 4), 6, "of_face", 0),
    (replace(M, of_vertex=entry(M.of_vertex, 2, 8)), 7, "of_vertex", 2),
    (TWO_LENSES, 7, "of_vertex", 0),
    (replace(LENS, face=(-1,) * 4, of_face=()), 8, "face", 0),
    (replace(M, of_vertex=entry(M.of_vertex, 1, 1)), 8, "of_vertex", 1),
    (BOW_TIE, 8, "of_vertex", 0),
    (replace(M, previous=M.next), 3, "next", 0),
)


@pytest.mark.parametrize(("of", "clause", "array", "at"), FAULTS)
def test_each_fault(of: HalfEdges, clause: int, array: str, at: int) -> None:
    """Clauses: CPLX-HALFEDGE-2 … CPLX-HALFEDGE-8."""
    answer = half_edges(of)
    assert isinstance(answer, Rejected)
    assert (answer.clause, answer.where) == (
        Clause(f"CPLX-HALFEDGE-{clause}"),
        AtEntry(array, at),
    )
    if clause > 2:
        assert answer.reason is Reason.BROKEN_INVARIANT
    assert not is_half_edge_structure(of)


@pytest.mark.parametrize(
    ("of", "reason", "detail"),
    [
        (FAULTS[0][0], Reason.COUNT_MISMATCH, "9 entries, and 10 of next"),
        (FAULTS[4][0], Reason.INDEX_OUT_OF_RANGE, "10"),
        (FAULTS[13][0], Reason.BROKEN_INVARIANT, "previous of 5 is 4"),
        (FAULTS[14][0], Reason.BROKEN_INVARIANT, "twin of 4 is 8"),
        (FAULTS[18][0], Reason.BROKEN_INVARIANT, "the next has face 0"),
        (FAULTS[19][0], Reason.BROKEN_INVARIANT, "passes 3 of 3, with face 0"),
        (FAULTS[20][0], Reason.BROKEN_INVARIANT, "passes 3 of 6, with face 0"),
        (FAULTS[21][0], Reason.BROKEN_INVARIANT, "passes 2 of 3, with origin 3"),
        (FAULTS[22][0], Reason.BROKEN_INVARIANT, "passes 2 of 4, with origin 0"),
        (FAULTS[23][0], Reason.BROKEN_INVARIANT, "border on both sides"),
        (FAULTS[24][0], Reason.BROKEN_INVARIANT, "border half-edge 6 has the same origin"),
    ],
)
def test_what_is_said_of_a_fault(of: HalfEdges, reason: Reason, detail: str) -> None:
    """Clause: CPLX-HALFEDGE-2."""
    answer = half_edges(of)
    assert isinstance(answer, Rejected)
    assert (answer.reason, answer.detail) == (reason, detail)


def test_the_first_of_several_faults() -> None:
    """Clause: CPLX-HALFEDGE-18. Each fault added goes before those so far, at its lowest entry."""
    of = replace(M, of_vertex=entry(M.of_vertex, 0, M.of_vertex[1]))
    seen = [(Clause.CPLX_HALFEDGE_7, AtEntry("of_vertex", 0))]
    found = [half_edges(of)]
    of = replace(of, of_face=entry(M.of_face, 1, M.of_face[0]))
    seen.append((Clause.CPLX_HALFEDGE_6, AtEntry("of_face", 1)))
    found.append(half_edges(of))
    of = replace(of, face=entry(M.face, 0, 1 - M.face[0]))
    seen.append((Clause.CPLX_HALFEDGE_6, AtEntry("face", 0)))
    found.append(half_edges(of))
    of = replace(of, origin=entry(M.origin, 0, M.origin[M.next[0]]))
    seen.append((Clause.CPLX_HALFEDGE_5, AtEntry("origin", 0)))
    found.append(half_edges(of))
    of = replace(of, twin=entry(M.twin, 3, 3))
    seen.append((Clause.CPLX_HALFEDGE_4, AtEntry("twin", min(3, M.twin[3]))))
    found.append(half_edges(of))
    of = replace(of, previous=entry(M.previous, 5, 5))
    seen.append((Clause.CPLX_HALFEDGE_3, AtEntry("next", M.previous[5])))
    found.append(half_edges(of))
    answers = [(a.clause, a.where) for a in found if isinstance(a, Rejected)]
    assert answers == seen


def test_a_lens_is_a_map_and_no_polytope() -> None:
    """Two edges between two vertices: the invariant holds. CPLX-HALFEDGE-9, CPLX-HALFEDGE-10."""
    assert half_edges(LENS) == Accepted(LENS)
    assert is_half_edge_structure(LENS)
    assert polygons(LENS) == PolygonList(((0, 1),), 2)
    assert not is_regular(LENS)


def test_nothing_is_a_structure() -> None:
    """No arrays at all, and an isolated vertex. Clause: CPLX-HALFEDGE-9."""
    nothing = HalfEdges((), (), (), (), (), (), ())
    assert half_edges(nothing) == Accepted(nothing)
    assert is_half_edge_structure(nothing)
    assert cycles({}) == frozenset()
    lonely = replace(nothing, of_vertex=(0,))
    answer = half_edges(lonely)
    assert isinstance(answer, Rejected)
    assert answer.where == AtEntry("of_vertex", 0)
    assert not is_half_edge_structure(lonely)


def test_a_flip_by_hand() -> None:
    """Edge 1 – 2 becomes 0 – 3: half-edge 1 ran 1 → 2, and runs 3 → 0. CPLX-HALFEDGE-16."""
    answer = flip(MENDED, 1)
    assert isinstance(answer, Accepted)
    assert polygons(answer.value) == PolygonList(((3, 0, 1), (0, 3, 2)), 4)
    assert (answer.value.origin[1], answer.value.origin[3]) == (3, 0)
    assert answer.value.of_vertex == MENDED.of_vertex
    assert half_edges(answer.value) == answer


def test_a_flip_gives_vertices_another_half_edge() -> None:
    """Where the edge's own half-edges stood for its ends. Clause: CPLX-HALFEDGE-16."""
    faces = ((0, 1, 2), (1, 0, 3), (0, 2, 4), (2, 1, 4), (0, 4, 3), (1, 3, 4))
    built = from_polygons(PolygonList(faces, 5))
    assert isinstance(built, Accepted)
    assert built.value.of_vertex[:2] == (0, 1)
    answer = flip(built.value, 3)  # 1 → 0, between 2 and 3, that no face joins
    assert isinstance(answer, Accepted)
    assert half_edges(answer.value) == answer
    assert set(polygons(answer.value).faces) == {(2, 3, 1), (3, 2, 0), *faces[2:]}
    assert answer.value.of_vertex == (4, 1, 2, 5, 8)
    assert answer.value.of_face[:2] == (0, 3)


@pytest.mark.parametrize(
    ("of", "h", "detail"),
    [
        (PolygonList(((0, 1, 2), (2, 1, 3)), 4), 0, "a border edge"),
        (PolygonList(((0, 1, 2), (2, 1, 3)), 4), 6, "a border edge"),
        (PolygonList(((0, 1, 2), (2, 1, 4, 3)), 5), 1, "not between triangles"),
        (PolygonList(((0, 1, 2), (2, 1, 4, 3)), 5), 3, "not between triangles"),
        (
            PolygonList(((0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)), 4),
            0,
            "its new ends have a face in common",
        ),
        # a square has both new ends, which no edge joins
        (
            PolygonList(((0, 1, 2), (2, 1, 3), (4, 0, 2, 3)), 5),
            1,
            "its new ends have a face in common",
        ),
    ],
)
def test_no_flip(of: PolygonList, h: int, detail: str) -> None:
    """Clause: CPLX-HALFEDGE-16."""
    built = from_polygons(of)
    assert isinstance(built, Accepted)
    assert flip(built.value, h) == Rejected(
        Reason.OPERATOR_NOT_APPLICABLE, Clause.CPLX_HALFEDGE_16, AtEntry("twin", h), detail
    )


@pytest.mark.parametrize("h", [-1, 10])
def test_no_such_half_edge(h: int) -> None:
    """Clause: CPLX-HALFEDGE-16."""
    assert flip(MENDED, h) == Rejected(
        Reason.INDEX_OUT_OF_RANGE, Clause.CPLX_HALFEDGE_16, AtEntry("twin", h)
    )


def test_json() -> None:
    """Clause: CPLX-HALFEDGE-17."""
    assert read_half_edges(write_half_edges(MENDED)) == Accepted(MENDED)
    assert set(msgspec.json.decode(write_half_edges(MENDED), type=dict[str, list[int]])) == {
        *("next", "previous", "twin", "origin", "face", "of_vertex", "of_face")
    }
    broken = read_half_edges(write_half_edges(BOW_TIE))
    assert isinstance(broken, Rejected)
    assert broken.clause is Clause.CPLX_HALFEDGE_8


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"[]",
        b'{"next": []}',
        write_half_edges(MENDED).replace(b'"next"', b'"Next"'),
        write_half_edges(MENDED)[:-1] + b',"more":[]}',
        write_half_edges(MENDED).replace(b"[0,3]", b'[0,"3"]'),
        write_half_edges(MENDED).replace(b"[0,3]", b"[0,3.5]"),
        b"\xff",
        b'{"\xff":1}',
        b"[" * 100_000,
    ],
)
def test_unreadable_json(content: bytes) -> None:
    """Clause: CPLX-HALFEDGE-17."""
    answer = read_half_edges(content)
    assert isinstance(answer, Rejected)
    assert (answer.reason, answer.clause, answer.where) == (
        Reason.UNREADABLE_FILE,
        Clause.CPLX_HALFEDGE_17,
        WHOLE,
    )
    assert answer.detail
