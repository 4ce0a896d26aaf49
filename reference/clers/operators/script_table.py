"""The table of what each operator changes, as a predicate; the operators never look at it."""

from typing import assert_never

from clers.operators.effect import NO_EFFECT, Effect
from clers.operators.script import (
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
)


def in_table(operator: Operator, vertices: int, faces: int, effect: Effect) -> bool:  # noqa: C901  (one case an operator)
    """Are these changes a row of the table? Clause: OPER-SCRIPT-5."""
    match operator:
        case SplitFace():
            return (vertices, faces, effect) == (1, 2, NO_EFFECT)
        case SplitEdge():
            return (vertices, effect) == (1, NO_EFFECT) and faces in (1, 2)
        case FlipEdge() | Relabel():
            return (vertices, faces, effect) == (0, 0, NO_EFFECT)
        case AddEar():
            return (vertices, faces, effect) == (1, 1, NO_EFFECT)
        case FillCorner():
            return (vertices, faces) == (0, 1) and effect in (NO_EFFECT, Effect(curves=-1))
        case CloseCurve():
            return vertices == 1 and faces >= 3 and effect == Effect(curves=-1)
        case OpenCurve():
            return vertices in range(4) and (faces, effect) == (2 * vertices - 1, Effect(curves=1))
        case RemoveFace():
            return faces == -1 and (vertices, effect) in (
                (0, NO_EFFECT),
                (0, Effect(curves=1)),
                (-1, NO_EFFECT),
                (-3, Effect(components=-1, curves=-1)),
            )
        case RemoveStar():
            return vertices == -1 and faces <= -3 and effect == Effect(curves=1)
        case CutEdge():
            return faces == 0 and (vertices, effect) in (
                (1, NO_EFFECT),
                (2, Effect(curves=-1)),
                (2, Effect(components=1, curves=1)),
                (2, Effect(genus=-1, curves=1)),
            )
        case AddTetrahedron():
            return (vertices, faces, effect) == (4, 4, Effect(components=1))
        case AddHandle():
            return vertices in range(7) and (faces, effect) == (2 * vertices + 4, Effect(genus=1))
        case JoinComponents():
            return (vertices, faces, effect) == (0, 4, Effect(components=-1))
        case Bridge():
            return (vertices, faces) == (0, 2) and effect in (
                Effect(components=-1, curves=-1),
                Effect(curves=1),
                Effect(genus=1, curves=-1),
            )
        case _:
            assert_never(operator)
