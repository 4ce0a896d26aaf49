"""Why mutants survive, by their names: none may, but for a reason. Clause: ORCL-MUTANT-5."""

from collections.abc import Mapping
from typing import Final

EXPLAINED: Final[Mapping[str, str]] = {}
