"""Strategies for words to be ranked, runs, and numbers to be written."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from hypothesis import strategies as st

from clers.information import enumerative
from clers.information.given_counting import Ranked, RunsRequest, Unranked, Written
from clers.information.runs import Run

TEXTS: Final = st.one_of(st.text("01", max_size=12), st.text("01x", max_size=9))


@st.composite
def _ranked(draw: st.DrawFn) -> Ranked:
    size = draw(st.integers(1, 4))
    most = 7 if size > 2 else 8
    return Ranked(size, tuple(draw(st.lists(st.integers(0, size - 1), max_size=most))))


@st.composite
def _unranked(draw: st.DrawFn) -> Unranked:
    """Any digits; or about as many as there should be."""
    counts = tuple(draw(st.lists(st.integers(0, 4), max_size=4)))
    long = enumerative.width(counts)
    size = max(long + draw(st.sampled_from([0, 0, 0, 0, 1, -1])), 0)
    digits = draw(st.one_of(TEXTS, *[st.text("01", min_size=size, max_size=size)] * 3))
    return Unranked(draw(st.sampled_from([counts, counts, counts, (*counts, -1, -2)])), digits)


@st.composite
def _runs(draw: st.DrawFn) -> RunsRequest:
    """True runs, but for a symbol or length here and there."""
    steps = draw(st.lists(st.tuples(st.integers(0, 9), st.integers(0, 19)), max_size=6))
    symbol, parts = 0, list[Run]()
    for step, length in steps:
        symbol = (symbol + max(step % 3, step // 9)) % 3 if step else symbol
        parts.append(Run(symbol, length if length == 0 else 1 + length % 5))
    total = sum(run.length for run in parts)
    return RunsRequest(tuple(parts), total + draw(st.sampled_from([0, 0, 0, 1, -1])))


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = MappingProxyType(
    {
        "short-word": _ranked(),
        "any-rank": _unranked(),
        "any-runs": _runs(),
        "numbers-in-digits": st.builds(
            Written,
            st.one_of(st.integers(1, 20), st.sampled_from([2**16, 2**30 - 1, 2**30])),
            st.lists(st.integers(0, 300), max_size=4).map(tuple),
            TEXTS,
        ),
    }
)
