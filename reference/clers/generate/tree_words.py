"""Tree words of small spheres, with and without changes, as a Hypothesis strategy."""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

from clers.codes.tree_word import tree_word
from clers.generate.uniform import uniform_spheres


def tree_words(max_vertices: int = 12) -> st.SearchStrategy[bytes]:
    """A tree word; or one with two bits exchanged once or twice; or one cut off; or any bits."""
    words = uniform_spheres(max_vertices).map(tree_word)
    places = st.lists(st.tuples(st.integers(0, 1 << 16), st.integers(0, 1 << 16)), max_size=2)
    return st.one_of(
        words,
        st.builds(_exchanged, words, places),
        st.builds(lambda word, less: word[: -1 - less], words, st.integers(0, 8)),
        st.lists(st.integers(0, 1), max_size=12).map(bytes),
    )


def _exchanged(word: bytes, places: list[tuple[int, int]]) -> bytes:
    bits = bytearray(word)
    for i, j in places:
        a, b = i % len(bits), j % len(bits)
        bits[a], bits[b] = bits[b], bits[a]
    return bytes(bits)


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {"tree-words": tree_words()}
"""The domains of this module, by name."""
