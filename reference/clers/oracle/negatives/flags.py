"""What the flags of these cases mean: the mistake that each may bring to light. ORCL-CASE-5."""

from collections.abc import Mapping
from typing import Final

FLAGS: Final[Mapping[str, tuple[str, str]]] = {}
"""Each flag: what mistake it is, and why it matters. Clause: ORCL-CASE-5."""
