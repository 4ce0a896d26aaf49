"""All laws of chapter 3."""

from typing import Final

from clers.complexes import (
    laws_complex,
    laws_every_dimension,
    laws_input,
    laws_isomorphism,
    laws_repair,
    laws_topology,
)
from clers.complexes.manifolds import laws as laws_manifolds
from clers.complexes.polytopes import laws as laws_polytopes
from clers.complexes.structures import laws as laws_structures
from clers.conventions.law import AnyLaw

LAWS: Final[tuple[AnyLaw, ...]] = (
    *laws_complex.LAWS,
    *laws_input.LAWS,
    *laws_topology.LAWS,
    *laws_isomorphism.LAWS,
    *laws_repair.LAWS,
    *laws_every_dimension.LAWS,
    *laws_manifolds.LAWS,
    *laws_polytopes.LAWS,
    *laws_structures.LAWS,
)
