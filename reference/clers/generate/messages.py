"""Strategies for the domains of chapters 1 and 2: messages, requests, bits, states."""

from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Final

from hypothesis import strategies as st

from clers.arithmetic.bits import Bits, pack
from clers.arithmetic.coder import REFERENCE, Coder
from clers.arithmetic.given import Attempt, ByAutomaton, Declared, Joined, Narrowing, Pushing
from clers.arithmetic.range_coder import RANGE_CODER
from clers.arithmetic.rans import RANS
from clers.arithmetic.steps import HALF, QUARTER, TOP, State
from clers.conventions.result import Rejected
from clers.generate.models import (
    ENDLESS,
    MIDDLE_TABLES,
    MODELS,
    SMALL_MODELS,
    TABLES,
    adaptives,
    automata,
)
from clers.information.automaton import Automaton, contexts
from clers.information.given import (
    AdaptiveRequest,
    AutomatonRequest,
    Grouped,
    Learning,
    Message,
    Number,
    Several,
    Small,
    Table,
)
from clers.information.model import MAXIMUM_TOTAL, Model, cumulative
from clers.information.static import Static

PICKS: Final = st.one_of(
    st.lists(st.integers(0, 7), max_size=30),
    st.lists(st.integers(0, MAXIMUM_TOTAL), max_size=30),
    st.tuples(st.integers(0, 3), st.integers(20, 120), st.integers(0, 3)).map(
        lambda run: [run[0]] * run[1] + [run[2]]
    ),
)
"""Which of the allowed symbols is next; long runs of one keep bits pending, or cost nearly none."""


def _walk(model: Model, picks: list[int]) -> tuple[int, ...]:
    """Allowed symbols, one for each pick, until the model ends."""
    symbols: list[int] = []
    for pick in picks:
        allowed = _allowed(model.cumulative)
        if not allowed:
            break
        symbols.append(allowed[pick % len(allowed)])
        model = model.after(symbols[-1])
    return tuple(symbols)


def _allowed(table: Sequence[int]) -> Sequence[int]:
    """The symbols of positive frequency."""
    if isinstance(table, range):
        return range(len(table) - 1)
    return [s for s in range(len(table) - 1) if table[s] < table[s + 1]]


def _messages(models: st.SearchStrategy[Model]) -> st.SearchStrategy[Message]:
    return st.builds(lambda model, picks: Message(model, _walk(model, picks)), models, PICKS)


STRADDLING: Final = st.builds(
    lambda row, count, rest: Message(
        Static(cumulative(row)), (1,) * count + tuple(pick % 3 for pick in rest)
    ),
    MIDDLE_TABLES,
    st.integers(0, 150),
    st.lists(st.integers(0, 2), max_size=5),
)
"""Runs of a symbol that lies about the middle: all its bits stay pending until the run ends."""

MESSAGES: Final = st.one_of(_messages(MODELS), _messages(ENDLESS), STRADDLING)

TOO_LARGE: Final[Model] = Static((0, 1, MAXIMUM_TOTAL + 1))


@st.composite
def _any_messages(draw: st.DrawFn) -> Message:
    """An allowed message; often with one symbol replaced, or under a table that is too large."""
    given_ = draw(MESSAGES)
    place = draw(st.integers(0, len(given_.symbols)))
    symbol = draw(st.integers(-1, min(len(given_.model.cumulative), 8)))
    symbols = list(given_.symbols)
    symbols[place : place + 1] = [symbol]
    return draw(
        st.sampled_from(
            [given_, Message(given_.model, tuple(symbols)), Message(TOO_LARGE, given_.symbols)]
        )
    )


BIT_STRINGS: Final[st.SearchStrategy[Bits]] = st.one_of(
    st.lists(st.integers(0, 1), max_size=80),
    st.tuples(st.integers(0, 1), st.integers(0, 80)).map(lambda run: [run[0]] * run[1]),
).map(pack)


CODERS: Final[tuple[Coder, ...]] = (REFERENCE, RANGE_CODER, RANS)
"""Those whose codes are tried on all."""


@st.composite
def _attempts(draw: st.DrawFn) -> Attempt:
    """Bits of any origin, or a true code with bits cut off, added, or one changed."""
    given_ = draw(MESSAGES)
    coder = draw(st.sampled_from(CODERS))
    code = coder.encode(given_.model, given_.symbols)
    count = len(given_.symbols)
    if isinstance(code, Rejected) or draw(st.integers(0, 3)) == 0:
        return Attempt(given_.model, draw(BIT_STRINGS), draw(st.integers(0, 30)))
    values = list(code.value.values())
    cut, place = draw(st.integers(0, 4)), draw(st.integers(0, len(values) - 1))
    tail = draw(st.lists(st.integers(0, 1), max_size=3))
    changed = [1 - bit if at == place else bit for at, bit in enumerate(values)]
    bits = draw(st.sampled_from([values, values[: max(len(values) - cut, 0)] + tail, changed]))
    return Attempt(given_.model, pack(bits), count)


