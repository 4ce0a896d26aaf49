"""The laws of pictures."""

from typing import Final

from clers.conventions.law import AnyLaw
from clers.pictures import laws_flat, laws_panel, laws_svg

LAWS: Final[tuple[AnyLaw, ...]] = (*laws_panel.LAWS, *laws_flat.LAWS, *laws_svg.LAWS)
