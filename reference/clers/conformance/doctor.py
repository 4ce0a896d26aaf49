"""The doctor: whether the plumbing of an adapter holds, by checks that are data. ORCL-DOCTOR-1."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from time import monotonic, sleep
from typing import Final

from clers import SPEC_VERSION
from clers.conformance.bounds import DEFAULT_BOUNDS, Bounds
from clers.conformance.in_words import in_words
from clers.conformance.lines import line_of
from clers.conformance.messages import Echo, Hello, Introduction
from clers.conformance.outcome import Answered, Declined, NoProcess, Outcome, Unsupported
from clers.conformance.payloads import SAFE
from clers.conformance.results import RESULTS
from clers.conformance.samples import GARBAGE, SAMPLES
from clers.conformance.session import Asked, Session, asked

QUIET: Final = 0.3
"""Seconds that a second reply is waited for."""

FAR: Final = 99
"""The number of no protocol."""

TEXT: Final = 'χ = 2 − 2g − b, 𝕊² é \u0000 \u001f " \\ / \n \u2028 \ufeff'
NUMBERS: Final[list[object]] = [
    *(0, -1, SAFE, -SAFE, str(SAFE + 1), 0.1, -2.5e-7, 1e300, 5e-324, 1 / 3),
    *(True, False, None, [], {}, [[0, 1, 2], [3, 2, 1]]),
]


@dataclass(frozen=True, slots=True)
class Good:
    """A check is passed; `found` says what was seen."""

    found: str


@dataclass(frozen=True, slots=True)
class Bad:
    """A check has failed; `found` says on what."""

    found: str


Judged = Good | Bad


@dataclass(frozen=True, slots=True)
class Patient:
    """A session with the adapter, and what it said of itself at the start."""

    session: Session
    said: Introduction


@dataclass(frozen=True, slots=True)
class Finding:
    """What a check came to. Clause: ORCL-DOCTOR-1."""

    check: str
    passed: bool
    found: str


def _hello(patient: Patient) -> Judged:
    said = patient.said
    odd = sorted({*said.ops} - {*RESULTS}) or sorted({*said.caps.trace} - {*said.ops})
    if odd:
        return Bad(f"it declares {', '.join(odd)}")
    return Good(f"{said.name} {said.version} in {said.language}: {', '.join(said.ops)}")


def _echoes(patient: Patient, number: int, given: dict[str, object]) -> Judged:
    outcome = patient.session.ask(asked(number, Echo(id=0, input=given)))
    if isinstance(outcome, Answered) and outcome.result == given:
        return Good("came back as it went")
    return Bad(in_words(outcome))


def _echo(patient: Patient) -> Judged:
    return _echoes(patient, 1, {"text": "echo"})


def _unicode(patient: Patient) -> Judged:
    return _echoes(patient, 2, {TEXT: TEXT})


def _numbers(patient: Patient) -> Judged:
    return _echoes(patient, 3, {"numbers": NUMBERS})


def _big(patient: Patient) -> Judged:
    return _echoes(patient, 4, {"text": "clers χ " * (1 << 17)})


def _ids(patient: Patient) -> Judged:
    for number in (SAFE, 5, 6):
        judged = _echoes(patient, number, {})
        if isinstance(judged, Bad):
            return judged
    return Good("each reply had its request's")


def _one_reply(patient: Patient) -> Judged:
    judged = _echoes(patient, 7, {})
    deadline = monotonic() + QUIET
    while isinstance(judged, Good) and monotonic() < deadline:
        more = patient.session.stray()
        if more:
            return Bad(f"after the reply came {more[:100].decode(errors='replace')!r}")
        sleep(QUIET / 10)
    return judged if isinstance(judged, Bad) else Good("nothing came after the reply")


def _unknown(patient: Patient) -> Judged:
    name = "doctor.unknown"
    request = Asked(name, 8, False, b'{"op":"doctor.unknown","id":8,"in":{},"trace":"none"}\n')
    return _unsupported(patient.session.ask(request), name)


def _unsupported(outcome: Outcome, cap: str) -> Judged:
    if outcome == Unsupported(cap):
        return Good(f"unsupported: {cap}")
    return Bad(f"{cap}: not unsupported, but {in_words(outcome)}")


def _undeclared(patient: Patient) -> Judged:
    names = [name for name in RESULTS if name not in patient.said.ops]
    for number, name in enumerate(names, 10):
        judged = _unsupported(patient.session.ask(asked(number, SAMPLES[name])), name)
        if isinstance(judged, Bad):
            return judged
    return Good(f"{len(names)} unsupported")


def _declared(patient: Patient) -> Judged:
    names = [name for name in RESULTS if name in patient.said.ops and name != "echo"]
    lacking: list[str] = []
    for number, name in enumerate(names, 30):
        outcome = patient.session.ask(asked(number, SAMPLES[name]))
        if isinstance(outcome, Unsupported):
            lacking.append(f"{name} without {outcome.cap}")
        elif not isinstance(outcome, Answered):
            return Bad(f"{name}: {in_words(outcome)}")
    done = f"{len(names) - len(lacking)} of {len(names)} answered"
    return Good("; ".join([done, *lacking]))


def _garbage(patient: Patient) -> Judged:
    names = [name for name in GARBAGE if name in patient.said.ops]
    given = [(name, operation) for name in names for operation in GARBAGE[name]]
    for number, (name, operation) in enumerate(given, 50):
        outcome = patient.session.ask(asked(number, operation))
        if not isinstance(outcome, Declined | Unsupported):
            return Bad(f"{name}: not rejected, but {in_words(outcome)}")
    return Good(f"{len(given)} inputs rejected")


def _same_process(patient: Patient) -> Judged:
    starts = patient.session.starts
    return Good("one process") if starts == 1 else Bad(f"{starts} processes were needed")


def _hello_again(patient: Patient) -> Judged:
    patient.session.end()
    again = patient.session.introduction()
    return Bad(again.why) if isinstance(again, NoProcess) else Good("the same")


def _other_protocol(patient: Patient) -> Judged:
    line = line_of(Hello(0, FAR, SPEC_VERSION, ""))
    return _unsupported(patient.session.meet(Asked("hello", 0, False, line)), "protocol")


def _left(patient: Patient, say: bytes) -> Judged:
    started = patient.session.introduction()
    if isinstance(started, NoProcess):
        return Bad(started.why)
    code, others = patient.session.leave(say=say)
    if code is None:
        return Bad("it did not end")
    if others:
        return Bad("it left processes behind")
    return Good("it ended") if code == 0 else Bad(f"it ended with code {code}")


def _bye(patient: Patient) -> Judged:
    return _left(patient, b'{"op":"bye"}\n')


def _end_of_input(patient: Patient) -> Judged:
    return _left(patient, b"")


NEED_ECHO: Final[tuple[tuple[str, Callable[[Patient], Judged]], ...]] = (
    ("unicode", _unicode),
    ("numbers", _numbers),
    ("big-message", _big),
    ("ids", _ids),
    ("one-reply", _one_reply),
    ("unknown-operation", _unknown),
    ("undeclared-operations", _undeclared),
    ("declared-operations", _declared),
    ("garbage", _garbage),
    ("same-process", _same_process),
)
OWN_PROCESS: Final[tuple[tuple[str, Callable[[Patient], Judged]], ...]] = (
    ("hello-again", _hello_again),
    ("other-protocol", _other_protocol),
    ("bye", _bye),
    ("end-of-input", _end_of_input),
)
CHECKS: Final = (("hello", _hello), ("echo", _echo), *NEED_ECHO, *OWN_PROCESS)
"""All checks in their order. Clauses: ORCL-DOCTOR-1, ORCL-DOCTOR-2."""


def examine(
    command: Sequence[str],
    bounds: Bounds = DEFAULT_BOUNDS,
    step: Callable[[str], None] = lambda _: None,
) -> tuple[Finding, ...] | NoProcess:
    """What the checks find, or that nobody answers hello. Clauses: ORCL-DOCTOR-1, ORCL-DOCTOR-3."""
    with Session(command, bounds) as session:
        said = session.introduction()
        if isinstance(said, NoProcess):
            return said
        patient, found = Patient(session, said), dict[str, Finding]()
        for name, check in CHECKS:
            step(name)
            needs_echo = any(name == other for other, _ in NEED_ECHO)
            if needs_echo and not found["echo"].passed:
                judged: Judged = Bad("not asked, for echo failed")
            else:
                judged = check(patient)
            found[name] = Finding(name, isinstance(judged, Good), judged.found)
        return tuple(found.values())
