"""The domains that laws about manifolds range over; `clers.generate` draws from them."""

from dataclasses import dataclass
from typing import Final

from clers.complexes.manifolds.surface_type import NonOrientable, Orientable, SurfaceType
from clers.complexes.simplicial import Complex
from clers.conventions.law import Given


@dataclass(frozen=True, slots=True)
class Piece:
    """What a connected manifold was made of: a sphere, with parts summed to it, and balls removed.

    `genus` counts summands. In dimension 2 they are tori, or projective planes if not `orientable`;
    from dimension 3 on products of a sphere and a circle, or their twisted kin. `curves` counts the
    components of the boundary. Clauses: CPLX-CLASSIFY-1, CPLX-SUM-1.
    """

    orientable: bool
    genus: int
    curves: int

    @property
    def surface_type(self) -> SurfaceType:
        """Its type, in dimension 2. Clause: CPLX-CLASSIFY-1."""
        if self.orientable:
            return Orientable(self.genus, self.curves)
        return NonOrientable(self.genus, self.curves)


@dataclass(frozen=True, slots=True)
class Prescribed:
    """A complex that is a manifold by construction, and of what its components were made."""

    complex: Complex
    dimension: int
    pieces: tuple[Piece, ...]


PrescribedPair = tuple[Prescribed, Prescribed]

MANIFOLDS: Final = Given(
    "prescribed-manifolds", "manifolds of dimension 0 to 3, whose topology is known", Prescribed
)
SURFACES: Final = Given(
    "prescribed-surfaces", "2-manifolds of any type, whose types are known", Prescribed
)
SURFACE_PAIRS: Final[Given[PrescribedPair]] = Given(
    "prescribed-surface-pairs", "two such surfaces, not seldom of the same types", tuple
)
NEAR_MANIFOLDS: Final = Given(
    "near-manifolds", "complexes of dimension 3 at most, manifolds or slightly broken", Complex
)
FOUR_MANIFOLDS: Final = Given(
    "prescribed-4-manifolds", "manifolds of dimension 4, whose topology is known", Prescribed
)
NEAR_FOUR_MANIFOLDS: Final = Given(
    "near-4-manifolds", "complexes of dimension 4, manifolds or slightly broken", Complex
)
ORDERINGS: Final[Given[tuple[int, ...]]] = Given(
    "orderings", "some numbers in some order, no one twice", tuple
)
