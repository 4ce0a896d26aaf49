"""The laws of this package."""

from typing import Final

from clers.conventions.law import AnyLaw

LAWS: Final[tuple[AnyLaw, ...]] = ()
