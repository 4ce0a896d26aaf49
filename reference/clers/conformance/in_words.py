"""An outcome in one line, for people. Clause: ORCL-RUN-1."""

from typing import Final, assert_never

import msgspec

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

LONGEST: Final = 120
"""Characters of a text that are shown."""


def in_words(outcome: Outcome) -> str:
    """The outcome by its name, and what else there is to say. Clause: ORCL-RUN-1."""
    match outcome:
        case Answered(result):
            return f"answered: {_cut(msgspec.json.encode(result).decode())}"
        case Declined(rejection):
            said = (str(rejection.fault), rejection.reason, rejection.clause, rejection.detail)
            return f"declined: {_cut(' '.join(part for part in said if part))}"
        case Unsupported(cap):
            return f"unsupported: {_cut(cap)}"
        case Erred(message):
            return f"error: {_cut(message)}"
        case Crash(None, errors):
            return f"crash: it closed its output{_last(errors)}"
        case Crash(code, errors):
            return f"crash: exit code {code}{_last(errors)}"
        case TimedOut(seconds, errors):
            return f"time-out: no reply in {seconds:.1f} s{_last(errors)}"
        case ProtocolError(why, hint, start):
            return f"protocol error: {why} ({hint}); it began {_cut(start)!r}"
        case NoProcess(why, errors):
            return f"no process: {why}{_last(errors)}"
        case Flaky(first, then):
            return f"flaky: first {in_words(first)}; then {in_words(then)}"
        case _:
            assert_never(outcome)


def _last(errors: str) -> str:
    """The last line of standard error, where there is one."""
    lines = errors.split("\n")
    said = next((line.strip() for line in reversed(lines) if line.strip()), "")
    return f"; it said {_cut(said)!r}" if said else ""


def _cut(text: str) -> str:
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 1]}…"
