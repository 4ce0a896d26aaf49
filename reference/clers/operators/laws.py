"""The laws of chapter 4."""

from typing import Final

from clers.conventions.law import AnyLaw
from clers.operators import laws_handles, laws_scripts

LAWS: Final[tuple[AnyLaw, ...]] = (*laws_scripts.LAWS, *laws_handles.LAWS)
