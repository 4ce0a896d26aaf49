"""Outcomes as people read them."""

import pytest

from clers.conformance.in_words import in_words
from clers.conformance.messages import Rejection
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
from clers.conformance.payloads import JustWord
from clers.conventions.reason import Fault


@pytest.mark.parametrize(
    ("outcome", "words"),
    [
        (Answered({"a": 1}), 'answered: {"a":1}'),
        (Answered(JustWord(word="x" * 109)), f'answered: {{"word":"{"x" * 109}"}}'),
        (Answered(JustWord(word="x" * 110)), f'answered: {{"word":"{"x" * 110}…'),
        (Declined(Rejection(Fault.LIMIT)), "declined: limit"),
        (Declined(Rejection(Fault.INVALID, "why", {}, "C", "so")), "declined: invalid why C so"),
        (Unsupported("handles"), "unsupported: handles"),
        (Erred("no luck"), "error: no luck"),
        (Crash(None, ""), "crash: it closed its output"),
        (Crash(-9, "one\ntwo\n \n"), "crash: exit code -9; it said 'two'"),
        (TimedOut(5.06, "\n"), "time-out: no reply in 5.1 s"),
        (ProtocolError("w", "h", "s"), "protocol error: w (h); it began 's'"),
        (NoProcess("none", "sorry"), "no process: none; it said 'sorry'"),
        (
            Flaky(Crash(1, ""), Unsupported("x")),
            "flaky: first crash: exit code 1; then unsupported: x",
        ),
    ],
)
def test_in_words(outcome: Outcome, words: str) -> None:
    """ORCL-RUN-1: one line for each outcome there is."""
    assert in_words(outcome) == words
