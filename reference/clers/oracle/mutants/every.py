"""All mutants that were made by hand, by their names. Clause: ORCL-MUTANT-1."""

from collections.abc import Mapping
from typing import Final

from clers.oracle.mutants import (
    in_coders,
    in_codes,
    in_decoding,
    in_encoding,
    in_files,
    in_operators,
    in_positions,
    in_surfaces,
)
from clers.oracle.mutants.mutant import Mutant

MUTANTS: Final = (
    *in_surfaces.MUTANTS,
    *in_operators.MUTANTS,
    *in_encoding.MUTANTS,
    *in_decoding.MUTANTS,
    *in_coders.MUTANTS,
    *in_codes.MUTANTS,
    *in_positions.MUTANTS,
    *in_files.MUTANTS,
)
"""In the order of the chapters. Clause: ORCL-MUTANT-1."""

BY_NAME: Final[Mapping[str, Mutant]] = {mutant.name: mutant for mutant in MUTANTS}
