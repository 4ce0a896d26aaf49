"""All laws of chapter 8."""

from typing import Final

from clers.container import laws_file, laws_layout
from clers.conventions.law import AnyLaw

LAWS: Final[tuple[AnyLaw, ...]] = (*laws_layout.LAWS, *laws_file.LAWS)
