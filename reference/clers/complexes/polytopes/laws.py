"""The laws of this package."""

from typing import Final

from clers.complexes.polytopes import laws_cells, laws_dual, laws_polygons
from clers.conventions.law import AnyLaw

LAWS: Final[tuple[AnyLaw, ...]] = (*laws_cells.LAWS, *laws_dual.LAWS, *laws_polygons.LAWS)
