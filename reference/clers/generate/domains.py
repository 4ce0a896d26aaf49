"""A strategy for each domain that laws range over, by the domain's name. Clause: CONV-LAW-2."""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

from clers.generate import (
    complexes,
    face_lists,
    files,
    handles,
    mesh_files,
    meshes,
    messages,
    relabelled,
    scripts,
    solids,
    streams,
    surfaces,
)

DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    **scripts.DOMAINS,
    **streams.DOMAINS,
    **surfaces.DOMAINS,
    **face_lists.DOMAINS,
    **relabelled.DOMAINS,
    **complexes.DOMAINS,
    **solids.DOMAINS,
    **mesh_files.DOMAINS,
    **meshes.DOMAINS,
    **messages.DOMAINS,
    **files.DOMAINS,
    **handles.DOMAINS,
}


def strategy_for(domain: str) -> st.SearchStrategy[object] | None:
    """The strategy that draws examples of a domain, or None where the name is not known."""
    return DOMAINS.get(domain)
