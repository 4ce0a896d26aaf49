"""Strategies for tables and models: even, skewed, of the largest total, of one symbol, combined."""

from itertools import pairwise
from typing import Final

from hypothesis import strategies as st

from clers.information.adaptive import Adaptive
from clers.information.automaton import Automaton, contexts
from clers.information.combined import Contexts, Refined, Turns, Until, followed, raw, times
from clers.information.model import MAXIMUM_TOTAL, Model, cumulative
from clers.information.static import END, Static

Frequencies = tuple[int, ...]


def _good(frequencies: list[int]) -> bool:
    return 1 <= sum(frequencies) <= MAXIMUM_TOTAL


def _steep(drawn: tuple[int, int, int, int]) -> Frequencies:
    """One symbol has nearly all of a total; the others have 1."""
    size, place, exponent, less = drawn
    total = max(2**exponent - less, size)
    return tuple(total - size + 1 if s == place % size else 1 for s in range(size))


SMALL_TABLES: Final[st.SearchStrategy[Frequencies]] = (
    st.lists(st.integers(0, 6), min_size=1, max_size=6).filter(_good).map(tuple)
)
STEEP_TABLES: Final[st.SearchStrategy[Frequencies]] = st.tuples(
    st.integers(1, 5), st.integers(0, 4), st.integers(1, 30), st.integers(0, 1)
).map(_steep)
FULL_TABLES: Final[st.SearchStrategy[Frequencies]] = (
    st.lists(st.integers(0, MAXIMUM_TOTAL), max_size=5)
    .map(lambda cuts: [0, *sorted(cuts), MAXIMUM_TOTAL])
    .map(lambda cuts: tuple(b - a for a, b in pairwise(cuts)))
)
ONE_SYMBOL: Final[st.SearchStrategy[Frequencies]] = st.sampled_from([1, 2, 3, MAXIMUM_TOTAL]).map(
    lambda f: (f,)
)
MIDDLE_TABLES: Final[st.SearchStrategy[Frequencies]] = st.tuples(
    st.integers(1, 3), st.integers(1, 5)
).map(lambda drawn: (drawn[0], drawn[1], drawn[0]))
"""Symbol 1 lies about the middle: a run of it keeps bits pending."""

TABLES: Final = st.one_of(SMALL_TABLES, MIDDLE_TABLES, STEEP_TABLES, FULL_TABLES, ONE_SYMBOL)


@st.composite
def automata(draw: st.DrawFn) -> Automaton:
    """Up to three contexts of up to four symbols."""
    size, width = draw(st.integers(1, 3)), draw(st.integers(1, 4))
    row = st.lists(st.integers(0, 5), min_size=width, max_size=width)
    tables = draw(st.lists(row.filter(_good).map(tuple), min_size=size, max_size=size))
    step = st.lists(st.integers(0, size - 1), min_size=width, max_size=width).map(tuple)
    return Automaton(tuple(tables), tuple(draw(st.lists(step, min_size=size, max_size=size))))


@st.composite
def adaptives(draw: st.DrawFn) -> Adaptive:
    """Learning fast, so that frequencies are halved soon; or slowly."""
    start = draw(SMALL_TABLES)
    increment = draw(st.integers(1, 20))
    least = max(sum(start), increment + len(start))
    limit = draw(st.one_of(st.integers(least, least + 40), st.just(1 << 16)))
    return Adaptive(cumulative(start), increment, limit)


STATICS: Final[st.SearchStrategy[Model]] = st.one_of(
    TABLES.map(cumulative),
    st.integers(1, 9).map(lambda n: range(n + 1)),
    st.sampled_from([range(2**16 + 1), range(MAXIMUM_TOTAL + 1)]),
).map(Static)

ENDLESS: Final[st.SearchStrategy[Model]] = st.one_of(
    STATICS, adaptives(), automata().map(lambda a: contexts(a)[0])
)
"""Models that never end."""


@st.composite
def _combined(draw: st.DrawFn) -> Model:
    """A model made of models; each way of making them once."""
    narrow = st.one_of(adaptives(), SMALL_TABLES.map(cumulative).map(Static))
    first, second = draw(narrow), draw(narrow)
    count = draw(st.integers(0, 5))
    width = max(len(first.cumulative), len(second.cumulative)) - 1
    row = st.lists(st.integers(0, 1), min_size=width, max_size=width).map(tuple)
    details = st.one_of(st.integers(0, 20).map(raw), narrow.map(lambda m: times(m, count)))
    fine = st.lists(details, min_size=width, max_size=width).map(tuple)
    made: st.SearchStrategy[Model] = st.one_of(
        st.tuples(row, row).map(lambda rows: Contexts((first, second), rows)),
        st.just(Turns((first, second))),
        st.integers(0, width - 1).map(lambda stop: Until(first, stop)),
        st.just(times(first, count)),
        st.just(followed(times(first, count), second)),
        fine.map(lambda details: Refined(first, details)),
        fine.map(lambda details: Refined(times(first, count), details)),
    )
    return draw(made)


MODELS: Final[st.SearchStrategy[Model]] = st.one_of(ENDLESS, _combined(), st.just(END))

SMALL_MODELS: Final[st.SearchStrategy[Model]] = st.one_of(
    st.lists(st.integers(0, 5), min_size=1, max_size=3)
    .filter(_good)
    .map(lambda row: Static(cumulative(row))),
    MIDDLE_TABLES.map(lambda row: Static(cumulative(row))),
    MIDDLE_TABLES.map(lambda row: Adaptive(cumulative(row), 1, 20)),
    st.integers(0, 2).map(lambda stop: Until(Static((0, 1, 2, 4)), stop)),
    st.just(Static((0, 1, MAXIMUM_TOTAL - 1, MAXIMUM_TOTAL))),
)
"""Models of three symbols at most."""
