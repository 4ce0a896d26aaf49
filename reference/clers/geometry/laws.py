"""All laws of chapter 7."""

from typing import Final

from clers.conventions.law import AnyLaw
from clers.geometry import laws_lattice, laws_positions, laws_prediction, laws_residuals

LAWS: Final[tuple[AnyLaw, ...]] = (
    *laws_positions.LAWS,
    *laws_lattice.LAWS,
    *laws_prediction.LAWS,
    *laws_residuals.LAWS,
)
