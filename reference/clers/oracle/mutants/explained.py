"""Why mutants survive, by their names: none may, but for a reason. Clause: ORCL-MUTANT-5."""

from collections.abc import Mapping
from typing import Final

OWN_LIMITS: Final = (
    "limits are a reader's own: where a rejection of class limit is right, one of any class "
    "passes (ORCL-LIMIT-2), and a file that declares too much is always rejected for what it "
    "lacks; with strict reasons the case fails"
)
"""Taking memory for a declared number is another mistake, and is seen."""

EXPLAINED: Final[Mapping[str, str]] = {
    "limits-unchecked": OWN_LIMITS,
    "vertices-unlimited": OWN_LIMITS,
    "limit-is-invalid": OWN_LIMITS,
}
"""Clause: ORCL-MUTANT-5."""
