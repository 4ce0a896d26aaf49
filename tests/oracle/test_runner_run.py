"""A run: its pieces and their processes, when it is stopped, and what it comes to."""

import os
import signal
import sys
from collections.abc import Iterator, Sequence
from dataclasses import replace

import msgspec
import pytest
from small_suite import (
    CANARIES,
    CODED,
    ECHOES,
    HEART,
    PATIENT,
    TESTS,
    WORDS,
    adapter,
    bad_adapter,
    right,
    word,
    wrong,
)

from clers.conformance.cases.case import Case
from clers.conformance.judging.judged import Judged, Status
from clers.conformance.outcome import NoProcess
from clers.conventions.reason import Fault
from clers.oracle.pool.place import Local, Place
from clers.oracle.runs.baseline import Expected, Known
from clers.oracle.runs.events import Came, Event, Gap, Sang, Stopped
from clers.oracle.runs.minutes import Ending, Minutes
from clers.oracle.runs.pieces import Adapter, Piece, Result, ask_piece, meet, pieces
from clers.oracle.runs.run import HERE, Plan, run
from clers.oracle.runs.selection import Chosen, Selected

ALL = (*ECHOES, *WORDS, *CODED)
ALONE = Local(1)
MANY = tuple(right(f"echo-{k}", "echo", {"k": k}, {"k": k}) for k in range(250))


def minutes_of(
    cases: Sequence[Case], events: Sequence[Event], counted: int | None = None
) -> Minutes:
    chosen = tuple(Chosen("core", case) for case in cases)
    minutes = Minutes(Selected(chosen, len(cases) if counted is None else counted))
    for event in events:
        minutes.take(event)
    return minutes


def test_pieces_in_order() -> None:
    """ORCL-CHECK-6."""
    who = adapter(bad_adapter("good"))
    cases = MANY * 4 + MANY[:50]
    cut = list(pieces(who, cases))
    assert [len(piece.cases) for piece in cut] == [500, 500, 50]
    assert tuple(case for piece in cut for case in piece.cases) == cases
    assert all(piece.adapter == who for piece in cut)
    assert list(pieces(who, ())) == []


def test_who_knows_it_passes_what_is_right() -> None:
    """Clauses: ORCL-CHECK-1, ORCL-CHECK-3, ORCL-CHECK-6."""
    told = list(ask_piece(Piece(adapter(HEART), ALL)))
    assert [result.judged.id for result in told] == [case.id for case in ALL]
    assert {(result.judged.status, result.restarts) for result in told} == {(Status.PASS, 0)}
    assert all(result.said for result in told)


def test_what_is_not_declared_is_not_asked() -> None:
    """ORCL-CHECK-3: no process is even started."""
    who = adapter(bad_adapter("good"))
    nobody = replace(who, command=("/nonexistent",))
    told = list(ask_piece(Piece(nobody, (*WORDS, *CODED))))
    assert [result.judged.why for result in told] == [
        "word.decode is not declared",
        "word.decode is not declared",
        "code.encode is not declared",
    ]
    assert {(result.judged.status, result.said) for result in told} == {(Status.SKIP, "")}


def test_another_hello_than_at_first() -> None:
    """Clauses: ORCL-CHECK-6, ORCL-HELLO-4."""
    who = adapter(bad_adapter("good"))
    other = replace(who, introduction=msgspec.structs.replace(who.introduction, version="2"))
    (told,) = ask_piece(Piece(other, ECHOES[:1]))
    assert told.judged.status is Status.ERROR
    assert "hello otherwise than before" in told.judged.why


def test_nobody_there() -> None:
    """ORCL-CHECK-10."""
    assert isinstance(meet(("/nonexistent",)), NoProcess)
    assert isinstance(meet(bad_adapter("exits_at_hello")), NoProcess)


def test_reasons_are_judged_if_wanted() -> None:
    """ORCL-CHECK-12."""
    wanted = wrong("other", "word.decode", word("CRX"), Fault.INVALID, "other-reason")
    lax = adapter(HEART)
    strict = replace(lax, strict_reasons=True)
    (passed,), (failed,) = (tuple(ask_piece(Piece(who, (wanted,)))) for who in (lax, strict))
    assert (passed.judged.status, failed.judged.status) == (Status.PASS, Status.FAIL)
    assert meet(bad_adapter("good"), strict_reasons=True) == Adapter(
        bad_adapter("good"), adapter(bad_adapter("good")).introduction, strict_reasons=True
    )


NAMED = """
import sys; sys.path.insert(0, sys.argv[1])
from good import HELLO, reply, requests, say
for request in requests():
    HELLO["policy"] = {"suite": request.get("suite", HELLO.get("policy", {}).get("suite"))}
    say(reply(request))
"""


