"""One step of a script: the mesh after it, and what was done or why nothing was."""

from dataclasses import dataclass
from enum import StrEnum

from clers.complexes.face_list import FaceList
from clers.operators.effect import NO_EFFECT, Effect
from clers.operators.net import Triangle


class Obstacle(StrEnum):
    """Why an operator did nothing, as stages name it. Clauses: OPER-SCRIPT-2, OPER-FAMILY-3."""

    NO_CANDIDATE = "no-candidate"  # the mesh has no element of the kind asked for
    EDGE_EXISTS = "edge-exists"  # two vertices would be joined by two edges
    FACE_EXISTS = "face-exists"  # three vertices would carry two faces
    SHARED_VERTEX = "shared-vertex"  # two sides to be bridged meet at a vertex
    INNER_EDGE = "inner-edge"  # a cut that would not begin at a boundary curve
    WOULD_PINCH = "would-pinch"  # a star would fall into two fans
    LAST_FACE = "last-face"  # nothing would be left


@dataclass(frozen=True, slots=True)
class Did:
    """The operator was applied, with this effect. Clause: OPER-SCRIPT-3."""

    effect: Effect


@dataclass(frozen=True, slots=True)
class Idle:
    """The operator was not applicable; the mesh is unchanged. Clause: OPER-SCRIPT-2."""

    obstacle: Obstacle


Outcome = Did | Idle


@dataclass(frozen=True, slots=True)
class Step:
    """A mesh and the outcome of the operator that led to it. Clause: OPER-SCRIPT-2."""

    mesh: FaceList
    outcome: Outcome


def did(faces: list[Triangle], vertices: int, effect: Effect = NO_EFFECT) -> Step:
    """The step to a new mesh."""
    return Step(FaceList(tuple(faces), vertices), Did(effect))


def idle(mesh: FaceList, obstacle: Obstacle) -> Step:
    """The step that leaves the mesh as it is."""
    return Step(mesh, Idle(obstacle))


def renumbered(faces: list[Triangle], gone: set[int], vertices: int) -> list[Triangle]:
    """Close the gaps that vertices no longer used leave in the numbering, keeping its order.

    Clause: OPER-SCRIPT-8.
    """
    number: list[int] = []
    count = 0
    for v in range(vertices):
        number.append(count)
        count += v not in gone
    return [(number[a], number[b], number[c]) for a, b, c in faces]
