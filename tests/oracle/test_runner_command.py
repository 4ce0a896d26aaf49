"""`clers check` as it is typed: codes, what is printed and written, and interrupts."""

import json
import os
import shlex
import signal
import subprocess
import sys
import time
from hashlib import sha256
from pathlib import Path
from xml.etree import ElementTree as Xml

import msgspec
import pytest
from small_suite import (
    BIT,
    CODED,
    ECHOES,
    HEART,
    WORDS,
    bad_adapter,
    small_suite,
)
from typer.testing import CliRunner, Result

from clers.cli.main import app
from clers.cli.output import Exit
from clers.conformance.judging.judged import Judged, Status

BROKEN = shlex.join(bad_adapter("loses_letters"))


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("suite")
    small_suite(path)
    return path


def check(folder: Path, command: tuple[str, ...] | str, *arguments: str) -> Result:
    line = command if isinstance(command, str) else shlex.join(command)
    words = ["check", "-a", line, "--vectors", str(folder), "--workers", "1", *arguments]
    return CliRunner().invoke(app, words)


def statuses(path: Path) -> dict[str, Status]:
    judged = [msgspec.json.decode(line, type=Judged) for line in path.read_bytes().splitlines()]
    return {each.id: each.status for each in judged}


def test_who_knows_it_conforms(folder: Path) -> None:
    """Clauses: ORCL-CHECK-1, ORCL-CHECK-4, ORCL-CHECK-11, ORCL-REPORT-2."""
    done = check(folder, HEART, "--canaries", "--workers", "2")
    assert done.exit_code == Exit.CONFORMING, done.output
    assert done.stdout.splitlines() == [
        "profile  cases  pass",
        "core     12     12",
        "codes    1      1",
        "all      13     13",
        "canaries: 0 of 2 wrong vectors passed",
        "heart 2 conforms: 13 pass",
    ]
    assert done.stderr == ""


def test_a_failure(folder: Path, tmp_path: Path) -> None:
    """Clauses: ORCL-CHECK-4, ORCL-REPORT-1, ORCL-REPORT-2, ORCL-REPORT-4, ORCL-REPORT-5."""
    command = BIT
    lines, xml = tmp_path / "lines.jsonl", tmp_path / "report.xml"
    page = tmp_path / "page.html"
    reports = f"jsonl={lines},junit={xml}"
    done = check(folder, command, "--report", reports, "--report", f"html={page}")
    assert done.exit_code == Exit.NOT_CONFORMING
    head, parted, more, empty, *table, last = done.stdout.splitlines()
    assert head.startswith(f'FAIL {CODED[0].id}  code.encode  ORCL-OP-1 "`echo`: the result is')
    assert parted.startswith("  first divergence: ")
    assert more == f"  more: clers explain {CODED[0].id} -a {shlex.quote(shlex.join(command))}"
    assert empty == ""
    assert table[-1].split() == ["all", "13", "12", "1"]
    assert last == "heart 2 does not conform: 1 of 13 cases"
    found = statuses(lines)
    assert [*found] == [case.id for case in (*ECHOES, *WORDS, *CODED)]
    assert {name for name, status in found.items() if status is Status.FAIL} == {CODED[0].id}
    root = Xml.parse(xml).getroot()
    assert (root.get("tests"), root.get("failures")) == ("13", "1")
    assert CODED[0].id in page.read_text(encoding="utf-8")


def test_one_document(folder: Path) -> None:
    """ORCL-REPORT-3."""
    done = check(folder, bad_adapter("good"), "--json", "--profile", "core", "--op", "echo")
    assert done.exit_code == Exit.NOT_CONFORMING
    document = json.loads(done.stdout)
    assert (document["conforms"], document["cases"]) == (False, 10)
    assert document["why"] == "every case was skipped but those of echo"
    assert document["adapter"]["name"] == "bad"
    whole = json.loads(check(folder, bad_adapter("good"), "--json").stdout)
    assert whole["lacking"] == {
        "word.decode is not declared": 2,
        "code.encode is not declared": 1,
    }


