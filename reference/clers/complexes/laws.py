"""All laws of chapter 3."""

from typing import Final

from clers.complexes import (
    laws_complex,
    laws_input,
    laws_isomorphism,
    laws_repair,
    laws_topology,
)
from clers.conventions.law import AnyLaw

LAWS: Final[tuple[AnyLaw, ...]] = (
    *laws_complex.LAWS,
    *laws_input.LAWS,
    *laws_topology.LAWS,
    *laws_isomorphism.LAWS,
    *laws_repair.LAWS,
)
