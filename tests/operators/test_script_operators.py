"""Each script operator on a mesh of a few faces, its result worked out by hand."""

from collections.abc import Iterable
from itertools import permutations

import pytest

from clers.complexes.face_list import FaceList
from clers.conventions.clause import Clause
from clers.operators.effect import NO_EFFECT, Effect
from clers.operators.script import (
    START,
    AddEar,
    AddHandle,
    AddTetrahedron,
    Bridge,
    CloseCurve,
    CutEdge,
    FillCorner,
    FlipEdge,
    JoinComponents,
    OpenCurve,
    Operator,
    Relabel,
    RemoveFace,
    RemoveStar,
    SplitEdge,
    SplitFace,
    apply,
)
from clers.operators.step import Did, Idle, Obstacle

ALL_ORDERS = tuple(permutations(range(5)))

TRIANGLE = FaceList(((0, 1, 2),), 3)
TWO = FaceList(((0, 1, 2), (1, 0, 3)), 4)
STRIP = FaceList(((0, 1, 2), (2, 1, 3), (2, 3, 4)), 5)
CUP = FaceList(START.faces[1:], 4)  # the tetrahedron without (0, 1, 2)
LONG = FaceList((*STRIP.faces, (4, 3, 5), (4, 5, 6)), 7)
APART = FaceList(((0, 1, 2), (3, 4, 5)), 6)
_RING = ((0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4), (2, 0, 3), (2, 3, 5))
SLEEVE = FaceList((*_RING, *((a + 3, b + 3, c + 3) for a, b, c in _RING)), 9)


def up_to_turns(faces: Iterable[tuple[int, int, int]]) -> frozenset[tuple[int, int, int]]:
    """The faces without their order, each begun with its lowest vertex."""
    return frozenset(min((a, b, c), (b, c, a), (c, a, b)) for a, b, c in faces)


def test_start() -> None:
    """OPER-SCRIPT-1."""
    assert FaceList(((0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)), 4) == START


SPLIT = FaceList(((0, 1, 4), (0, 3, 1), (0, 2, 3), (1, 3, 2), (1, 2, 4), (2, 0, 4)), 5)

