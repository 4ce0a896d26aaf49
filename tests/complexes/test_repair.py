"""Repairs by hand: what each does, what it says, what it refuses."""

import pytest
from golden_complexes import (
    ANNULUS,
    BOOK,
    BOW_TIE,
    KLEIN_BOTTLE,
    MOEBIUS_5,
    PILLOW,
    PROJECTIVE_PLANE_6,
    TETRAHEDRON,
    TRIANGLE,
    TWO_AT_A_VERTEX,
    TWO_AT_AN_EDGE,
    accepted,
    beside,
)

from clers.complexes.face_list import FaceList, Limits
from clers.complexes.repair import (
    GONE,
    Copied,
    Dropped,
    Repaired,
    Turned,
    drop_isolated,
    orient,
    split_pinched,
    then,
)
from clers.complexes.topology import components
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtEdge, AtFace, Where


def done(answer: Accepted[Repaired] | Rejected) -> Repaired:
    """What an accepted repair did."""
    assert isinstance(answer, Accepted), answer
    return answer.value


def test_orient_keeps_the_lowest_face_of_each_component() -> None:
    """Clauses: CPLX-REPAIR-1, CPLX-REPAIR-2."""
    turned = FaceList(((0, 2, 1), (0, 3, 1), (1, 3, 2), (2, 3, 0)), 4)
    repaired = done(orient(beside(turned, TRIANGLE)))
    # The inside-out face 0 stays, so the three others turn.
    assert repaired.face_list.faces == ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3), (4, 5, 6))
    assert repaired.actions == (Turned(1), Turned(2), Turned(3))
    assert repaired.source == repaired.target == (0, 1, 2, 3, 4, 5, 6)
    assert repaired.sentence() == "face 1 turned over; face 2 turned over; face 3 turned over."
    accepted(repaired.face_list)


@pytest.mark.parametrize(
    ("given", "face"),
    [
        (MOEBIUS_5, 4),  # four of its triangles are a strip; the fifth closes it the wrong way
        (beside(TETRAHEDRON, MOEBIUS_5, TETRAHEDRON), 8),
        (FaceList((MOEBIUS_5.faces[0], *TETRAHEDRON.faces), 5), None),
    ],
)
def test_one_sided_strips_cannot_be_oriented(given: FaceList, face: int | None) -> None:
    """Clause: CPLX-REPAIR-3."""
    answer = orient(given)
    assert isinstance(answer, Rejected)
    if face is None:  # here the strip's triangle repeats one of the tetrahedron's
        assert answer.reason == Reason.DUPLICATE_FACE
    else:
        assert (answer.reason, answer.clause, answer.where) == (
            Reason.NON_ORIENTABLE,
            Clause.CPLX_REPAIR_3,
            AtFace(face),
        )


@pytest.mark.parametrize("given", [PROJECTIVE_PLANE_6, KLEIN_BOTTLE])
def test_closed_one_sided_surfaces_cannot_be_oriented(given: FaceList) -> None:
    """Clause: CPLX-REPAIR-3."""
    answer = orient(given)
    assert isinstance(answer, Rejected)
    assert answer.reason == Reason.NON_ORIENTABLE


@pytest.mark.parametrize(
    ("given", "reason", "where"),
    [
        (BOOK, Reason.EDGE_WITH_THREE_FACES, AtEdge(0, 1, 2)),
        (TWO_AT_AN_EDGE, Reason.EDGE_WITH_THREE_FACES, AtEdge(0, 1, 4)),
        (PILLOW, Reason.DUPLICATE_FACE, AtFace(1)),
        (FaceList(((0, 1, 1),), 2), Reason.REPEATED_INDEX, AtFace(0)),
    ],
)
def test_what_leaves_a_choice_is_not_repaired(
    given: FaceList, reason: Reason, where: Where
) -> None:
    """Clauses: CPLX-REPAIR-2, CPLX-REPAIR-4; dropping looks at vertices alone, CPLX-REPAIR-5."""
    for answer in (orient(given), split_pinched(given)):
        assert isinstance(answer, Rejected)
        assert (answer.reason, answer.where) == (reason, where)
    assert done(drop_isolated(given)).face_list == given


