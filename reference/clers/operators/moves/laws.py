"""The laws of moves."""

from typing import Final

from clers.conventions.law import AnyLaw
from clers.operators.moves import (
    laws_collapse,
    laws_common,
    laws_contract,
    laws_recognise,
    laws_stellar,
)

LAWS: Final[tuple[AnyLaw, ...]] = (
    *laws_common.LAWS,
    *laws_collapse.LAWS,
    *laws_stellar.LAWS,
    *laws_contract.LAWS,
    *laws_recognise.LAWS,
)
