"""The kinds of polygonal surfaces: χ, boundary curves and orientability decide."""

from dataclasses import dataclass

from clers.complexes.polytopes.cells import (
    CellList,
    boundary,
    components,
    euler,
    restricted,
)
from clers.complexes.polytopes.flags import is_orientable


@dataclass(frozen=True, slots=True)
class Kind:
    """What decides a connected surface up to homeomorphism. Clause: CPLX-POLYMANIFOLD-5."""

    euler: int
    curves: int
    orientable: bool

    @property
    def genus(self) -> int:
        """The number of handles g if it is orientable, with χ = 2 − 2g − b; else 0."""
        return (2 - self.curves - self.euler) // 2 if self.orientable else 0

    @property
    def crosscaps(self) -> int:
        """The number k of cross-caps if it is not orientable, with χ = 2 − k − b; else 0."""
        return 0 if self.orientable else 2 - self.curves - self.euler


def kinds(of: CellList) -> tuple[Kind, ...]:
    """The kind of each component of a polygonal surface, by lowest vertices.

    Clause: CPLX-POLYMANIFOLD-5; by homology instead: CPLX-POLYMANIFOLD-6.
    """
    return tuple(_kind(restricted(of, part)) for part in components(of))


def _kind(of: CellList) -> Kind:
    curves = components(restricted(of, boundary(of)))
    return Kind(euler(of), len(curves), is_orientable(of))
