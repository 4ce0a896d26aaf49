"""A strategy for each domain that laws range over, by the domain's name. Clause: CONV-LAW-2."""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

from clers.generate import surfaces

DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    **surfaces.DOMAINS,
}


def strategy_for(domain: str) -> st.SearchStrategy[object] | None:
    """The strategy that draws examples of a domain, or None where the name is not known."""
    return DOMAINS.get(domain)
