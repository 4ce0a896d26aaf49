"""Sheets and operators on them."""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {}
"""The domains of this module, by name."""
