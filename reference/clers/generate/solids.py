"""Random solids with places: constructive solid geometry, opened by removing faces and stars.

The second source of meshes, beside scripts. Its surfaces come from a foreign kernel and have
coordinates, and touch, nest and overlap as those of users do.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Final, assert_never

from hypothesis import strategies as st

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted, Rejected, and_then
from clers.generate import kernel
from clers.generate.kernel import Solid, Vector
from clers.geometry.mesh import Mesh, mesh
from clers.geometry.positions import Precision, positions
from clers.operators.net import border, sides


class Shape(StrEnum):
    """The solids that a program combines."""

    TETRAHEDRON = "tetrahedron"
    BOX = "box"
    CONE = "cone"
    BALL = "ball"
    PLATE = "plate"  # a box with holes through it: one handle a hole


class Combine(StrEnum):
    """How a program adds its next solid."""

    UNION = "union"
    APART = "apart"  # union, far from all else: one component more
    DIFFERENCE = "difference"
    INTERSECTION = "intersection"


@dataclass(frozen=True, slots=True)
class Part:
    """A solid and how it is added; all numbers small integers, scaled when it is built."""

    combine: Combine
    shape: Shape
    detail: int
    size: tuple[int, int, int]
    turn: tuple[int, int, int]
    place: tuple[int, int, int]


@dataclass(frozen=True, slots=True)
class Hole:
    """What to remove of the boundary: the star of a vertex or one face, by number."""

    star: bool
    choice: int


@dataclass(frozen=True, slots=True)
class Program:
    """A solid as a list of parts, and the holes in its boundary, which may be refined before."""

    parts: tuple[Part, ...]
    holes: tuple[Hole, ...]
    refine: bool = False


def _shape(part: Part) -> Solid:
    match part.shape:
        case Shape.TETRAHEDRON:
            return kernel.tetrahedron()
        case Shape.BOX:
            return kernel.box((2.0, 2.0, 2.0))
        case Shape.CONE:
            return kernel.cone(2.0, 1.0, part.detail / 4, 3 + part.detail)
        case Shape.BALL:
            return kernel.ball(1.0, 4 * (1 + part.detail % 2))
        case Shape.PLATE:
            holes = part.detail + 1
            plate = kernel.box((2.0 * holes, 2.0, 1.0))
            for k in range(holes):
                hole = kernel.cone(2.0, 0.5, 0.5, 3)
                plate -= hole.translate((2.0 * k - holes + 1.0, 0.0, 0.0))
            return plate
        case _:
            assert_never(part.shape)


def _placed(part: Part, number: int) -> Solid:
    """The part's solid: scaled by halves, turned by 15°, moved by quarters."""
    x, y, z = part.place
    far = 100.0 * number if part.combine is Combine.APART else 0.0
    return (
        _shape(part)
        .scale(_vector(part.size, 0.5))
        .rotate(_vector(part.turn, 15.0))
        .translate((x / 4 + far, y / 4, z / 4))
    )


def _vector(of: tuple[int, int, int], by: float) -> Vector:
    return of[0] * by, of[1] * by, of[2] * by


def _combined(solid: Solid, part: Part, other: Solid) -> Solid:
    match part.combine:
        case Combine.UNION | Combine.APART:
            return solid + other
        case Combine.DIFFERENCE:
            return solid - other
        case Combine.INTERSECTION:
            return solid ^ other
        case _:
            assert_never(part.combine)


def build(program: Program, max_faces: int) -> Accepted[Mesh] | Rejected:
    """The program's mesh. A part that leaves nothing, or too much, is passed over."""
    solid = kernel.tetrahedron()
    first = True
    for number, part in enumerate(program.parts):
        other = _placed(part, number)
        combined = other if first else _combined(solid, part, other)
        if 0 < combined.num_tri() <= max_faces:
            solid, first = combined, False
    if program.refine and 4 * solid.num_tri() <= max_faces:
        solid = solid.refine(2)
    faces, places = kernel.boundary(solid)
    faces, places = opened(faces, places, program.holes)
    flat = [coordinate for place in places for coordinate in place]
    return and_then(
        surface(faces),
        lambda built: and_then(
            positions(Precision.F64, flat, faces.vertices), lambda given: mesh(built, given)
        ),
    )


def opened(
    of: FaceList, places: tuple[Vector, ...], holes: tuple[Hole, ...]
) -> tuple[FaceList, tuple[Vector, ...]]:
    """Remove stars and faces that touch no boundary curve; others stay."""
    faces = list(of.faces)
    for hole in holes:
        on_border = {u for u, _ in border(sides(faces))}
        t = hole.choice % len(faces)
        vertex = faces[t][hole.choice % 3]
        gone = {face for face in faces if vertex in face} if hole.star else {faces[t]}
        if all(on_border.isdisjoint(face) for face in gone):
            faces = [face for face in faces if face not in gone]
    return kernel.compact(faces, list(places))


_SIZE: Final = st.integers(1, 4)
_TURN: Final = st.integers(0, 6)
_PLACE: Final = st.integers(-6, 6)
_PART: Final = st.builds(
    Part,
    st.sampled_from([*Combine, Combine.APART]),
    st.sampled_from([*Shape, Shape.PLATE]),
    st.integers(0, 4),
    st.tuples(_SIZE, _SIZE, _SIZE),
    st.tuples(_TURN, _TURN, _TURN),
    st.tuples(_PLACE, _PLACE, _PLACE),
)
_HOLE: Final = st.builds(Hole, st.sampled_from((False, False, False, True)), st.integers(0, 9999))


def programs() -> st.SearchStrategy[Program]:
    """Programs of up to five parts, half of them closed, half of them with refined faces."""
    parts = st.lists(_PART, max_size=5).map(tuple)
    closed = st.lists(_HOLE, max_size=0)
    opened = [st.lists(_HOLE, min_size=low) for low in (0, 5, 10)]
    holes = st.sampled_from([closed] * 3 + opened).flatmap(lambda chosen: chosen)
    return st.builds(Program, parts, holes.map(tuple), st.booleans())


def solids(max_faces: int = 200) -> st.SearchStrategy[Mesh]:
    """Meshes of solids, at most `max_faces` faces; the empty program is a tetrahedron."""
    return programs().map(lambda program: _accepted(program, max_faces))


def solid_surfaces(max_faces: int = 200) -> st.SearchStrategy[Surface]:
    """The surfaces of `solids`."""
    return solids(max_faces).map(lambda result: result.surface)


def _accepted(program: Program, max_faces: int) -> Mesh:
    built = build(program, max_faces)
    if isinstance(built, Accepted):
        return built.value
    raise AssertionError(f"{program} is no mesh: {built.line()}")


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "solids": solids(),
    "solid-surfaces": solid_surfaces(),
}
"""The domains of this module, by name."""
