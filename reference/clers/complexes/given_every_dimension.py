"""The domains that laws about complexes of every dimension range over."""

from typing import Final

from clers.complexes.affine import Point
from clers.complexes.facets import Row
from clers.complexes.simplicial import Complex
from clers.complexes.smith import Matrix
from clers.conventions.law import Given

Rows = tuple[Row, ...]
Placed = tuple[tuple[Point, ...], Complex]

COMPLEXES: Final = Given(
    "complexes", "complexes of dimension at most 4, most of them not pure, and known ones", Complex
)
PURE_COMPLEXES: Final = Given(
    "pure-complexes", "pure complexes of dimension at most 4, and known ones", Complex
)
JOINABLE: Final[Given[tuple[Complex, Complex]]] = Given(
    "joinable-complexes", "two small complexes without a common vertex", tuple
)
FACET_ROWS: Final[Given[Rows]] = Given(
    "facet-rows", "rows of integers, some empty, negative, repeating themselves or too long", tuple
)
MATRICES: Final[Given[Matrix]] = Given(
    "integer-matrices", "matrices of at most four rows and columns of integers", tuple
)
PLACED: Final[Given[Placed]] = Given(
    "placed-complexes", "small complexes with points in Q^d, d at most 3, good or not", tuple
)
