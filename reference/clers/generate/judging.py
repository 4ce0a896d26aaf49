"""Strategies for judging: right answers with one change, and cases with outcomes of every kind."""

from collections.abc import Mapping
from typing import Final

import msgspec
from hypothesis import strategies as st

from clers.conformance.cases.case import Case
from clers.conformance.judging.by_reference import answered
from clers.conformance.judging.laws import Changed, Faced
from clers.conformance.messages import Caps, Introduction, Operation, Rejection, Step
from clers.conformance.outcome import (
    Answered,
    Crash,
    Declined,
    Erred,
    Flaky,
    NoProcess,
    Outcome,
    ProtocolError,
    TimedOut,
    Unsupported,
)
from clers.conformance.results import RESULTS
from clers.conformance.serve import INTRODUCTION
from clers.conventions.reason import Fault
from clers.generate.changes import changed, steps_changed
from clers.generate.good_requests import GOOD
from clers.generate.requests import OPERATIONS


@st.composite
def _changed_answers(draw: st.DrawFn) -> Changed:
    """A good request, its answer by the reference, and one change of result or steps."""
    found = answered(draw(GOOD))
    if found is None:
        raise AssertionError("a good request is not supported")
    case, right = found
    if isinstance(right, Declined):
        raise AssertionError(f"a good request is declined: {right.rejection}")
    walked = right.steps
    of_steps = draw(st.booleans())
    if walked and of_steps:
        steps, (kind, at) = draw(steps_changed(walked))
        return Changed(case, Answered(right.result, steps), kind, at)
    if draw(st.booleans()):
        walked = ()
    result, (kind, at) = draw(changed(right.result))
    return Changed(case, Answered(result, walked), kind, at)


NAMES: Final = ("handles", "components", "boundaries.one", "boundaries.many", "code.plain")

CAPS: Final = st.builds(
    Caps,
    handles=st.booleans(),
    boundaries=st.sampled_from(("none", "one", "many")),
    components=st.booleans(),
    max_faces=st.integers(0, 30),
    max_symbols=st.integers(0, 30),
    codes=st.sampled_from(((), ("plain",))),
)

SAID: Final = st.one_of(
    st.just(INTRODUCTION),
    st.builds(
        lambda caps, ops: Introduction(1, "a", "0", "c", ("echo", *ops), caps),
        CAPS,
        st.lists(st.sampled_from(tuple(RESULTS)), unique=True, max_size=12),
    ),
)


@st.composite
def _cases(draw: st.DrawFn) -> Case:
    """Cases of any requests, with any needs; a few that are no cases at all."""
    found = answered(draw(st.one_of(GOOD, OPERATIONS)))
    case = BROKEN if found is None else found[0]
    requires = draw(st.lists(st.sampled_from((*NAMES, "coder.arithmetic", "wings")), max_size=2))
    return msgspec.structs.replace(
        case, requires=tuple(requires), size=draw(st.integers(0, 40)), clauses=("EB-WORD-1",)
    )


BROKEN: Final = Case(
    id="broken-aaaaaaaa",
    op="word.decode",
    clauses=(),
    origin="hand",
    input=msgspec.Raw(b"{}"),
    ok=msgspec.Raw(b"[]"),
)

TEXTS: Final = st.sampled_from(("", "it failed at 7", "χ\n"))
REJECTIONS: Final = st.builds(
    Rejection,
    st.sampled_from(Fault),
    st.sampled_from(("", "empty-word", "bad-magic")),
    st.sampled_from(({}, {"face": 3}, {"byte": 0, "section": ""})),
    st.sampled_from(("", "EB-WORD-1")),
)


def _answers(request: Operation) -> Outcome:
    """What the reference does with a request."""
    found = answered(request)
    return Unsupported("max_symbols") if found is None else found[1]


CRASHES: Final = st.builds(Crash, st.sampled_from((None, 0, 1, -6, -11, -34, -99)), TEXTS)
PROTOCOL: Final = st.builds(
    ProtocolError,
    st.sampled_from(("a reply with id 3, the request has id 5", "more than 10 bytes", "")),
    TEXTS,
    TEXTS,
)
TIMEOUTS: Final = st.builds(TimedOut, st.floats(0, 9), TEXTS)
GIVEN: Final = st.one_of(
    st.one_of(GOOD, OPERATIONS).map(_answers),
    st.builds(Declined, REJECTIONS, st.sampled_from(((), (Step(0, "C"),)))),
    st.builds(Unsupported, TEXTS),
    st.builds(Erred, TEXTS),
)
OUTCOMES: Final[st.SearchStrategy[Outcome]] = st.one_of(
    GIVEN,
    CRASHES,
    PROTOCOL,
    TIMEOUTS,
    st.builds(NoProcess, TEXTS, TEXTS),
    st.builds(Flaky, CRASHES, st.one_of(TIMEOUTS, PROTOCOL)),
)


@st.composite
def _faced(draw: st.DrawFn) -> Faced:
    """A case with its own answer, or with whatever else came of it."""
    case = draw(_cases())
    return Faced(case, draw(OUTCOMES), draw(SAID), draw(st.booleans()))


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "changed-answers": _changed_answers(),
    "any-outcomes": _faced(),
}
"""The domains of this module, by name."""
