"""Every rejection by hand: reason, clause, element; their order; and all small face lists."""

from itertools import product

import pytest
from golden_complexes import (
    ANNULUS,
    BAND,
    BOOK,
    BOW_TIE,
    DOUBLE_TORUS,
    KLEIN_BOTTLE,
    MOEBIUS_5,
    OCTAHEDRON,
    PILLOW,
    PROJECTIVE_PLANE_6,
    SQUARE,
    TETRAHEDRON,
    TORUS_7,
    TORUS_9,
    TRIANGLE,
    TWO_AT_A_VERTEX,
    TWO_AT_AN_EDGE,
    accepted,
)

from clers.complexes.corner_table import face_list, surface, surface_of_indices
from clers.complexes.definition import first_fault, is_coherent_surface
from clers.complexes.face_list import DEFAULT_LIMITS, FaceList, Limits
from clers.complexes.index_list import IndexList, index_list, listed_faces
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtEdge, AtFace, AtVertex, Where

EMPTY = FaceList((), 0)

FAULTS: tuple[tuple[str, FaceList, Reason, Clause, Where], ...] = (
    ("nothing", EMPTY, Reason.EMPTY_MESH, Clause.CPLX_REJECT_1, WHOLE),
    ("no face", FaceList((), 3), Reason.EMPTY_MESH, Clause.CPLX_REJECT_1, WHOLE),
    (
        "an index too high",
        FaceList(((0, 1, 2), (0, 2, 4)), 4),
        Reason.INDEX_OUT_OF_RANGE,
        Clause.CPLX_REJECT_3,
        AtFace(1),
    ),
    (
        "a negative index, which is no index from the end",
        FaceList(((0, 1, 2), (0, 2, -1)), 4),
        Reason.INDEX_OUT_OF_RANGE,
        Clause.CPLX_REJECT_3,
        AtFace(1),
    ),
    (
        "fewer than no vertices",
        FaceList(((0, 1, 2),), -1),
        Reason.INDEX_OUT_OF_RANGE,
        Clause.CPLX_REJECT_3,
        AtFace(0),
    ),
    (
        "one vertex twice in a face, neighbours in it",
        FaceList(((0, 1, 2), (3, 2, 2)), 4),
        Reason.REPEATED_INDEX,
        Clause.CPLX_REJECT_4,
        AtFace(1),
    ),
    (
        "one vertex twice in a face, first and last",
        FaceList(((0, 1, 2), (2, 3, 2)), 4),
        Reason.REPEATED_INDEX,
        Clause.CPLX_REJECT_4,
        AtFace(1),
    ),
    (
        "a face given again, rotated",
        FaceList(((0, 1, 2), (0, 2, 3), (1, 2, 0), (3, 0, 2)), 4),
        Reason.DUPLICATE_FACE,
        Clause.CPLX_REJECT_5,
        AtFace(2),
    ),
    ("two sides of one face", PILLOW, Reason.DUPLICATE_FACE, Clause.CPLX_REJECT_5, AtFace(1)),
    (
        "a book of three pages",
        BOOK,
        Reason.EDGE_WITH_THREE_FACES,
        Clause.CPLX_REJECT_6,
        AtEdge(0, 1, 2),
    ),
    (
        "two tetrahedra at an edge",
        TWO_AT_AN_EDGE,
        Reason.EDGE_WITH_THREE_FACES,
        Clause.CPLX_REJECT_6,
        AtEdge(0, 1, 4),
    ),
    (
        "two faces that disagree",
        FaceList(((0, 1, 2), (0, 1, 3)), 4),
        Reason.EDGE_TWICE_IN_ONE_DIRECTION,
        Clause.CPLX_REJECT_7,
        AtEdge(0, 1, 1),
    ),
    (
        "a Möbius band: faces 0 and 1 run 1 → 2 both",
        MOEBIUS_5,
        Reason.EDGE_TWICE_IN_ONE_DIRECTION,
        Clause.CPLX_REJECT_7,
        AtEdge(1, 2, 1),
    ),
    (
        "a projective plane: its faces 0 and 5 run 1 → 2 both",
        PROJECTIVE_PLANE_6,
        Reason.EDGE_TWICE_IN_ONE_DIRECTION,
        Clause.CPLX_REJECT_7,
        AtEdge(1, 2, 5),
    ),
    ("a bow tie", BOW_TIE, Reason.PINCHED_VERTEX, Clause.CPLX_REJECT_8, AtVertex(0)),
    (
        "two tetrahedra at a vertex",
        TWO_AT_A_VERTEX,
        Reason.PINCHED_VERTEX,
        Clause.CPLX_REJECT_8,
        AtVertex(0),
    ),
    (
        "a vertex between the others that no face names",
        ANNULUS,
        Reason.ISOLATED_VERTEX,
        Clause.CPLX_REJECT_9,
        AtVertex(2),
    ),
)


