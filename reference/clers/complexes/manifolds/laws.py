"""The laws of this package."""

from typing import Final

from clers.complexes.manifolds import laws_classification, laws_manifold, laws_orientation
from clers.conventions.law import AnyLaw

LAWS: Final[tuple[AnyLaw, ...]] = (
    *laws_manifold.LAWS,
    *laws_orientation.LAWS,
    *laws_classification.LAWS,
)
