"""The domains that laws about moves range over; `clers.generate.moves` draws from them."""

from typing import Final

from clers.complexes.manifolds.kind import LinkKind
from clers.complexes.simplicial import Complex
from clers.conventions.law import Given
from clers.operators.moves.move import Bistellar, Move, Weld

Sited = tuple[Complex, Move]

MOVES: Final[Given[Sited]] = Given(
    "complex-moves",
    "a complex of dimension at most 4 and a move, which applies, or nearly, or not at all",
    tuple,
)
MANIFOLD_MOVES: Final[Given[Sited]] = Given(
    "manifold-moves",
    "a manifold of dimension 1 to 3 and a move that keeps manifolds, or fails to apply",
    tuple,
)
FEW: Final = Given(
    "few-simplices", "complexes of at most eight vertices and dimension 3, pure or not", Complex
)
CURVES_AND_SURFACES: Final = Given(
    "curves-and-surfaces",
    "small manifolds of dimension 1 and 2: orientable or not, with boundary or not",
    Complex,
)
CLOSED_SPACES: Final = Given("closed-spaces", "small 3-manifolds without boundary", Complex)
WELDS: Final[Given[tuple[Complex, Weld]]] = Given(
    "welds", "a complex and a weld at one of its vertices, which applies or not", tuple
)
FLIPS: Final[Given[tuple[Complex, Bistellar]]] = Given(
    "flips", "a complex and a bistellar move at one of its simplices, which applies or not", tuple
)
SPLITS: Final[Given[Sited]] = Given(
    "splits", "a curve or a surface and a split, most often of parts that fit together", tuple
)
SPHERES_AND_BALLS: Final[Given[tuple[Complex, LinkKind]]] = Given(
    "spheres-and-balls", "spheres and balls of dimension 3 and 4, made by moves", tuple
)
RENAMED: Final[Given[tuple[Complex, Complex]]] = Given(
    "renamed-surfaces",
    "a closed surface of at most six vertices, and itself or another under other names",
    tuple,
)