def test_known_failures(folder: Path, tmp_path: Path) -> None:
    """Clauses: ORCL-BASELINE-2, ORCL-BASELINE-3, ORCL-BASELINE-4, ORCL-CHECK-4."""
    command = BIT
    file, again = tmp_path / "known.json", tmp_path / "again.json"
    first = check(folder, command, "--write-baseline", str(file))
    assert first.exit_code == Exit.NOT_CONFORMING
    assert [known["id"] for known in json.loads(file.read_text())["known"]] == [CODED[0].id]
    then = check(folder, command, "--baseline", str(file), "--write-baseline", str(again))
    assert then.exit_code == Exit.CONFORMING
    assert then.stdout.splitlines()[-1] == "heart 2 conforms: 12 pass, 1 xfail"
    assert again.read_bytes() == file.read_bytes()
    mended = check(folder, HEART, "--baseline", str(file))
    assert mended.exit_code == Exit.NOT_CONFORMING
    assert mended.stdout.startswith(f"XPASS {CODED[0].id}")
    old = file.read_text().replace(CODED[0].id, "old-aaaaaaaa")
    file.write_text(old)
    stale = check(folder, HEART, "--baseline", str(file))
    assert stale.exit_code == Exit.CONFORMING
    expected = f"known failure old-aaaaaaaa: retired, now {WORDS[0].id}: it was wrong"
    assert expected in stale.stdout.splitlines()
    file.write_text("{}")
    assert check(folder, HEART, "--baseline", str(file)).exit_code == Exit.USAGE


def test_a_canary_that_sings(tmp_path: Path) -> None:
    """Clauses: ORCL-CHECK-11, TOOL-EXIT-1."""
    small_suite(tmp_path)
    manifest = tmp_path / "manifest.json"
    canaries = tmp_path / "canaries.json"
    right = canaries.read_text().replace('"ok":{"right":false}', '"ok":{"right":true}')
    before, after = (sha256(text.encode()).hexdigest() for text in (canaries.read_text(), right))
    canaries.write_text(right)
    manifest.write_text(manifest.read_text().replace(before, after))
    done = check(tmp_path, HEART, "--canaries", "--only", "tetra*")
    assert done.exit_code == Exit.SELF_CHECK, done.output
    assert done.stdout.splitlines()[-1].startswith(
        "heart 2 was not judged: the oracle's own check failed: wrong vectors passed: canary-"
    )


def test_a_suite_that_was_changed(tmp_path: Path) -> None:
    """Clauses: ORCL-CHECK-5, TOOL-EXIT-1."""
    small_suite(tmp_path)
    file = tmp_path / "core" / "echo.json"
    file.write_text(file.read_text().replace('"number":3', '"number":4'))
    done = check(tmp_path, HEART)
    assert done.exit_code == Exit.SELF_CHECK
    assert "core/echo.json" in done.stderr


@pytest.mark.parametrize(
    "arguments",
    [
        ("--profile", "none"),
        ("--op", "none"),
        ("--only", "none"),
        ("--report", "pdf=x"),
        ("--report", "jsonl=/nonexistent/x"),
        ("--baseline", "/nonexistent"),
        ("--restarts", "0"),
        ("--workers", "0"),
    ],
)
def test_wrong_usage(folder: Path, arguments: tuple[str, ...]) -> None:
    """Clauses: ORCL-CHECK-2, ORCL-BASELINE-5, ORCL-REPORT-4, TOOL-EXIT-1."""
    assert check(folder, bad_adapter("good"), *arguments).exit_code == Exit.USAGE


def test_no_scheduler(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """ORCL-POOL-3."""
    monkeypatch.setattr("clers.oracle.pool.cluster.PATIENCE", 0.2)
    done = check(folder, bad_adapter("good"), "--scheduler", "tcp://127.0.0.1:1")
    assert done.exit_code == Exit.USAGE
    assert "no scheduler answers" in done.stderr


def test_nobody_answers(folder: Path, tmp_path: Path) -> None:
    """ORCL-CHECK-10: nothing is written."""
    lines = tmp_path / "lines"
    command = bad_adapter("exits_at_hello")
    done = check(folder, command, "--report", f"jsonl={lines}")
    assert (done.exit_code, done.stdout) == (Exit.ADAPTER, "")
    assert "no answer to hello: crash: exit code 5" in done.stderr
    assert not lines.exists()
    said = json.loads(check(folder, command, "--json").stdout)
    assert said == {
        "command": [*command],
        "why": "no answer to hello: crash: exit code 5",
        "errors": "",
    }


def test_reports_that_cannot_be_written(folder: Path, tmp_path: Path) -> None:
    """ORCL-REPORT-7."""
    for option, path in (("--report", "junit="), ("--write-baseline", "")):
        file = f"{tmp_path}/none/file"
        done = check(folder, HEART, "--only", "tetra*", option, f"{path}{file}")
        assert done.exit_code == Exit.NOT_CONFORMING
        assert done.stdout.splitlines()[-1] == "heart 2 conforms: 1 pass"
        assert done.stderr.startswith(f"{file}: invalid: unwritable-file")


def test_the_bounds_and_the_stops(folder: Path) -> None:
    """Clauses: ORCL-CHECK-7, ORCL-CHECK-8, ORCL-CHECK-9, ORCL-CHECK-12."""
    hangs = bad_adapter("hangs")
    done = check(folder, hangs, "--seconds", "0.1", "--restarts", "2", "--op", "echo")
    assert done.exit_code == Exit.NOT_CONFORMING
    assert done.stdout.startswith(f"TIMEOUT {ECHOES[0].id}  echo")
    assert done.stdout.splitlines()[-1] == (
        "bad 1 does not conform: 7 cases were not asked: 2 processes had to be started anew"
    )
    few = check(folder, hangs, "--seconds", "0.1", "--max-failures", "1", "--op", "echo")
    assert few.stdout.splitlines()[-1] == (
        "bad 1 does not conform: 9 cases were not asked: 1 failures"
    )
    slow = check(folder, bad_adapter("starts_slowly", "30"), "--start", "0.3")
    assert "time-out: no reply in 0.3 s" in slow.stderr
    hungry = check(folder, bad_adapter("eats_memory"), "--memory", "150", "--only", "echo-0-*")
    assert "MemoryError" in hungry.stdout
    strict = check(folder, HEART, "--strict-reasons", "--only", "no-symbol-*")
    assert strict.exit_code == Exit.NOT_CONFORMING


def gone(pid: int) -> bool:
    deadline = time.monotonic() + 20
    while time.monotonic() < deadline:
        try:
            state = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0]
        except FileNotFoundError:
            return True
        if state == "Z":
            return True
        time.sleep(0.02)
    return False