def test_bad_counts_and_indices_are_refused_by_all() -> None:
    """Clauses: CPLX-REPAIR-2, CPLX-REPAIR-4, CPLX-REPAIR-5."""
    for repair in (orient, split_pinched, drop_isolated):
        for given, limits, reason in (
            (FaceList((), 3), Limits(9, 9), Reason.EMPTY_MESH),
            (FaceList(((0, 1, 3),), 3), Limits(9, 9), Reason.INDEX_OUT_OF_RANGE),
            (TETRAHEDRON, Limits(3, 9), Reason.TOO_MANY_FACES),
            (TETRAHEDRON, Limits(9, 3), Reason.TOO_MANY_VERTICES),
        ):
            answer = repair(given, limits)
            assert isinstance(answer, Rejected)
            assert answer.reason == reason


def test_split_bow_tie() -> None:
    """Clause: CPLX-REPAIR-4."""
    repaired = done(split_pinched(BOW_TIE))
    assert repaired == Repaired(
        FaceList(((0, 1, 2), (5, 3, 4)), 6),
        (0, 1, 2, 3, 4, 0),
        (0, 1, 2, 3, 4),
        (Copied(0, 5),),
    )
    assert repaired.sentence() == "vertex 0 copied as 5."


def test_copies_are_numbered_by_vertex_and_then_by_face() -> None:
    """Clause: CPLX-REPAIR-4. Five triangles; 1 is in three of them, 0 and 2 in two each."""
    given = FaceList(((2, 3, 4), (1, 5, 6), (1, 0, 7), (0, 8, 9), (2, 1, 10)), 11)
    repaired = done(split_pinched(given))
    assert repaired.source[11:] == (0, 1, 1, 2)
    assert repaired.face_list.faces == (
        (2, 3, 4),
        (1, 5, 6),
        (12, 0, 7),
        (11, 8, 9),
        (14, 13, 10),
    )
    assert len(components(accepted(repaired.face_list))) == 5


def test_split_two_tetrahedra() -> None:
    """Clause: CPLX-REPAIR-4."""
    repaired = done(split_pinched(TWO_AT_A_VERTEX))
    parts = components(accepted(repaired.face_list))
    assert [(part.vertices, part.faces, part.genus) for part in parts] == [(4, 4, 0), (4, 4, 0)]
    assert repaired.face_list.faces[4] == (7, 4, 5)


def test_drop_isolated() -> None:
    """Clause: CPLX-REPAIR-5. The errata's annulus becomes the band but for names."""
    repaired = done(drop_isolated(ANNULUS))
    assert repaired.face_list.faces[0] == (2, 5, 4)
    assert repaired.source == (0, 1, 3, 4, 5, 6)
    assert repaired.target == (0, 1, GONE, 2, 3, 4, 5)
    assert repaired.actions == (Dropped(2),)
    assert repaired.sentence() == "vertex 2 dropped."
    (part,) = components(accepted(repaired.face_list))
    assert (part.faces, part.vertices, part.curves, part.genus) == (6, 6, 2, 0)


def test_sentences() -> None:
    """Clause: CPLX-REPAIR-1."""
    assert done(orient(TETRAHEDRON)).sentence() == "Nothing to repair."
    many = done(drop_isolated(FaceList(((0, 1, 2),), 13)))
    assert many.sentence().startswith("vertex 3 dropped; vertex 4 dropped; ")
    assert many.sentence().endswith("vertex 10 dropped; and 2 more.")


def test_repairs_in_a_row() -> None:
    """Clauses: CPLX-REPAIR-1, CPLX-REPAIR-6. Positions are found through `source` of the whole."""
    given = FaceList(((1, 2, 3), (1, 5, 4), (5, 1, 6), (6, 5, 4)), 7)
    split = done(split_pinched(given))
    assert split.face_list.faces == ((1, 2, 3), (7, 5, 4), (5, 7, 6), (6, 5, 4))
    dropped = done(drop_isolated(split.face_list))
    whole = then(split, dropped)
    assert whole.face_list.faces == ((0, 1, 2), (6, 4, 3), (4, 6, 5), (5, 4, 3))
    assert whole.source == (1, 2, 3, 4, 5, 6, 1)
    assert whole.target == (GONE, 0, 1, 2, 3, 4, 5)
    assert whole.actions == (Copied(1, 7), Dropped(0))
