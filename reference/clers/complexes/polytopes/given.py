"""The domains that the laws of polytopes range over; `clers.generate` draws from them."""

from typing import Final

from clers.complexes.polytopes.cells import CellList, Polytope
from clers.complexes.polytopes.polygons import PolygonList
from clers.complexes.simplicial import Complex
from clers.conventions.law import Given

CELL_LISTS: Final = Given("cell-lists", "cell lists, good or slightly broken", CellList)
POLYTOPES: Final = Given(
    "polytopes", "polytopes of dimension at most 3, pure or not, manifolds or not", Polytope
)
POLYGONAL: Final = Given(
    "polygonal-surfaces",
    "polytopes that are 2-manifolds: orientable or not, with boundary or not",
    Polytope,
)
CLOSED: Final = Given(
    "closed-polytopes", "polytopes that are closed manifolds of dimension 0 to 3", Polytope
)
SOLID: Final = Given(
    "manifold-polytopes", "polytopes that are manifolds of dimension 1 to 3", Polytope
)
SMALL_COMPLEXES: Final = Given(
    "small-complexes", "simplicial complexes of dimension at most 3 on a few vertices", Complex
)
PRODUCTS: Final[Given[tuple[CellList, CellList]]] = Given(
    "polytope-pairs", "two polytopes with dimensions at most 3 in all", tuple
)
POLYGON_LISTS: Final = Given("polygon-lists", "polygon lists, good or slightly broken", PolygonList)
ORIENTED: Final = Given(
    "oriented-polygons", "polygon lists that are oriented polygonal surfaces", PolygonList
)
