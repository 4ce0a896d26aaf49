"""The texts of clauses, where the specification is at hand. Clause: ORCL-HTML-2."""

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from types import MappingProxyType


@cache
def clause_texts() -> Mapping[str, str]:
    """The clauses by id, of the checkout that this program runs from; none without one."""
    from clers.specification.clause_text import ClauseText
    from clers.specification.repository import find_root, read_specification

    root = find_root(Path(__file__).parent)
    stated = () if root is None else read_specification(root)
    found = {item.clause: item.text for item in stated if isinstance(item, ClauseText)}
    return MappingProxyType(found)