@pytest.mark.parametrize(
    ("given", "reason", "clause", "where"),
    [fault[1:] for fault in FAULTS],
    ids=[fault[0] for fault in FAULTS],
)
def test_fault_is_named(given: FaceList, reason: Reason, clause: Clause, where: Where) -> None:
    for answer in (surface(given), first_fault(given)):
        assert isinstance(answer, Rejected)
        assert (answer.reason, answer.clause, answer.where) == (reason, clause, where)
    assert not is_coherent_surface(given)


@pytest.mark.parametrize("bad", [-1, -4, 4, 1 << 80])
def test_an_index_is_checked_at_each_corner(bad: int) -> None:
    """Clause: CPLX-REJECT-3."""
    for face in ((bad, 2, 3), (0, bad, 3), (0, 2, bad)):
        answer = surface(FaceList(((0, 1, 2), face), 4))
        assert isinstance(answer, Rejected)
        assert (answer.reason, answer.where) == (Reason.INDEX_OUT_OF_RANGE, AtFace(1))


def test_klein_bottle_disagrees() -> None:
    """Clause: CPLX-REJECT-7. Which edge is another matter: definition and algorithm agree on it."""
    got, expected = surface(KLEIN_BOTTLE), first_fault(KLEIN_BOTTLE)
    assert isinstance(got, Rejected)
    assert isinstance(expected, Rejected)
    assert got.reason == expected.reason == Reason.EDGE_TWICE_IN_ONE_DIRECTION
    assert got.where == expected.where


@pytest.mark.parametrize(
    "given",
    [TRIANGLE, SQUARE, TETRAHEDRON, OCTAHEDRON, BAND, TORUS_7, TORUS_9, DOUBLE_TORUS],
)
def test_good_meshes_are_accepted(given: FaceList) -> None:
    """Clauses: CPLX-INPUT-1, CPLX-INPUT-2, CPLX-INPUT-4."""
    assert first_fault(given) is None
    assert is_coherent_surface(given)
    assert face_list(accepted(given)) == given


def test_faults_are_reported_in_the_order_of_their_clauses() -> None:
    """From step to step a fault is added that goes before those so far.

    Clauses: CONV-RESULT-5, CPLX-INPUT-2.
    """
    steps: tuple[tuple[Reason, tuple[tuple[int, int, int], ...]], ...] = (
        (Reason.ISOLATED_VERTEX, ((0, 1, 2), (0, 2, 3))),
        (Reason.PINCHED_VERTEX, ((4, 5, 6), (4, 7, 8))),
        (Reason.EDGE_TWICE_IN_ONE_DIRECTION, ((3, 0, 9),)),
        (Reason.EDGE_WITH_THREE_FACES, ((0, 3, 10),)),
        (Reason.DUPLICATE_FACE, ((1, 2, 0),)),
        (Reason.REPEATED_INDEX, ((1, 1, 2),)),
        (Reason.INDEX_OUT_OF_RANGE, ((0, 1, 12),)),
    )
    mesh: tuple[tuple[int, int, int], ...] = ()
    for reason, more in steps:
        mesh += more
        answer = surface(FaceList(mesh, 12))
        assert isinstance(answer, Rejected)
        assert answer.reason == reason
    few = surface(FaceList(mesh, 12), Limits(len(mesh) - 1, 11))
    assert isinstance(few, Rejected)
    assert few.reason == Reason.TOO_MANY_FACES


