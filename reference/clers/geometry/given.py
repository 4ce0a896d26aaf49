"""The domains that the laws of chapter 7 range over; `clers.generate` draws from them."""

from dataclasses import dataclass
from typing import Final

from clers.arithmetic.bits import Bits
from clers.complexes.surface import Surface
from clers.conventions.law import Given
from clers.geometry.box import Box
from clers.geometry.lattice import Quantised
from clers.geometry.mesh import Mesh
from clers.geometry.positions import Positions, Precision


@dataclass(frozen=True, slots=True)
class CoordinateList:
    """What someone says are positions; nothing is checked yet."""

    precision: Precision
    coordinates: tuple[float, ...]
    vertices: int


@dataclass(frozen=True, slots=True)
class OnAxis:
    """A coordinate and the exponent of a lattice."""

    coordinate: float
    exponent: int


@dataclass(frozen=True, slots=True)
class LatticeMesh:
    """A surface in the order of creation, and lattice points for its vertices."""

    surface: Surface
    quantised: Quantised


@dataclass(frozen=True, slots=True)
class Coding:
    """A surface in the order of creation, a box, and bits that may be anything."""

    surface: Surface
    box: Box
    bits: Bits


@dataclass(frozen=True, slots=True)
class Asked:
    """Positions, and the accuracy that a writer is asked for."""

    positions: Positions
    bits: int
    bound: float


COORDINATE_LISTS: Final = Given(
    "coordinate-lists", "numbers said to be positions, good or not", CoordinateList
)
POSITIONS: Final = Given(
    "positions", "positions of few vertices, negative zero and extremes among them", Positions
)
MESHES: Final = Given("meshes", "surfaces of any kind with positions", Mesh)
ON_AXIS: Final = Given("coordinates", "a finite coordinate and an exponent of a lattice", OnAxis)
ASKED: Final = Given("accuracies", "positions with a number of bits and an error bound", Asked)
LATTICE_MESHES: Final = Given(
    "lattice-meshes", "surfaces in the order of creation with lattice points", LatticeMesh
)
CODINGS: Final = Given(
    "position-codings", "surfaces in the order of creation, a box, and any bits", Coding
)
RESIDUALS: Final = Given("residuals", "integers of less than 2^30 in magnitude", int)
