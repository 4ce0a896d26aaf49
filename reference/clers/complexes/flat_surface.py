"""Surfaces from and into the flat arrays that kernels work on."""

from dataclasses import dataclass
from typing import TypeGuard

from librt.vecs import vec
from mypy_extensions import i64

from clers.complexes.surface import Corner, Surface, Vertex


@dataclass(frozen=True, slots=True)
class FlatSurface:
    """A surface as kernels have it; see `Surface`. Clause: CPLX-CORNER-2."""

    vertex: vec[i64]
    opposite: vec[i64]
    vertices: int

    def surface(self) -> Surface:
        """The same for all others."""
        return of_flat(self.vertex, self.opposite, self.vertices)


def flat(surface: Surface) -> FlatSurface:
    """The same for kernels."""
    return FlatSurface(vec[i64](surface.vertex), vec[i64](surface.opposite), surface.vertices)


def of_flat(vertex: vec[i64], opposite: vec[i64], vertices: int) -> Surface:
    """The surface that a kernel has found. Clause: CPLX-CORNER-2."""
    tips, across = tuple(vertex), tuple(opposite)
    assert vertices_all(tips)
    assert corners_all(across)
    return Surface(tips, across, vertices)


def vertices_all(_: tuple[int, ...]) -> TypeGuard[tuple[Vertex, ...]]:
    """What a kernel gives as vertices are vertices: to ask each would take longer than it took."""
    return True


def corners_all(_: tuple[int, ...]) -> TypeGuard[tuple[Corner, ...]]:
    """What a kernel gives as corners are corners."""
    return True