CASES: list[tuple[Clause, str, Operator, FaceList, FaceList, Effect]] = [
    (Clause.OPER_REFINE_1, "", SplitFace(0), START, SPLIT, NO_EFFECT),
    (
        Clause.OPER_REFINE_2,
        "inside",
        SplitEdge(0),
        START,
        FaceList(((0, 4, 2), (4, 1, 2), (1, 4, 3), (4, 0, 3), (0, 2, 3), (1, 3, 2)), 5),
        NO_EFFECT,
    ),
    (
        Clause.OPER_REFINE_2,
        "border",
        SplitEdge(1),
        TRIANGLE,
        FaceList(((1, 3, 0), (3, 2, 0)), 4),
        NO_EFFECT,
    ),
    (
        Clause.OPER_REFINE_3,
        "",
        FlipEdge(0),
        SPLIT,
        FaceList(((4, 0, 3), (3, 1, 4), (0, 2, 3), (1, 3, 2), (1, 2, 4), (2, 0, 4)), 5),
        NO_EFFECT,
    ),
    (Clause.OPER_REFINE_4, "seed 0", Relabel(0), START, START, NO_EFFECT),
    (Clause.OPER_BORDER_1, "", AddEar(0), TRIANGLE, FaceList(((0, 1, 2), (1, 0, 3)), 4), NO_EFFECT),
    (
        Clause.OPER_BORDER_2,
        "",
        FillCorner(1),
        TWO,
        FaceList(((0, 1, 2), (1, 0, 3), (3, 0, 2)), 4),
        NO_EFFECT,
    ),
    (
        Clause.OPER_BORDER_2,
        "last",
        FillCorner(0),
        CUP,
        FaceList((*CUP.faces, (0, 1, 2)), 4),
        Effect(curves=-1),
    ),
    (
        Clause.OPER_BORDER_3,
        "",
        CloseCurve(0),
        TRIANGLE,
        FaceList(((0, 1, 2), (1, 0, 3), (2, 1, 3), (0, 2, 3)), 4),
        Effect(curves=-1),
    ),
    (Clause.OPER_BORDER_4, "no room needed", OpenCurve(0), START, CUP, Effect(curves=1)),
    (
        Clause.OPER_BORDER_4,
        "two vertices",
        OpenCurve(0),
        CUP,
        FaceList(((0, 2, 3), (1, 3, 2), (1, 0, 4), (3, 1, 4), (0, 3, 5), (4, 0, 5)), 6),
        Effect(curves=1),
    ),
    (Clause.OPER_BORDER_5, "inside", RemoveFace(0), START, CUP, Effect(curves=1)),
    (Clause.OPER_BORDER_5, "ear", RemoveFace(0), TWO, FaceList(((1, 0, 2),), 3), NO_EFFECT),
    (
        Clause.OPER_BORDER_5,
        "one side free",
        RemoveFace(0),
        CUP,
        FaceList(((0, 2, 3), (1, 3, 2)), 4),
        NO_EFFECT,
    ),
    (
        Clause.OPER_BORDER_5,
        "component",
        RemoveFace(1),
        APART,
        TRIANGLE,
        Effect(components=-1, curves=-1),
    ),
    (Clause.OPER_BORDER_6, "", RemoveStar(0), START, FaceList(((0, 2, 1),), 3), Effect(curves=1)),
    (
        Clause.OPER_BORDER_7,
        "slit",
        CutEdge(0),
        CUP,
        FaceList(((4, 3, 1), (0, 2, 3), (1, 3, 2)), 5),
        NO_EFFECT,
    ),
    (
        Clause.OPER_BORDER_7,
        "apart",
        CutEdge(0),
        TWO,
        FaceList(((4, 5, 2), (1, 0, 3)), 6),
        Effect(components=1, curves=1),
    ),
    (
        Clause.OPER_TUBE_2,
        "",
        AddTetrahedron(),
        TRIANGLE,
        FaceList(((0, 1, 2), (3, 4, 5), (3, 6, 4), (3, 5, 6), (4, 6, 5)), 7),
        Effect(components=1),
    ),
    (
        Clause.OPER_TUBE_4,
        "",
        JoinComponents(0, 0),
        APART,
        # (0, 1, 2) against (3, 5, 4): 0 by 3, 1 by 5, 2 by 4.
        FaceList(((0, 1, 5), (0, 5, 3), (1, 2, 4), (1, 4, 5), (2, 0, 3), (2, 3, 4)), 6),
        Effect(components=-1),
    ),
    (
        Clause.OPER_TUBE_5,
        "components",
        Bridge(0, 3),
        APART,
        FaceList(((0, 1, 2), (3, 4, 5), (1, 0, 4), (1, 4, 3)), 6),
        Effect(components=-1, curves=-1),
    ),
    (
        # The border runs 0→1→3→5→6→4→2→0; its sides, in the order of the faces, are
        # 0→1, 2→0, 1→3, 4→2, 3→5, 5→6, 6→4. Afterwards 1→3→5→1 and 0→6→4→2→0.
        Clause.OPER_TUBE_5,
        "one curve",
        Bridge(0, 5),
        LONG,
        FaceList((*LONG.faces, (1, 0, 6), (1, 6, 5)), 7),
        Effect(curves=1),
    ),
    (
        # Sides 0→1, 1→2, 2→0 on one curve; 7→6, 8→7, 6→8 on the other.
        Clause.OPER_TUBE_5,
        "two curves",
        Bridge(0, 3),
        SLEEVE,
        FaceList((*SLEEVE.faces, (1, 0, 6), (1, 6, 7)), 9),
        Effect(genus=1, curves=-1),
    ),
]