SLOW = """
import os, pathlib, sys, time
sys.path.insert(0, sys.argv[1])
from good import serve, say, reply
pathlib.Path(sys.argv[2], str(os.getpid())).touch()
def spoil(number, request):
    if request["in"].get("number") == 3:
        pathlib.Path(sys.argv[2], "third").touch()
        time.sleep(600)
    say(reply(request))
serve(spoil)
"""


@pytest.mark.parametrize(("workers", "whom"), [("1", "all"), ("2", "all"), ("2", "main")])
def test_an_interrupt_keeps_what_is_known(
    folder: Path, tmp_path: Path, workers: str, whom: str
) -> None:
    """Clauses: ORCL-REPORT-5, ORCL-REPORT-7, ORCL-REPORT-8, ORCL-POOL-4, ORCL-RUN-9, ORCL-CHECK-9.

    A terminal sends the interrupt to all processes of the group, others to the one that runs.
    """
    script, pids = tmp_path / "slow.py", tmp_path / "pids"
    script.write_text(SLOW)
    pids.mkdir()
    plumbing = str(Path(bad_adapter("good")[1]).parent)
    adapter = shlex.join((sys.executable, str(script), plumbing, str(pids)))
    lines, xml = tmp_path / "lines.jsonl", tmp_path / "report.xml"
    command = (
        *(sys.executable, "-c", "from clers.cli.main import main; main()", "check"),
        *("-a", adapter, "--vectors", str(folder), "--workers", workers, "--seconds", "300"),
        *("--report", f"jsonl={lines},junit={xml}"),
    )
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True
    ) as oracle:
        deadline = time.monotonic() + 60
        while not ((pids / "third").exists() and len(lines.read_bytes().splitlines()) == 3):
            assert time.monotonic() < deadline
            time.sleep(0.02)
        if whom == "all":
            os.killpg(oracle.pid, signal.SIGINT)
        else:
            oracle.send_signal(signal.SIGINT)
        out, errors = oracle.communicate(timeout=60)
    assert (oracle.returncode, errors) == (Exit.INTERRUPTED, b"clers: interrupted\n")
    expected = b"bad 1 does not conform: 10 cases were not asked: interrupted"
    assert out.splitlines()[-1] == expected
    assert statuses(lines) == dict.fromkeys((case.id for case in ECHOES[:3]), Status.PASS)
    assert Xml.parse(xml).getroot().get("tests") == "3"
    adapters = [int(path.name) for path in pids.iterdir() if path.name != "third"]
    assert len(adapters) >= 2
    assert all(map(gone, adapters))


def test_killing_the_oracle_leaves_nobody(folder: Path, tmp_path: Path) -> None:
    """ORCL-POOL-4: neither workers nor the adapters that they have started."""
    script, pids = tmp_path / "slow.py", tmp_path / "pids"
    script.write_text(SLOW)
    pids.mkdir()
    plumbing = str(Path(bad_adapter("good")[1]).parent)
    adapter = shlex.join((sys.executable, str(script), plumbing, str(pids)))
    command = (
        *(sys.executable, "-c", "from clers.cli.main import main; main()", "check"),
        *("-a", adapter, "--vectors", str(folder), "--workers", "1", "--seconds", "300"),
    )
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as oracle:
        deadline = time.monotonic() + 60
        while not (pids / "third").exists():
            assert time.monotonic() < deadline
            time.sleep(0.02)
        oracle.kill()
    assert all(gone(int(path.name)) for path in pids.iterdir() if path.name != "third")
