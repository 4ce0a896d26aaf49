"""Scripts: surfaces as the result of operators, so that a smaller script is a smaller surface.

Each operator is total on surfaces. It names its elements by integers, taken modulo the number of
elements it could name, so that every integer is a choice; and where it would break the surface it
does nothing and says why.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final, assert_never

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted, Rejected
from clers.operators.border import (
    add_ear,
    close_curve,
    cut_edge,
    fill_corner,
    open_curve,
    remove_face,
    remove_star,
)
from clers.operators.step import Step
from clers.operators.subdivide import flip_edge, relabel, split_edge, split_face
from clers.operators.tube import (
    add_handle,
    add_tetrahedron,
    bridge,
    join_components,
    tetrahedron,
)


@dataclass(frozen=True, slots=True)
class SplitFace:
    """A vertex into a face. Clause: OPER-REFINE-1."""

    face: int


@dataclass(frozen=True, slots=True)
class SplitEdge:
    """A vertex on an edge. Clause: OPER-REFINE-2."""

    edge: int


@dataclass(frozen=True, slots=True)
class FlipEdge:
    """An edge into the other diagonal of its two faces. Clause: OPER-REFINE-3."""

    edge: int


@dataclass(frozen=True, slots=True)
class Relabel:
    """Vertices, faces and turns of faces permuted. Clause: OPER-REFINE-4."""

    seed: int


@dataclass(frozen=True, slots=True)
class AddEar:
    """A triangle with a new vertex on a border side. Clause: OPER-BORDER-1."""

    side: int


@dataclass(frozen=True, slots=True)
class FillCorner:
    """A triangle on two consecutive border sides. Clause: OPER-BORDER-2."""

    side: int


@dataclass(frozen=True, slots=True)
class CloseCurve:
    """A cone over a boundary curve. Clause: OPER-BORDER-3."""

    curve: int


@dataclass(frozen=True, slots=True)
class OpenCurve:
    """A new boundary curve inside a face, or in its place. Clause: OPER-BORDER-4."""

    face: int


@dataclass(frozen=True, slots=True)
class RemoveFace:
    """A face away, where that pinches nothing. Clause: OPER-BORDER-5."""

    face: int


@dataclass(frozen=True, slots=True)
class RemoveStar:
    """A vertex and its faces away. Clause: OPER-BORDER-6."""

    vertex: int


@dataclass(frozen=True, slots=True)
class CutEdge:
    """A cut along an edge that begins at a boundary curve. Clause: OPER-BORDER-7."""

    edge: int


@dataclass(frozen=True, slots=True)
class AddTetrahedron:
    """A new component. Clause: OPER-TUBE-2."""


@dataclass(frozen=True, slots=True)
class AddHandle:
    """A tube between two faces of one component. Clause: OPER-TUBE-3."""

    first: int
    second: int


@dataclass(frozen=True, slots=True)
class JoinComponents:
    """A tube between two faces of two components. Clause: OPER-TUBE-4."""

    first: int
    second: int


@dataclass(frozen=True, slots=True)
class Bridge:
    """Two faces between two border sides. Clause: OPER-TUBE-5."""

    first: int
    second: int


Operator = (
    SplitFace
    | SplitEdge
    | FlipEdge
    | Relabel
    | AddEar
    | FillCorner
    | CloseCurve
    | OpenCurve
    | RemoveFace
    | RemoveStar
    | CutEdge
    | AddTetrahedron
    | AddHandle
    | JoinComponents
    | Bridge
)

Script = tuple[Operator, ...]

START: Final = FaceList(tetrahedron(0), 4)
"""The mesh that every script starts from. Clause: OPER-SCRIPT-1."""


def apply(operator: Operator, mesh: FaceList) -> Step:  # noqa: C901  (one case an operator)
    """One step; total where `mesh` is a surface. Clauses: OPER-SCRIPT-2, OPER-SCRIPT-3."""
    match operator:
        case SplitFace(face):
            return split_face(mesh, face)
        case SplitEdge(edge):
            return split_edge(mesh, edge)
        case FlipEdge(edge):
            return flip_edge(mesh, edge)
        case Relabel(seed):
            return relabel(mesh, seed)
        case AddEar(side):
            return add_ear(mesh, side)
        case FillCorner(side):
            return fill_corner(mesh, side)
        case CloseCurve(curve):
            return close_curve(mesh, curve)
        case OpenCurve(face):
            return open_curve(mesh, face)
        case RemoveFace(face):
            return remove_face(mesh, face)
        case RemoveStar(vertex):
            return remove_star(mesh, vertex)
        case CutEdge(edge):
            return cut_edge(mesh, edge)
        case AddTetrahedron():
            return add_tetrahedron(mesh)
        case AddHandle(first, second):
            return add_handle(mesh, first, second)
        case JoinComponents(first, second):
            return join_components(mesh, first, second)
        case Bridge(first, second):
            return bridge(mesh, first, second)
        case _:
            assert_never(operator)


def steps(script: Script) -> Iterator[Step]:
    """The steps of a script, in order, from START. Clause: OPER-SCRIPT-1."""
    mesh = START
    for operator in script:
        step = apply(operator, mesh)
        yield step
        mesh = step.mesh


def grow(script: Script) -> FaceList:
    """The mesh that a script ends with. Clause: OPER-SCRIPT-1."""
    mesh = START
    for step in steps(script):
        mesh = step.mesh
    return mesh


def run(script: Script) -> Accepted[Surface] | Rejected:
    """The surface that a script ends with; always accepted. Clause: OPER-SCRIPT-4."""
    return surface(grow(script))
