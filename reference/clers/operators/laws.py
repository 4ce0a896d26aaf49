"""The laws of chapter 4."""

from typing import Final

from clers.conventions.law import AnyLaw
from clers.operators import laws_scripts

LAWS: Final[tuple[AnyLaw, ...]] = (*laws_scripts.LAWS,)
