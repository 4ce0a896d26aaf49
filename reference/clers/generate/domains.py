"""A strategy for each domain that laws range over, by the domain's name. Clause: CONV-LAW-2."""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

from clers.generate import (
    attachments,
    complexes,
    counting,
    edits,
    every_dimension,
    face_lists,
    files,
    handles,
    judging,
    learning,
    manifolds,
    mesh_files,
    mesh_pairs,
    meshes,
    messages,
    moves,
    polytopes,
    prefix_codes,
    relabelled,
    requests,
    scripts,
    sheets,
    sites,
    solids,
    streams,
    structures,
    surfaces,
    tree_words,
    uniform,
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
    **mesh_pairs.DOMAINS,
    **meshes.DOMAINS,
    **messages.DOMAINS,
    **prefix_codes.DOMAINS,
    **counting.DOMAINS,
    **learning.DOMAINS,
    **files.DOMAINS,
    **handles.DOMAINS,
    **every_dimension.DOMAINS,
    **manifolds.DOMAINS,
    **polytopes.DOMAINS,
    **structures.DOMAINS,
    **moves.DOMAINS,
    **sheets.DOMAINS,
    **sites.DOMAINS,
    **attachments.DOMAINS,
    **requests.DOMAINS,
    **edits.DOMAINS,
    **judging.DOMAINS,
    **uniform.DOMAINS,
    **tree_words.DOMAINS,
}


def strategy_for(domain: str) -> st.SearchStrategy[object] | None:
    """The strategy that draws examples of a domain, or None where the name is not known."""
    return DOMAINS.get(domain)