def test_limits() -> None:
    """Clauses: CPLX-INPUT-3, CPLX-REJECT-2."""
    assert (DEFAULT_LIMITS.faces, DEFAULT_LIMITS.vertices) == (67108864, 67108864)
    assert surface(SQUARE, Limits(2, 4)) == surface(SQUARE)
    faces = surface(SQUARE, Limits(1, 4))
    assert isinstance(faces, Rejected)
    assert faces.line() == (
        "limit: too-many-faces of the whole input [CPLX-REJECT-2]: 2 faces, the limit is 1"
    )
    vertices = surface(SQUARE, Limits(2, 3))
    assert isinstance(vertices, Rejected)
    assert vertices.reason == Reason.TOO_MANY_VERTICES
    assert vertices.clause == Clause.CPLX_REJECT_2
    assert first_fault(SQUARE, Limits(2, 4)) is None
    many = Rejected(Reason.TOO_MANY_FACES, Clause.CPLX_REJECT_2, WHOLE)
    assert first_fault(SQUARE, Limits(1, 3)) == many
    assert first_fault(SQUARE, Limits(2, 3)) == Rejected(
        Reason.TOO_MANY_VERTICES, Clause.CPLX_REJECT_2, WHOLE
    )


@pytest.mark.parametrize(("vertices", "surfaces"), [(4, 6), (5, 30 * 6)])
def test_all_lists_of_four_faces(vertices: int, surfaces: int) -> None:
    """Clause: CPLX-INPUT-2. Exhaustive but for names: the first face is 0 1 2.

    Four triangles on four vertices are a surface only as a tetrahedron: three others in 3! orders.
    On five they are a wheel, 5 hubs times 4!/4 oriented rims, or a triangle with a vertex in it and
    a fourth triangle outside, 5 inner vertices times 4 outer ones times 2 orientations times 3
    edges. Of these 30 + 120 surfaces each of the 20 oriented triangles is in 4/20, that is in 30.
    """
    triangles = [
        (a, b, c) for a, b, c in product(range(vertices), repeat=3) if a < min(b, c) and b != c
    ]
    found = 0
    for rest in product(triangles, repeat=3):
        given = FaceList(((0, 1, 2), *rest), vertices)
        expected, got = first_fault(given), surface(given)
        if isinstance(got, Accepted):
            found += 1
            assert expected is None
        else:
            assert expected is not None
            assert (got.reason, got.where) == (expected.reason, expected.where)
    assert found == surfaces


def test_index_lists_by_hand() -> None:
    """Clause: CPLX-INPUT-5."""
    buffer = bytes.fromhex("00000000 01000000 02000000 ffffffff 00010000 00000080")
    found = index_list(buffer, 4)
    assert found == Accepted(IndexList(buffer, 4))
    assert IndexList(buffer, 4).faces == 2
    faces = ((0, 1, 2), (0xFFFF_FFFF, 0x100, 0x8000_0000))
    assert listed_faces(IndexList(buffer, 4)) == FaceList(faces, 4)
    assert index_list(b"", 0) == Accepted(IndexList(b"", 0))
    for length in (1, 11, 13, 23):
        told = Rejected(
            Reason.NOT_TRIANGLES, Clause.CPLX_INPUT_5, detail=f"{length} bytes, a face has 12"
        )
        assert index_list(buffer[:length], 4) == told


@pytest.mark.parametrize(("name", "given", "reason", "clause", "where"), FAULTS)
def test_faults_of_index_lists(
    name: str, given: FaceList, reason: Reason, clause: Clause, where: Where
) -> None:
    """Clause: CPLX-INPUT-6."""
    buffer = b"".join((v % 2**32).to_bytes(4, "little") for face in given.faces for v in face)
    found = surface_of_indices(IndexList(buffer, given.vertices))
    assert isinstance(found, Rejected), name
    assert (found.reason, found.clause, found.where) == (reason, clause, where)


def test_limits_of_index_lists() -> None:
    """Clause: CPLX-INPUT-3."""
    square = IndexList(bytes.fromhex("000000000100000002000000000000000200000003000000"), 4)
    assert isinstance(surface_of_indices(square, Limits(2, 4)), Accepted)
    for limits in (Limits(1, 4), Limits(2, 3)):
        assert isinstance(surface_of_indices(square, limits), Rejected)
