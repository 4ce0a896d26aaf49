"""What a mesh file says, before anyone judges it, and the way to a mesh that chapter 7 knows."""

from dataclasses import dataclass

from clers.complexes.corner_table import surface
from clers.complexes.face_list import DEFAULT_LIMITS, FaceList, Limits
from clers.conventions.result import Accepted, Rejected, and_then
from clers.geometry.mesh import Mesh, mesh
from clers.geometry.positions import Positions, Precision, positions


@dataclass(frozen=True, slots=True)
class RawMesh:
    """A face list and three coordinates for each vertex, as a file has them. Clause: TOOL-READ-2.

    `coordinates` is flat: x₀, y₀, z₀, x₁, …; infinities and NaN are kept. Equality is of numbers.
    """

    faces: FaceList
    coordinates: tuple[float, ...]
    precision: Precision


def judged(raw: RawMesh, limits: Limits = DEFAULT_LIMITS) -> Accepted[Mesh] | Rejected:
    """The mesh it is, if chapters 3 and 7 accept it: faces first, then positions.

    Clauses: CPLX-INPUT-2, GEOM-POSITION-2 … GEOM-POSITION-4.
    """
    return and_then(
        surface(raw.faces, limits),
        lambda accepted: and_then(
            positions(raw.precision, raw.coordinates, raw.faces.vertices),
            lambda placed: mesh(accepted, placed),
        ),
    )


def unjudged(faces: FaceList, placed: Positions) -> RawMesh:
    """What a file of this mesh says; the two must be of the same vertices to be written."""
    return RawMesh(faces, placed.coordinates, placed.precision)
