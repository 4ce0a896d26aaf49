"""A mesh: a surface and where its vertices are."""

from dataclasses import dataclass

from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.geometry.positions import Positions


@dataclass(frozen=True, slots=True)
class Mesh:
    """A surface with positions, or connectivity alone. Clause: GEOM-MESH-1. Built by `mesh`."""

    surface: Surface
    positions: Positions | None = None


def mesh(surface: Surface, given: Positions | None = None) -> Accepted[Mesh] | Rejected:
    """The two put together, if there is one position for each vertex. Clause: GEOM-MESH-1."""
    if given is not None and given.vertices != surface.vertices:
        detail = f"{given.vertices} positions for {surface.vertices} vertices"
        return Rejected(Reason.COUNT_MISMATCH, Clause.GEOM_MESH_1, detail=detail)
    return Accepted(Mesh(surface, given))
