"""The laws of this package."""

from typing import Final

from clers.conventions.law import AnyLaw
from clers.operators.sheets import (
    laws_build,
    laws_gate,
    laws_operators,
    laws_sheets,
    laws_surfaces,
)

LAWS: Final[tuple[AnyLaw, ...]] = (
    *laws_sheets.LAWS,
    *laws_operators.LAWS,
    *laws_surfaces.LAWS,
    *laws_build.LAWS,
    *laws_gate.LAWS,
)
