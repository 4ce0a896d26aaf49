"""The laws of complexes of every dimension, their homology and their geometry."""

from typing import Final

from clers.conventions.law import AnyLaw

LAWS: Final[tuple[AnyLaw, ...]] = ()
