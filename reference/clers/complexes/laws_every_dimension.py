"""The laws of complexes of every dimension, their homology and their geometry."""

from typing import Final

from clers.complexes import laws_geometric, laws_integral, laws_parts, laws_vocabulary
from clers.conventions.law import AnyLaw

LAWS: Final[tuple[AnyLaw, ...]] = (
    *laws_vocabulary.LAWS,
    *laws_parts.LAWS,
    *laws_integral.LAWS,
    *laws_geometric.LAWS,
)
