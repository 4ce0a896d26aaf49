"""Strategies for edits: a JSON value, and changes of some of its parts, each at a place it has."""

from collections.abc import Mapping
from typing import Final

import msgspec
from hypothesis import strategies as st
from msgspec import Raw

from clers.conformance.cases.case import Edit
from clers.conformance.cases.edits import edited, replaced
from clers.conformance.cases.laws import Editing

KEYS: Final = st.sampled_from(("word", "a/b", "~", "0", ""))
LEAVES: Final = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(-3, 3),
    st.sampled_from((0.0, -0.0, 1.0, 0.5)),
    st.text("CLERS\u03c7", max_size=5),
)
VALUES: Final[st.SearchStrategy[object]] = st.recursive(
    LEAVES,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(KEYS, inner, max_size=3),
    max_leaves=12,
)


@st.composite
def _edit(draw: st.DrawFn, value: object) -> Edit:
    """An edit of a part of a value: some way down, and there of a part or of the whole."""
    path = ""
    while isinstance(value, dict | list) and value and draw(st.booleans()):
        if isinstance(value, dict):
            key = draw(st.sampled_from(sorted(value)))
            value = value[key]
            path += "/" + key.replace("~", "~0").replace("/", "~1")
        else:
            index = draw(st.integers(0, len(value) - 1))
            value = value[index]
            path += f"/{index}"
    if isinstance(value, str | list):
        start = draw(st.integers(0, len(value)))
        stop = draw(st.integers(start, len(value)))
        kind = st.text("CLERS", max_size=3) if isinstance(value, str) else st.lists(LEAVES)
        return replaced(path, start, value[start:stop], draw(kind))
    return replaced(path, 0, value, draw(VALUES))


@st.composite
def editings(draw: st.DrawFn) -> Editing:
    """A value and up to three edits, each of what the one before it left."""
    given = Raw(msgspec.json.encode(draw(VALUES)))
    now: Raw = given
    edits: list[Edit] = []
    for _ in range(draw(st.integers(0, 3))):
        edit = draw(_edit(msgspec.json.decode(now)))
        after = edited(now, (edit,))
        if not isinstance(after, Raw):
            raise AssertionError(after.why)
        edits.append(edit)
        now = after
    return Editing(given, tuple(edits))


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {"edited-values": editings()}
"""The domains of this module, by name."""
