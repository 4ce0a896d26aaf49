"""Processes that misbehave, each in a way of its own: every one is bounded, and named."""

import sys
import time
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Final

import msgspec
import pytest
from bad_commands import FOLDER, bad, is_gone, runs

from clers.conformance.bounds import DEFAULT_BOUNDS, Bounds
from clers.conformance.messages import Apply, Caps, Echo, Introduction, WordDecode
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
from clers.conformance.payloads import ScriptForm, StreamForm
from clers.conformance.process import Ended, Process
from clers.conformance.session import PURE_OUTPUT, Asked, Session, asked

CALM: Final = Bounds(start=20.0, request=20.0, farewell=5.0)
HASTY: Final = Bounds(start=20.0, request=0.4)
SCHEMA: Final = "see clers schema protocol"


def echo(number: int, text: str = "χ") -> Asked:
    return asked(number, Echo(id=0, input={"text": text}))


def echoed(text: str = "χ") -> Answered:
    return Answered({"text": text})


def outcomes(command: Sequence[str], bounds: Bounds, count: int) -> list[Outcome]:
    """What comes of so many requests to echo."""
    with Session(command, bounds) as session:
        return [session.ask(echo(number)) for number in range(1, count + 1)]


def test_the_bounds_are_those_of_the_specification() -> None:
    """Clauses: ORCL-RUN-2, ORCL-RUN-6, ORCL-RUN-7."""
    wanted = Bounds(30.0, 5.0, 50_000, 2.0, 20, 8 * 1024**3, 64 * 1024**2, 64 * 1024)
    assert wanted == DEFAULT_BOUNDS
    assert DEFAULT_BOUNDS.seconds_for(b"x" * 100_000) == 7.0


def test_a_good_adapter() -> None:
    """Clauses: ORCL-HELLO-2, ORCL-LINE-2, ORCL-RUN-1, ORCL-RUN-9."""
    with Session(bad("good"), CALM) as session:
        assert session.introduction() == Introduction(
            1, "bad", "1", "python", ("echo",), Caps(False, "none", False, 0, 0)
        )
        pid = session.pid
        assert [session.ask(echo(n)) for n in range(1, 10)] == [echoed()] * 9
        assert session.ask(asked(10, Apply(id=0, input=ScriptForm(script="")))) == Unsupported(
            "operator.apply"
        )
        assert (session.starts, session.pid) == (1, pid)
        assert pid is not None
        assert runs(pid)
    assert is_gone(pid)


def test_hangs() -> None:
    """Clauses: ORCL-RUN-2, ORCL-RUN-3: each request has its time, and then a new process."""
    before = time.monotonic()
    with Session(bad("hangs"), HASTY) as session:
        session.introduction()
        pid = session.pid
        first, second = session.ask(echo(1)), session.ask(echo(2))
        starts = session.starts
    line = echo(1).line
    assert first == second == TimedOut(HASTY.seconds_for(line), "")
    assert starts == 2
    assert pid is not None
    assert is_gone(pid)
    assert 0.8 <= time.monotonic() - before < 15.0


def test_reads_nothing() -> None:
    """ORCL-RUN-2: a request that does not fit into the pipe is no reason to wait longer."""
    with Session(bad("reads_nothing"), replace(HASTY, bytes_a_second=10**9)) as session:
        found = session.ask(echo(1, "x" * 1_000_000))
    assert isinstance(found, TimedOut)


def test_crashes_on_the_seventh() -> None:
    """ORCL-RUN-5: a process that ends is replaced, the request asked again; here that helps."""
    found = outcomes(bad("crashes_on_the_seventh"), CALM, 14)
    flaky = Flaky(Crash(1, "out of luck\n"), echoed())
    # the new process has answered one request when the eighth comes, so it ends at the thirteenth
    assert found == [echoed()] * 6 + [flaky] + [echoed()] * 5 + [flaky, echoed()]


def test_a_crash_that_comes_again() -> None:
    """ORCL-RUN-5: the exit code and the end of standard error."""
    with Session(bad("leaves_a_child_and_crashes"), CALM) as session:
        found = session.ask(echo(1))
        assert session.starts == 2
    assert isinstance(found, Crash)
    assert found.code == 9
    assert is_gone(int(found.errors))