def test_the_suite_is_named() -> None:
    """ORCL-HELLO-1: to who is met, and to each that is asked, who else said hello otherwise."""
    command = (sys.executable, "-c", NAMED, str(TESTS.parent / "conformance" / "bad_adapters"))
    who = meet(command, PATIENT, suite="abcdefghijkl")
    assert isinstance(who, Adapter)
    assert who.introduction.policy == {"suite": "abcdefghijkl"}
    (same,) = ask_piece(Piece(who, ECHOES[:1]))
    (other,) = ask_piece(Piece(replace(who, suite=""), ECHOES[:1]))
    assert (same.judged.status, other.judged.status) == (Status.PASS, Status.ERROR)


@pytest.fixture
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pieces of ten."""
    monkeypatch.setattr("clers.oracle.runs.pieces.PIECE", 10)


@pytest.mark.usefixtures("short")
@pytest.mark.parametrize("place", [ALONE, HERE])
def test_the_same_whatever_the_workers(place: Place) -> None:
    """Clauses: ORCL-CHECK-1, ORCL-CHECK-6: even if what is said depends on what was asked."""
    who = adapter(bad_adapter("crashes_on_the_seventh"))
    events = list(run(Plan(who, place), MANY[:28]))
    came = [event for event in events if isinstance(event, Came)]
    assert [event.raw.id for event in came[:28]] == [case.id for case in MANY[:28]]
    assert [k for k, event in enumerate(came[:28]) if event.raw.status is not Status.PASS] == [
        *(6, 16, 26)
    ]
    assert came[6].raw.status is Status.FLAKY
    assert Stopped not in map(type, events)


def test_only_the_verdicts() -> None:
    """Clauses: ORCL-CHECK-1, ORCL-CHECK-6."""
    events = run(Plan(adapter(bad_adapter("good")), ALONE), ECHOES)
    came = [event.raw for event in events if isinstance(event, Came)]
    assert [(each.id, each.status) for each in came] == [(case.id, Status.PASS) for case in ECHOES]


@pytest.mark.usefixtures("short")
def test_a_run_that_needs_too_many_processes() -> None:
    """ORCL-CHECK-7: counted over the pieces."""
    who = adapter(bad_adapter("crashes_on_the_seventh"), replace(PATIENT, restarts=2))
    events = list(run(Plan(who, ALONE), MANY[:25]))
    assert events[-1] == Stopped("2 processes had to be started anew")
    assert len(events) == 18
    minutes = minutes_of(MANY[:25], events)
    assert minutes.missing == 8
    why = "8 cases were not asked: 2 processes had to be started anew"
    assert minutes.unfinished == why
    assert minutes.ending() == (Ending.DOES_NOT, why)
    # with the last case there is nothing left to be stopped
    assert Stopped not in map(type, run(Plan(who, ALONE), MANY[:17]))


@pytest.mark.usefixtures("short")
def test_a_run_with_too_many_failures() -> None:
    """ORCL-CHECK-8: failures that are known do not count."""
    who = adapter(bad_adapter("loses_letters"))
    cases = tuple(right(f"chi-{k}", "echo", {"k": "χ"}, {"k": "χ"}) for k in range(11))
    stopped = list(run(Plan(who, ALONE, failures=10), cases))
    assert stopped[-1] == Stopped("10 failures")
    assert len(stopped) == 11
    assert Stopped not in map(type, run(Plan(who, ALONE, failures=11), cases))
    assert Stopped not in map(type, run(Plan(who, ALONE), cases))
    first = stopped[0]
    assert isinstance(first, Came)
    known = Expected((Known(first.raw.id, first.raw.status, first.raw.signature),))
    assert Stopped not in map(type, run(Plan(who, ALONE, known.of, failures=10), cases))


def test_what_is_known_is_seen_beside_what_came() -> None:
    """ORCL-BASELINE-2."""
    who = adapter(bad_adapter("good"))
    known = Expected((Known(ECHOES[0].id, Status.FAIL, ""),))
    first, *others = run(Plan(who, ALONE, known.of), ECHOES)
    assert isinstance(first, Came)
    assert (first.raw.status, first.held.status) == (Status.PASS, Status.XPASS)
    assert all(isinstance(other, Came) and other.raw == other.held for other in others)


def lost(piece: Piece) -> Iterator[Result]:
    """A piece with the first echo takes its worker with it."""
    if piece.cases[0].id == ECHOES[0].id:
        os.kill(os.getpid(), signal.SIGKILL)
    yield from ask_piece(piece)


@pytest.mark.usefixtures("short")
def test_a_piece_that_is_lost(monkeypatch: pytest.MonkeyPatch) -> None:
    """Clauses: ORCL-POOL-5, ORCL-CHECK-5: its cases have no results, the others have."""
    monkeypatch.setattr("clers.oracle.runs.run.ask_piece", lost)
    cases = (*ECHOES, *MANY[:3])
    who = adapter(bad_adapter("good"))
    gap, *rest = run(Plan(who, HERE), cases, CANARIES[:1])
    assert gap == Gap("3 workers ended over it, the last with code -9")
    assert [event.raw.id for event in rest if isinstance(event, Came)] == [
        case.id for case in MANY[:3]
    ]
    minutes = minutes_of(cases, [gap, *rest])
    assert minutes.ending()[0] is Ending.UNSOUND
    assert minutes.missing == 10


def test_a_canary_that_passes() -> None:
    """ORCL-CHECK-11: canaries are told apart, and asked last."""
    who = adapter(HEART)
    events = list(run(Plan(who, ALONE), WORDS, (*CANARIES, ECHOES[0])))
    assert [type(event) for event in events] == [Came, Came, Sang, Sang, Sang]
    statuses = [event.judged.status for event in events if isinstance(event, Sang)]
    assert statuses == [Status.FAIL, Status.FAIL, Status.PASS]
    minutes = minutes_of(WORDS, events)
    assert minutes.ending() == (Ending.UNSOUND, f"wrong vectors passed: {ECHOES[0].id}")
    assert minutes_of(WORDS, events[:-1]).ending() == (Ending.CONFORMS, "")


def came(case: Case, status: Status, raw: Status | None = None) -> Came:
    def judged(of: Status) -> Judged:
        return Judged(id=case.id, op=case.op, clauses=(), status=of)

    return Came(judged(raw or status), judged(status))


@pytest.mark.parametrize("status", [Status.PASS, Status.XFAIL])
def test_a_run_that_conforms(status: Status) -> None:
    """ORCL-CHECK-4."""
    events = [came(WORDS[0], status), came(WORDS[1], Status.SKIP)]
    assert minutes_of(WORDS, events).ending() == (Ending.CONFORMS, "")


@pytest.mark.parametrize(
    "status",
    [s for s in Status if s not in (Status.PASS, Status.SKIP, Status.XFAIL)],
)
def test_a_run_that_does_not(status: Status) -> None:
    """ORCL-CHECK-4."""
    events = [came(WORDS[0], status), came(WORDS[1], Status.PASS)]
    assert minutes_of(WORDS, events).ending() == (Ending.DOES_NOT, "1 of 2 cases")


def test_nothing_but_skips() -> None:
    """ORCL-CHECK-4: echo does not count, for it shows nothing."""
    why = "every case was skipped but those of echo"
    skips = [came(case, Status.SKIP) for case in WORDS]
    assert minutes_of(WORDS, skips).ending() == (Ending.DOES_NOT, why)
    both = [*skips, came(ECHOES[0], Status.PASS)]
    assert minutes_of((*WORDS, ECHOES[0]), both).ending() == (Ending.DOES_NOT, why)


def test_cases_without_results() -> None:
    """Clauses: ORCL-CHECK-5, ORCL-POOL-5."""
    events: list[Event] = [came(WORDS[0], Status.PASS)]
    why = "1 results, 3 cases by the manifest: they are not in the files"
    minutes = minutes_of(WORDS[:1], events, counted=3)
    assert minutes.ending() == (Ending.UNSOUND, why)
    assert minutes.unfinished == why
    assert minutes.missing == 2
    lost = minutes_of(WORDS, [*events, Gap("3 workers ended over it")])
    why = "1 results, 2 cases by the manifest: 3 workers ended over it"
    assert lost.ending() == (Ending.UNSOUND, why)
    whole = minutes_of(WORDS, [came(case, Status.PASS) for case in WORDS])
    assert (whole.missing, whole.unfinished) == (0, "")


def test_an_interrupted_run() -> None:
    """ORCL-CHECK-9."""
    minutes = minutes_of(WORDS, [came(WORDS[0], Status.PASS)])
    minutes.interrupt()
    why = "1 cases were not asked: interrupted"
    assert minutes.ending() == (Ending.DOES_NOT, why)
    assert minutes.unfinished == why


def test_the_minutes_keep_the_suites_order_and_the_last_word() -> None:
    """Clauses: ORCL-CHECK-1, ORCL-ORDER-2, ORCL-BASELINE-3."""
    events = [
        came(WORDS[1], Status.PASS),
        came(WORDS[0], Status.PASS),
        came(WORDS[1], Status.XFAIL, Status.FLAKY),
    ]
    minutes = minutes_of(WORDS, events)
    assert [(r.case.id, r.judged.status) for r in minutes.rulings] == [
        (WORDS[0].id, Status.PASS),
        (WORDS[1].id, Status.XFAIL),
    ]
    assert [ruling.profile for ruling in minutes.rulings] == ["core", "core"]
    assert {judged.id: judged.status for judged in minutes.raw} == {
        WORDS[0].id: Status.PASS,
        WORDS[1].id: Status.FLAKY,
    }