@pytest.mark.parametrize(
    ("operator", "before", "after", "effect"),
    [case[2:] for case in CASES],
    ids=[f"{case[0]} {case[1]}".strip() for case in CASES],
)
def test_by_hand(operator: Operator, before: FaceList, after: FaceList, effect: Effect) -> None:
    """The clause is the test's id; also OPER-SCRIPT-2 and OPER-SCRIPT-3."""
    step = apply(operator, before)
    assert step.outcome == Did(effect)
    assert step.mesh.vertices == after.vertices
    assert up_to_turns(step.mesh.faces) == up_to_turns(after.faces)


IDLE: list[tuple[Operator, FaceList, Obstacle]] = [
    (FlipEdge(0), TRIANGLE, Obstacle.NO_CANDIDATE),
    (FlipEdge(0), START, Obstacle.EDGE_EXISTS),
    (AddEar(0), START, Obstacle.NO_CANDIDATE),
    (FillCorner(0), START, Obstacle.NO_CANDIDATE),
    (FillCorner(0), TWO, Obstacle.EDGE_EXISTS),
    (FillCorner(0), TRIANGLE, Obstacle.FACE_EXISTS),
    (CloseCurve(0), START, Obstacle.NO_CANDIDATE),
    (RemoveFace(0), TRIANGLE, Obstacle.LAST_FACE),
    (RemoveFace(1), STRIP, Obstacle.WOULD_PINCH),
    (RemoveStar(0), TRIANGLE, Obstacle.NO_CANDIDATE),
    (RemoveStar(0), CUP, Obstacle.WOULD_PINCH),
    (CutEdge(0), TRIANGLE, Obstacle.NO_CANDIDATE),
    (CutEdge(0), START, Obstacle.INNER_EDGE),
    (AddHandle(0, 0), TRIANGLE, Obstacle.NO_CANDIDATE),
    (JoinComponents(0, 0), START, Obstacle.NO_CANDIDATE),
    (Bridge(0, 0), START, Obstacle.NO_CANDIDATE),
    (Bridge(0, 1), TRIANGLE, Obstacle.SHARED_VERTEX),
    (Bridge(0, 2), TWO, Obstacle.EDGE_EXISTS),
]


@pytest.mark.parametrize(("operator", "mesh", "obstacle"), IDLE)
def test_obstacle(operator: Operator, mesh: FaceList, obstacle: Obstacle) -> None:
    """OPER-SCRIPT-2; and OPER-REFINE-3, OPER-BORDER-2, -5, -6, -7, OPER-TUBE-3, -4, -5."""
    step = apply(operator, mesh)
    assert step.outcome == Idle(obstacle)
    assert step.mesh is mesh


def test_handle_makes_just_enough_room() -> None:
    """OPER-TUBE-1, OPER-TUBE-3: two faces of a tetrahedron need four new vertices between them.

    Their inner faces are (c, p, q) and (d, s, t) then, c and d the corners that only one has: any
    room of fewer vertices keeps two corners of the tetrahedron in one face, or c beside a kept one.
    """
    step = apply(AddHandle(0, 0), START)
    assert step.outcome == Did(Effect(genus=1))
    assert (step.mesh.vertices, len(step.mesh.faces)) == (8, 16)


def test_handle_without_new_vertices() -> None:
    """OPER-TUBE-3: faces with nothing in common and nothing between them need no room."""
    odd_and_even = [(k, k + 1, k + 2) if k % 2 == 0 else (k + 1, k, k + 2) for k in range(7)]
    step = apply(AddHandle(0, 5), FaceList(tuple(odd_and_even), 9))  # (0, 1, 2) and (6, 7, 8)
    assert step.outcome == Did(Effect(genus=1))
    assert (step.mesh.vertices, len(step.mesh.faces)) == (9, 7 - 2 + 6)


def test_relabel_keeps_the_surface() -> None:
    """OPER-REFINE-4: on the strip the permutation can be read off, and it explains every face."""
    step = apply(Relabel(1), STRIP)
    assert step.outcome == Did(NO_EFFECT)
    assert step.mesh != STRIP
    assert any(
        up_to_turns(step.mesh.faces)
        == up_to_turns((number[a], number[b], number[c]) for a, b, c in STRIP.faces)
        for number in ALL_ORDERS
    )
