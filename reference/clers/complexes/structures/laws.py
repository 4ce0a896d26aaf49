"""The laws of this package."""

from typing import Final

from clers.complexes.structures import laws_compact, laws_half_edge, laws_queries
from clers.conventions.law import AnyLaw

LAWS: Final[tuple[AnyLaw, ...]] = (*laws_half_edge.LAWS, *laws_queries.LAWS, *laws_compact.LAWS)