def test_crashes_once(tmp_path: Path) -> None:
    """ORCL-RUN-5."""
    found = outcomes(bad("crashes_once", str(tmp_path / "done")), CALM, 2)
    assert found == [Flaky(Crash(4, ""), echoed()), echoed()]


def test_a_crash_when_no_more_are_started() -> None:
    """Clauses: ORCL-RUN-5, ORCL-RUN-6."""
    with Session(bad("leaves_a_child_and_crashes"), replace(CALM, restarts=0)) as session:
        assert isinstance(session.ask(echo(1)), Crash)
        assert session.ask(echo(2)) == NoProcess("1 processes were started, no more are")


def test_prints_a_banner() -> None:
    """Clauses: ORCL-RUN-6, ORCL-RUN-8."""
    (found,) = outcomes(bad("prints_a_banner"), CALM, 1)
    assert isinstance(found, NoProcess)
    assert "no answer to hello" in found.why
    assert "Welcome to FastMesh 0.3!" in found.why
    assert PURE_OUTPUT in found.why


def test_chats() -> None:
    """ORCL-RUN-8: the start of the line, and a hint."""
    found = outcomes(bad("chats"), CALM, 2)
    why = "a line that is no reply: JSON is malformed: invalid character (byte 0)"
    assert found == [ProtocolError(why, PURE_OUTPUT, "echoing…")] * 2


def test_floods() -> None:
    """ORCL-RUN-7: cut, and not kept."""
    (found,) = outcomes(bad("floods"), replace(CALM, output=300_000), 1)
    assert found == ProtocolError("more than 300000 bytes", PURE_OUTPUT, "x" * 200)


def test_as_much_as_allowed_is_no_flood() -> None:
    """ORCL-RUN-7."""
    length = len('{"id": 1, "ok": {"text": ""}}\n') + 1000
    with Session(bad("good"), replace(CALM, output=length)) as session:
        assert session.ask(echo(1, "x" * 1000)) == echoed("x" * 1000)


def test_a_late_answer_is_never_the_next() -> None:
    """ORCL-RUN-3: the answer to 2 comes when 3 is open; the answer to 3 is 3's own."""
    with Session(bad("answers_late", "1.6"), replace(HASTY, request=1.0)) as session:
        found = [session.ask(echo(number, str(number))) for number in (1, 2)]
        time.sleep(0.9)
        found.append(session.ask(echo(3, "3")))
        assert session.starts == 2
    assert found[0] == echoed("1")
    assert isinstance(found[1], TimedOut)
    assert found[2] == echoed("3")


def test_drops_an_id() -> None:
    """ORCL-RUN-4."""
    found = outcomes(bad("drops_an_id"), CALM, 1)
    why = "a reply with id 0, the request has id 1"
    start = '{"id": 0, "ok": {"text": "\\u03c7"}}'
    assert found == [ProtocolError(why, "one reply a request, with its id", start)]


def test_answers_twice() -> None:
    """ORCL-RUN-4: at once, and a moment later."""
    found = outcomes(bad("answers_twice"), CALM, 2)
    start = '{"id": 1, "ok": {"text": "\\u03c7"}}\n'
    assert found[0] == ProtocolError("more than one terminal reply", SCHEMA, start)
    assert isinstance(found[1], ProtocolError)
    with Session(bad("answers_again_later"), CALM) as session:
        assert session.ask(echo(1)) == echoed()
        deadline = time.monotonic() + 10
        while not session.stray() and time.monotonic() < deadline:
            time.sleep(0.01)
        assert session.ask(echo(2)) == ProtocolError(
            "a line that no request was open for", SCHEMA, start
        )
        assert session.ask(echo(3)) == echoed()
        assert session.starts == 2


def test_leaves_a_child() -> None:
    """ORCL-RUN-9: children go with their parents."""
    with Session(bad("leaves_a_child"), CALM) as session:
        assert session.ask(echo(1)) == echoed()
        code, others = session.leave()
    assert (code, others) == (0, True)
    assert is_gone(int(session.errors))