@st.composite
def _by_automata(draw: st.DrawFn) -> ByAutomaton:
    """Allowed symbols and their bits; or a symbol that may not be allowed; or other bits."""
    start = draw(automata().map(contexts).flatmap(st.sampled_from))
    symbols = _walk(start, draw(PICKS))
    code = REFERENCE.encode(start, symbols)
    right = pack([]) if isinstance(code, Rejected) else code.value
    bits = draw(st.one_of(st.just(right), BIT_STRINGS, BIT_STRINGS.map(right.followed_by)))
    place, here = draw(st.integers(0, len(symbols))), start
    for symbol in symbols[:place]:
        here = here.after(symbol)
    size = len(here.cumulative) - 1
    forbidden = set(range(-1, size + 1)) - set(_allowed(here.cumulative))
    symbol = draw(st.sampled_from([*sorted(forbidden), 256]))
    strange = (*symbols[:place], symbol, *symbols[place + 1 :])
    return ByAutomaton(start, draw(st.sampled_from([symbols, strange])), bits)


def _settled(low: int, high: int, central: bool) -> State:
    """A settled state: about the middle with one end in a quarter of its own."""
    if central:
        return State(low % QUARTER, HALF + high % HALF)
    return State(low % HALF, 3 * QUARTER + high % QUARTER)


WORDS: Final = st.one_of(st.integers(0, TOP), st.sampled_from([0, 1, QUARTER - 1, HALF - 1, TOP]))

ROWS: Final = st.lists(st.integers(-1, 3), max_size=3).map(tuple)

DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = MappingProxyType(
    {
        "message": MESSAGES,
        "any-message": _any_messages(),
        "table": TABLES.map(Table),
        "any-table": st.one_of(
            TABLES,
            ROWS,
            st.lists(st.integers(0, MAXIMUM_TOTAL), max_size=4).map(tuple),
        ).map(Table),
        "grouped-table": st.builds(
            lambda row, groups: Grouped(row, tuple(groups[: len(row)])),
            TABLES,
            st.lists(st.integers(0, 3), min_size=8, max_size=8),
        ),
        "adaptive-history": st.builds(
            lambda start, picks: Learning(start, _walk(start, picks)), adaptives(), PICKS
        ),
        "any-adaptive": st.builds(
            AdaptiveRequest,
            st.one_of(TABLES, ROWS),
            st.integers(-1, 9),
            st.one_of(st.integers(0, 30), st.sampled_from([MAXIMUM_TOTAL, MAXIMUM_TOTAL + 1])),
        ),
        "any-automaton": st.builds(
            AutomatonRequest,
            st.one_of(
                automata(),
                st.builds(
                    Automaton,
                    st.lists(ROWS, max_size=2).map(tuple),
                    st.lists(ROWS, max_size=2).map(tuple),
                ),
            ),
            st.integers(-1, 2),
        ),
        "small-model": st.builds(Small, SMALL_MODELS, st.integers(0, 4)),
        "several-messages": st.lists(_messages(ENDLESS), min_size=1, max_size=3).map(
            lambda parts: Several(tuple(parts))
        ),
        "number-of-bits": st.integers(0, 80).flatmap(
            lambda bits: st.integers(0, 2**bits - 1).map(lambda value: Number(value, bits))
        ),
        "message-and-tail": st.builds(
            lambda message, tail: Joined(message.model, message.symbols, tail),
            MESSAGES,
            BIT_STRINGS,
        ),
        "any-bits": _attempts(),
        "by-automaton": _by_automata(),
        "settled-state": st.builds(
            Narrowing, st.builds(_settled, WORDS, WORDS, st.booleans()), TABLES
        ),
        "state-of-56-bits": st.builds(
            Pushing,
            st.one_of(
                st.integers(2**48 + 1, 2**56 - 1),
                st.integers(2**48 + 1, 2**49),
                st.sampled_from([2**48 + 1, 2**56 - 1]),
            ),
            TABLES,
            st.binary(max_size=3),
        ),
        "any-state": st.tuples(WORDS, WORDS).map(lambda ends: State(min(ends), max(ends))),
        "declared-bytes": st.builds(
            lambda data, less: Declared(data, 8 * len(data) - less),
            st.binary(max_size=4),
            st.integers(-9, 9),
        ),
        "bits": BIT_STRINGS,
    }
)
