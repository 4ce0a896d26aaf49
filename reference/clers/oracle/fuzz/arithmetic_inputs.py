"""Messages with models: to encode, and their bits to decode, good or with one change."""

import itertools
from typing import Final, get_args

import msgspec
from hypothesis import strategies as st

from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.messages import OkReply, Operation
from clers.conformance.numbers import from_wire, to_wire
from clers.conformance.serve import serve
from clers.generate.models import MIDDLE_TABLES, SMALL_TABLES, TABLES, adaptives
from clers.information.adaptive import Adaptive
from clers.oracle.fuzz.changes import bits_changed
from clers.oracle.fuzz.weighted import weighted

NUMBERS: Final = st.integers(0, 9999)
CODERS: Final[tuple[form.CoderName, ...]] = get_args(form.CoderName)


def _table(frequencies: tuple[int, ...]) -> tuple[form.Number, ...]:
    return tuple(map(to_wire, frequencies))


def _adaptive(model: Adaptive) -> form.AdaptiveForm:
    sums = model.cumulative
    start = tuple(b - a for a, b in itertools.pairwise(sums))
    return form.AdaptiveForm(
        frequencies=_table(start), increment=model.increment, limit=to_wire(model.limit)
    )


MODELS: Final[st.SearchStrategy[form.ModelForm]] = st.one_of(
    SMALL_TABLES.map(lambda table: form.StaticForm(frequencies=_table(table))),
    MIDDLE_TABLES.map(lambda table: form.StaticForm(frequencies=_table(table))),
    TABLES.map(lambda table: form.StaticForm(frequencies=_table(table))),
    st.integers(1, 9).map(lambda size: form.UniformForm(size=size)),
    adaptives().map(_adaptive),
)


def _alphabet(model: form.ModelForm) -> tuple[int, ...]:
    """The symbols that can be encoded."""
    match model:
        case form.UniformForm(size=size):
            return tuple(range(from_wire(size)))
        case _:
            return tuple(s for s, f in enumerate(model.frequencies) if from_wire(f) > 0)


@st.composite
def _messages(draw: st.DrawFn, coders: tuple[form.CoderName, ...]) -> form.ToCode:
    model = draw(MODELS)
    picks = draw(st.lists(st.integers(0, 9), max_size=draw(st.sampled_from((3, 12, 60)))))
    known = _alphabet(model)
    symbols = tuple(known[pick % len(known)] for pick in picks)
    return form.ToCode(coder=draw(st.sampled_from(coders)), model=model, symbols=symbols)


def _changed(given: form.ToCode, i: int, j: int) -> form.ToCode:
    """A symbol that may not be there, or a model that may be none."""
    symbols, model = given.symbols, given.model
    if j % 3:
        at, new = i % (len(symbols) + 1), (-1, 7, 1 << 60, 0)[j // 3 % 4]
        more = (*symbols[:at], to_wire(new), *symbols[at:])
        return msgspec.structs.replace(given, symbols=more)
    number = (0, -1, (1 << 30) + 1, 1 << 70)[i % 4]
    match model:
        case form.UniformForm():
            bad: form.ModelForm = form.UniformForm(size=to_wire(number))
        case form.StaticForm():
            bad = form.StaticForm(frequencies=(*model.frequencies, to_wire(number)))
        case _:
            bad = msgspec.structs.replace(model, limit=to_wire(number))
    return msgspec.structs.replace(given, model=bad)


def _coded(given: form.ToCode) -> form.Coded:
    """The message's bits, as the reference writes them."""
    last = serve(message.ArithmeticEncode(id=0, input=given))[-1]
    assert isinstance(last, OkReply), last
    bits = msgspec.json.decode(last.ok, type=form.BitString)
    return form.Coded(coder=given.coder, model=given.model, bits=bits, count=len(given.symbols))


def _coded_changed(given: form.Coded, i: int, j: int) -> form.Coded:
    if i % 4:
        return msgspec.structs.replace(given, bits=bits_changed(given.bits, i, j))
    return msgspec.structs.replace(given, count=max(0, given.count + (1, -1)[j % 2]))


def arithmetic(operation: str, known: tuple[str, ...]) -> st.SearchStrategy[Operation] | None:
    """Requests of `arithmetic.encode` or `.decode`, with the coders that are known.

    Clause: ORCL-FUZZ-1.
    """
    coders = tuple(coder for coder in CODERS if coder in known)
    if not coders:
        return None
    good = _messages(coders)
    if operation == "arithmetic.encode":
        bad = st.builds(_changed, good, NUMBERS, NUMBERS)
        return weighted(good, good, bad).map(
            lambda given: message.ArithmeticEncode(id=0, input=given)
        )
    coded = good.map(_coded)
    return weighted(coded, st.builds(_coded_changed, coded, NUMBERS, NUMBERS)).map(
        lambda given: message.ArithmeticDecode(id=0, input=given)
    )