def test_goodbye() -> None:
    """ORCL-BYE-1."""
    for say in (b'{"op":"bye"}\n', b""):
        with Session(bad("good"), CALM) as session:
            assert session.ask(echo(1)) == echoed()
            assert session.leave(say=say) == (0, False)
    with Session(bad("stays_after_bye"), replace(CALM, farewell=0.3)) as session:
        session.introduction()
        pid = session.pid
        assert session.leave() == (None, False)
    assert pid is not None
    assert is_gone(pid)


def test_eats_memory() -> None:
    """ORCL-RUN-7: the limit is the process's, and it ends."""
    with Session(bad("eats_memory"), replace(CALM, memory=400 << 20)) as session:
        found = session.ask(echo(1))
    assert isinstance(found, Crash)
    assert found.code == 1
    assert "MemoryError" in found.errors


def test_exits_at_hello() -> None:
    """ORCL-RUN-6: a budget of processes, and then none."""
    with Session(bad("exits_at_hello"), replace(CALM, restarts=2)) as session:
        found = [session.ask(echo(number)) for number in range(1, 5)]
        assert session.starts == 3
    crash = NoProcess("no answer to hello: crash: exit code 5")
    assert found == [crash] * 3 + [NoProcess("3 processes were started, no more are")]


def test_another_version() -> None:
    """Clauses: ORCL-HELLO-1, ORCL-RUN-6."""
    found = outcomes(bad("speaks_another_version"), CALM, 1)
    assert found == [NoProcess("it speaks protocol 2, not 1")]


def test_hello_must_be_the_same() -> None:
    """ORCL-HELLO-4."""
    with Session(bad("changes_its_mind"), CALM) as session:
        assert session.ask(echo(1)) == echoed()
        session.end()
        found = session.ask(echo(2))
    assert isinstance(found, NoProcess)
    assert found.why.startswith("it said hello otherwise than before: ")


def test_slow_start() -> None:
    """ORCL-RUN-2: the start has a time of its own."""
    quick = replace(HASTY, request=5.0)
    assert outcomes(bad("starts_slowly", "0.6"), quick, 1) == [echoed()]
    (found,) = outcomes(bad("starts_slowly", "30"), replace(quick, start=0.3), 1)
    assert isinstance(found, NoProcess)
    assert "time-out: no reply in 0.3 s" in found.why


def test_closes_its_output() -> None:
    """ORCL-RUN-5: it runs on, but nothing can come of it."""
    assert outcomes(bad("closes_its_output"), CALM, 1) == [Crash(None, "")]


def test_no_such_program(tmp_path: Path) -> None:
    """ORCL-RUN-6."""
    (found,) = outcomes((str(tmp_path / "nothing"),), CALM, 1)
    assert isinstance(found, NoProcess)
    assert found.errors == f"{tmp_path / 'nothing'}: No such file or directory\n"


def test_only_the_end_of_standard_error_is_kept() -> None:
    """ORCL-RUN-7."""
    script = "import sys; sys.stderr.write('a' * 200_000 + 'end')"
    with Session((sys.executable, "-c", script), replace(CALM, errors=10)) as session:
        session.ask(echo(1))
        assert session.errors == "aaaaaaaend"


WORD: Final = WordDecode(id=0, input=StreamForm(word="CRE", handles=(), components_with_boundary=0))


def scripted(*lines: str) -> tuple[str, ...]:
    """An adapter that says hello and then these lines, whatever it is asked."""
    body = (
        "import sys; sys.path.insert(0, sys.argv[1]); from good import reply, requests, say\n"
        "for r in requests(): say(reply(r)) if r['op'] == 'hello' else print(sys.argv[2])"
        " or sys.stdout.flush()"
    )
    return sys.executable, "-c", body, str(FOLDER), "\n".join(lines)


