"""Failures by their class, without numbers, so that a smaller mesh fails alike. ORCL-JUDGE-5."""

from signal import Signals

from clers.conformance.judging.judged import Status
from clers.conformance.outcome import Crash, Flaky, NoProcess, Outcome, ProtocolError


def signature(operation: str, status: Status, kind: str) -> str:
    """Operation, status and kind; of what passes or is skipped nothing. Clause: ORCL-JUDGE-5."""
    if status in (Status.PASS, Status.SKIP):
        return ""
    words = f"{operation} {status} {kind}".split()
    return "".join(c for c in " ".join(words) if not c.isnumeric())


def breakdown(outcome: Outcome) -> str:
    """What kind of breakdown an outcome is, as far as it has kinds. Clause: ORCL-JUDGE-5."""
    match outcome:
        case Crash(code, _):
            return _ending(code)
        case Flaky(first, _):
            return breakdown(first)
        case NoProcess():
            return "no process"
        case ProtocolError(why, _, _):
            return _head(why)
        case _:
            return ""


def _ending(code: int | None) -> str:
    if code is None:
        return "output closed"
    if code >= 0:
        return "exit"
    return Signals(-code).name if -code in set(Signals) else "signal"


def _head(text: str) -> str:
    """What comes before the first number, name or quotation."""
    end = next((i for i, c in enumerate(text) if c.isnumeric() or c in ":,'\""), len(text))
    return text[:end]
