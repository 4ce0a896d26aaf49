"""Strategies for the domains of chapter 9: requests of every operation, lines, integers."""

from collections.abc import Mapping
from typing import Final

from hypothesis import strategies as st

from clers.codes.registry import CodeName
from clers.conformance import messages as message
from clers.conformance import payloads as form
from clers.conformance.laws import Wanted
from clers.conformance.lines import line_of
from clers.conformance.messages import Operation, Trace
from clers.conformance.numbers import to_wire
from clers.conformance.samples import GARBAGE, SAMPLES

INTEGERS: Final = st.one_of(
    st.integers(-9, 9),
    st.integers(-3, 3).flatmap(lambda d: st.sampled_from(((1 << 53) + d, -(1 << 53) + d))),
    st.integers(-(10**40), 10**40),
)
NUMBERS: Final = st.one_of(st.integers(0, 5), INTEGERS).map(to_wire)
SMALL: Final = st.integers(0, 6).map(to_wire)
IDS: Final = st.integers(0, 1 << 53)
TRACES: Final[st.SearchStrategy[Trace]] = st.sampled_from(("none", "full"))

FACES: Final = st.builds(
    form.Faces, faces=st.lists(st.tuples(SMALL, SMALL, NUMBERS), max_size=6).map(tuple),
    vertices=NUMBERS,
)  # fmt: skip
HANDLES: Final = st.lists(
    st.builds(
        form.HandleForm,
        kind=st.sampled_from(("handle", "boundary")),
        s=NUMBERS,
        at=NUMBERS,
        side=st.sampled_from(("right", "left")),
    ),
    max_size=3,
).map(tuple)
WORDS: Final = st.one_of(st.text("CLERS", max_size=12), st.sampled_from(("CRE", "CCRRE", "CCRSEE")))
STREAMS: Final = st.builds(
    form.StreamForm, word=WORDS, handles=HANDLES, components_with_boundary=NUMBERS
)
BITS: Final = st.builds(
    form.BitString, hex=st.binary(max_size=6).map(bytes.hex), length=st.integers(0, 48)
)
MODELS: Final = st.one_of(
    st.builds(form.StaticForm, frequencies=st.lists(NUMBERS, max_size=4).map(tuple)),
    st.builds(form.UniformForm, size=NUMBERS),
    st.builds(
        form.AdaptiveForm,
        frequencies=st.lists(NUMBERS, max_size=4).map(tuple),
        increment=NUMBERS,
        limit=NUMBERS,
    ),
)
CODERS: Final = st.sampled_from(("arithmetic", "range", "rans"))
NAMES: Final = st.sampled_from((*map(str, CodeName), "morse"))

OPERATIONS: Final[st.SearchStrategy[Operation]] = st.one_of(
    st.sampled_from((*SAMPLES.values(), *(bad for some in GARBAGE.values() for bad in some))),
    st.builds(message.Echo, id=IDS, trace=TRACES, input=st.just({"a": [1, None, "χ"]})),
    st.builds(message.Classify, id=IDS, trace=TRACES, input=FACES),
    st.builds(message.WordEncode, id=IDS, trace=TRACES, input=FACES),
    st.builds(message.WordDecode, id=IDS, trace=TRACES, input=STREAMS),
    st.builds(message.Apply, id=IDS, input=st.builds(form.ScriptForm, script=st.text(max_size=20))),
    st.builds(
        message.ArithmeticEncode,
        id=IDS,
        input=st.builds(
            form.ToCode,
            coder=CODERS,
            model=MODELS,
            symbols=st.lists(NUMBERS, max_size=5).map(tuple),
        ),
    ),
    st.builds(
        message.ArithmeticDecode,
        id=IDS,
        input=st.builds(form.Coded, coder=CODERS, model=MODELS, bits=BITS, count=st.integers(0, 9)),
    ),
    st.builds(
        message.CodeDecode,
        id=IDS,
        input=st.builds(
            form.FromWord,
            code=NAMES,
            bits=BITS,
            symbols=st.integers(0, 20),
            components_with_boundary=st.integers(0, 2),
        ),
    ),
    st.builds(
        message.MeshDecode,
        id=IDS,
        input=st.builds(form.FileForm, hex=st.binary(max_size=40).map(bytes.hex)),
    ),
)


def _damaged(line: bytes, place: int, noise: bytes) -> bytes:
    """A line with a few bytes exchanged."""
    at = place % (len(line) + 1)
    return line[:at] + noise + line[at + len(noise) :]


REQUEST_LINES: Final = OPERATIONS.map(line_of)

DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "adapter-requests": OPERATIONS.map(Wanted),
    "adapter-lines": st.one_of(
        REQUEST_LINES,
        st.builds(_damaged, REQUEST_LINES, st.integers(0, 500), st.binary(max_size=3)),
        st.binary(max_size=40),
        st.just(b'{"op":"bye"}'),
    ),
    "wire-integers": INTEGERS,
}
"""The domains of this module, by name."""