@pytest.mark.parametrize(
    ("lines", "outcome"),
    [
        (
            ['{"id":1,"reject":{"class":"invalid","reason":"unknown-symbol","at":{"symbol":1}}}'],
            Declined,
        ),
        (['{"id":1,"unsupported":{"cap":"x"}}'], Unsupported),
        (['{"id":1,"error":{"message":"x"}}'], Erred),
        (['{"id":null,"error":{"message":"x"}}'], ProtocolError),
        (['{"id":1,"ok":{"faces":[[0,1,2]],"vertices":3}}'], Answered),
        (['{"id":1,"ok":{"faces":[[0,1]],"vertices":3}}'], ProtocolError),
        (['{"id":1,"ok":{"faces":[],"vertices":3,"more":1}}'], ProtocolError),
        (['{"id":1,"reject":{"class":"awkward"}}'], ProtocolError),
        (['{"id":1,"ok":{},"error":{"message":"x"}}'], ProtocolError),
        (['{"id":1}'], ProtocolError),
        (['{"id":1,"ok":{},"extra":0}'], ProtocolError),
        ([""], ProtocolError),
        (["[1]"], ProtocolError),
        (["[" * 5000], ProtocolError),
    ],
)
def test_one_reply(lines: list[str], outcome: type) -> None:
    """Clauses: ORCL-REPLY-1 … ORCL-REPLY-4, ORCL-LINE-3."""
    with Session(scripted(*lines), CALM) as session:
        assert type(session.ask(asked(1, WORD))) is outcome


def test_events() -> None:
    """ORCL-EVENT-1: they come with the answer if they were asked for, and else are a fault."""
    event = '{"id":1,"ev":{"i":0,"symbol":"C"}}'
    answer = '{"id":1,"ok":{"faces":[],"vertices":0}}'
    full = msgspec.structs.replace(WORD, trace="full")
    with Session(scripted(event, event, answer), CALM) as session:
        found = session.ask(asked(1, full))
        assert isinstance(found, Answered)
        assert [step.symbol for step in found.steps] == ["C", "C"]
        assert session.ask(asked(1, WORD)) == ProtocolError(
            "an event that was not asked for", "see trace", event
        )


def test_hello_must_declare_echo() -> None:
    """ORCL-HELLO-2."""
    body = (
        "import sys; sys.path.insert(0, sys.argv[1]); from good import HELLO, reply, say, serve\n"
        "HELLO['ops'] = ['word.decode']; serve(lambda _, request: say(reply(request)))"
    )
    found = outcomes((sys.executable, "-c", body, str(FOLDER)), CALM, 1)
    assert found == [NoProcess("it does not declare echo")]


def test_meeting_a_stranger() -> None:
    """Clauses: ORCL-HELLO-3, ORCL-RUN-3: a process that is asked something else than hello."""
    request = echo(5)
    with Session(bad("good"), CALM) as session:
        assert session.meet(request) == echoed()
        assert session.pid is None
        assert session.ask(echo(1)) == echoed()
        assert session.starts == 2


def test_a_last_word_is_heard() -> None:
    """ORCL-RUN-5: a reply that is whole counts, though the process has ended since."""
    body = (
        "import sys; sys.path.insert(0, sys.argv[1]); from good import reply, say, serve\n"
        "def spoil(_, request): say(reply(request)); sys.exit(3)\n"
        "serve(spoil)"
    )
    with Session((sys.executable, "-c", body, str(FOLDER)), CALM) as session:
        assert session.errors == ""
        assert session.ask(echo(1, "x" * 300_000)) == echoed("x" * 300_000)


def test_no_events_before_hello() -> None:
    """ORCL-EVENT-1."""
    body = (
        "import sys; sys.path.insert(0, sys.argv[1]); from good import reply, say, serve\n"
        "say({'id': 0, 'ev': {'i': 0, 'symbol': 'C'}}); serve(None)"
    )
    (found,) = outcomes((sys.executable, "-c", body, str(FOLDER)), CALM, 1)
    assert isinstance(found, NoProcess)
    assert "an event that was not asked for" in found.why


def test_what_an_ended_process_wrote_is_read() -> None:
    """ORCL-RUN-5: two lines, read only after the end, and then the exit code."""
    process = Process((sys.executable, "-c", "print('a'); print('b'); exit(3)"), CALM)
    try:
        assert is_gone(process.pid)
        deadline = time.monotonic() + 10
        assert [process.line(deadline) for _ in range(3)] == [b"a", b"b", Ended(3)]
    finally:
        process.end()
