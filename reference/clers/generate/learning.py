"""Strategies for models that learn from the past, and for messages that they allow."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Final

from hypothesis import strategies as st

from clers.generate.models import SMALL_TABLES, adaptives
from clers.information.adaptive import Adaptive
from clers.information.combined import Refined, Until, raw, times
from clers.information.given_learning import (
    Conditioning,
    Counted,
    Mixing,
    MixRequest,
    Residuals,
)
from clers.information.model import Model, cumulative
from clers.information.static import END, Static

NARROW: Final[st.SearchStrategy[Model]] = st.one_of(
    SMALL_TABLES.map(cumulative).map(Static),
    adaptives(),
    st.builds(lambda model, n: times(model, n), adaptives(), st.integers(0, 6)),
    SMALL_TABLES.map(lambda row: Until(Static(cumulative(row)), 0)),
    st.just(Refined(Static((0, 1, 3, 4)), (raw(0), raw(1), raw(2)))),
)
"""Models of few symbols; some end."""


def walk(model: Model, picks: list[int]) -> tuple[int, ...]:
    """Allowed symbols, one for each pick, until the model ends."""
    symbols: list[int] = []
    for pick in picks:
        table = model.cumulative
        allowed = [s for s in range(len(table) - 1) if table[s] < table[s + 1]]
        if not allowed:
            break
        symbols.append(allowed[pick % len(allowed)])
        model = model.after(symbols[-1])
    return tuple(symbols)


PICKS: Final = st.one_of(
    st.lists(st.integers(0, 5), max_size=25),
    st.builds(lambda pick, n: [pick] * n, st.integers(0, 3), st.integers(0, 40)),
)


@st.composite
def _conditionings(draw: st.DrawFn) -> Conditioning:
    """Fresh models that differ, so that contexts cannot be taken for each other."""
    size = draw(st.integers(1, 3))
    row = st.lists(st.integers(1, 5), min_size=size, max_size=size)
    fresh = draw(st.lists(row, min_size=1, max_size=3))
    models = tuple(Adaptive(cumulative(f), 1 + n, 40) for n, f in enumerate(fresh))
    symbols = tuple(draw(st.lists(st.integers(0, size - 1), max_size=20)))
    return Conditioning(draw(st.integers(-1, 3)), models, symbols)


@st.composite
def _counted(draw: st.DrawFn) -> Counted:
    size = draw(st.integers(1, 6))
    one = st.integers(0, size - 1)
    return Counted(
        size,
        tuple(
            draw(
                st.one_of(
                    st.lists(one, max_size=30),
                    st.builds(lambda s, n: [s] * n, one, st.integers(0, 80)),
                )
            )
        ),
    )


@st.composite
def _mixings(draw: st.DrawFn) -> Mixing:
    """A message of one part, or as far as it goes of another."""
    parts = draw(st.lists(NARROW, min_size=1, max_size=4))
    weights = draw(st.lists(st.integers(1, 9), min_size=len(parts), max_size=len(parts)))
    unit = draw(st.one_of(st.integers(1, 50), st.sampled_from([1 << 16, 1 << 29])))
    symbols = walk(draw(st.sampled_from(parts)), draw(PICKS))
    return Mixing(tuple(parts), tuple(weights), unit, symbols)


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = MappingProxyType(
    {
        "contexts-and-history": _conditionings(),
        "message-of-a-size": _counted(),
        "residual-messages": st.builds(
            lambda model, picks: Residuals(model, walk(model, picks)), NARROW, PICKS
        ),
        "mixing": _mixings(),
        "any-mixing": st.builds(
            MixRequest,
            st.lists(st.sampled_from([END, Static((0, 1))]), max_size=2).map(tuple),
            st.lists(st.sampled_from([-1, 0, 1, 2, 1 << 29, 1 << 30]), max_size=2).map(tuple),
            st.sampled_from([0, 1, 1 << 29, (1 << 29) + 1]),
        ),
    }
)
