"""All laws of chapter 4."""

from typing import Final

from clers.conventions.law import AnyLaw
from clers.operators import laws_handles, laws_scripts
from clers.operators.attachments import laws as laws_attachments
from clers.operators.moves import laws as laws_moves
from clers.operators.sheets import laws as laws_sheets

LAWS: Final[tuple[AnyLaw, ...]] = (
    *laws_scripts.LAWS,
    *laws_handles.LAWS,
    *laws_moves.LAWS,
    *laws_attachments.LAWS,
    *laws_sheets.LAWS,
)
