"""Strategies for prefix codes, words and lengths that may be none, and pairs of tables."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from hypothesis import strategies as st

from clers.conventions.result import Rejected
from clers.generate.models import SMALL_TABLES, TABLES
from clers.information.given_codes import (
    Coded,
    Few,
    GroupedPair,
    LengthsRequest,
    Pair,
    Words,
)
from clers.information.huffman import huffman
from clers.information.prefix import PrefixCode

DIGITS: Final = st.text("01", max_size=8)

SHORT_WORDS: Final[st.SearchStrategy[tuple[str | None, ...]]] = st.one_of(
    st.lists(st.text("01", min_size=1, max_size=4), max_size=4),
    st.lists(st.one_of(st.none(), st.text("01", max_size=3)), max_size=6),
    st.lists(st.text("012", max_size=3), max_size=3),
).map(tuple)


@st.composite
def _split(draw: st.DrawFn) -> PrefixCode:
    """The leaves of a tree, in any order, perhaps some missing."""
    words = [""]
    for pick in draw(st.lists(st.integers(0, 40), max_size=7)):
        word = words.pop(pick % len(words))
        words += [word + "0", word + "1"]
    if draw(st.booleans()):
        words = words[: max(1, len(words) - 2)]
    shown: list[str | None] = [*words, *[None] * draw(st.integers(0, 2))]
    return PrefixCode(tuple(draw(st.permutations(shown))))


@st.composite
def _of_huffman(draw: st.DrawFn) -> PrefixCode:
    made = huffman(draw(SMALL_TABLES))
    return PrefixCode(("",)) if isinstance(made, Rejected) else made.value


@st.composite
def _coded(draw: st.DrawFn) -> Coded:
    """A message, and its digits: true ones, ones cut off, with more behind, one changed, any."""
    code = draw(st.one_of(_split(), _of_huffman()))
    known = [symbol for symbol, word in enumerate(code.words) if word is not None]
    symbols = tuple(draw(st.lists(st.sampled_from(known), max_size=12)))
    digits = "".join(code.words[symbol] or "" for symbol in symbols)
    place = draw(st.integers(0, len(digits)))
    other = draw(st.sampled_from(["0", "1", "x", ""]))
    edits = [digits, digits[:place], digits + other, digits[:place] + other + digits[place + 1 :]]
    return Coded(code, symbols, draw(st.one_of(st.sampled_from(edits), DIGITS)))


LENGTHS: Final[st.SearchStrategy[tuple[int | None, ...]]] = st.one_of(
    st.lists(st.one_of(st.none(), st.integers(0, 6)), max_size=6).map(tuple),
    st.lists(st.integers(2, 5), min_size=1, max_size=9).map(tuple),
    st.lists(st.one_of(st.none(), st.integers(-1, 65)), max_size=3).map(tuple),
    _split().map(lambda code: code.lengths),
    st.just((*range(1, 65), 64)),
)


@st.composite
def _grouped(draw: st.DrawFn) -> GroupedPair:
    """Two tables of one length, the second seldom without a symbol of the first."""
    one = draw(SMALL_TABLES)
    least = draw(st.sampled_from([0, 1, 1]))
    row = st.lists(st.integers(least, 9), min_size=len(one), max_size=len(one))
    other = draw(row.filter(lambda found: sum(found) > 0))
    groups = draw(st.lists(st.integers(0, 2), min_size=len(one), max_size=len(one)))
    return GroupedPair(one, tuple(other), tuple(groups))


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = MappingProxyType(
    {
        "any-words": SHORT_WORDS.map(Words),
        "any-lengths": LENGTHS.map(LengthsRequest),
        "prefix-coded": _coded(),
        "two-tables": st.builds(Pair, TABLES, TABLES),
        "two-grouped-tables": _grouped(),
        "few-frequencies": st.lists(st.integers(0, 20), min_size=1, max_size=6)
        .filter(lambda row: sum(row) > 0)
        .map(lambda row: Few(tuple(row))),
    }
)
