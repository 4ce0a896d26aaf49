"""What an adapter said, so that it can be known again. Clause: ORCL-ORDER-2."""

from hashlib import sha256
from typing import assert_never

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

NOTHING = ""
"""There was no reply."""


def said(outcome: Outcome) -> str:
    """A hash that is the same for the same reply, or `NOTHING`. Clause: ORCL-ORDER-2."""
    match outcome:
        case Answered(result, steps):
            return _hash(["ok", result, steps])
        case Declined(rejection, _):
            return _hash(["reject", rejection.fault, rejection.reason])
        case Unsupported(cap):
            return _hash(["unsupported", cap])
        case Erred():
            return _hash(["error"])
        case Crash() | TimedOut() | ProtocolError() | NoProcess() | Flaky():
            return NOTHING
        case _:
            assert_never(outcome)


def _hash(document: list[object]) -> str:
    return sha256(msgspec.json.encode(document, order="sorted")).hexdigest()
