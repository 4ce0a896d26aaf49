"""`clers fuzz`, `replay` and `shrink` on processes: crashes, hangs, interrupts, exit codes."""

import json
import os
import shlex
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Final

import msgspec
import pytest
from planted_faults import FAULTS, SAID, planted
from small_suite import CODED, small_suite
from typer.testing import CliRunner, Result

from clers.cli.main import app
from clers.cli.output import Exit
from clers.conformance.outcome import Answered, NoProcess, Outcome, TimedOut
from clers.conformance.session import Asked
from clers.conventions.result import Accepted, Rejected
from clers.oracle.finding import Finding, read, write
from clers.oracle.fuzz import campaign
from clers.oracle.fuzz.campaign import News, Plan, Wrote
from clers.oracle.fuzz.checks import asker
from clers.oracle.fuzz.replay import Came
from clers.oracle.fuzz.replay import replay as ask_again
from clers.oracle.pool.place import Cluster, Local, Lost, Place

Item = tuple[Plan, str, int]
HERE: Final = Path(__file__).parent
ROOT: Final = HERE.parents[1]


def faulty(name: str) -> str:
    """The reference with a planted fault: slow to start."""
    return shlex.join((sys.executable, str(HERE / "planted_faults.py"), name))


def coder(fault: str = "") -> str:
    """The coder of plain words: quick to start."""
    script = str(HERE / "faulty_adapters" / "plain_coder.py")
    return shlex.join((sys.executable, "-S", "-E", script, *([fault] if fault else [])))


def clers(*arguments: str) -> Result:
    return CliRunner().invoke(app, list(arguments))


def only_finding(folder: Path) -> tuple[Path, Finding]:
    (path,) = folder.glob("fuzz-*.json")
    found = read(path)
    assert isinstance(found, Accepted)
    return path, found.value


def fuzzed(folder: Path, adapter: str, *options: str) -> Result:
    return clers("fuzz", "-a", adapter, "-o", str(folder), *options)


def test_a_crash_is_found_shrunk_replayed_and_mended(tmp_path: Path) -> None:
    """ORCL-FUZZ-4, ORCL-FUZZ-6, ORCL-REPLAY-1, ORCL-REPLAY-2, ORCL-FIND-1."""
    done = fuzzed(tmp_path, coder("crashes-at-s"), "--examples", "8")
    assert done.exit_code == Exit.NOT_CONFORMING
    path, found = only_finding(tmp_path)
    assert found.judged.signature == "code.encode crash exit"
    assert found.outcome.startswith("crash: exit code 3")
    assert (found.adapter.name, found.adapter.version) == ("plain-coder", "2")
    assert found.adapter.command[-1] == "crashes-at-s"
    assert found.shrunk is not msgspec.UNSET
    assert (found.shrunk.unit, found.shrunk.after, found.shrunk.minimal) == ("symbols", 3, True)
    assert found.shrunk.before > 3
    assert '"word":"SEE"' in found.request
    assert f"shrunk {found.shrunk.before} → 3 symbols: {path}" in done.stdout
    assert f"reproduce:  clers replay {path} -a '{coder('crashes-at-s')}'" in done.stdout
    again = clers("replay", str(path), "-a", coder("crashes-at-s"))
    assert again.exit_code == Exit.NOT_CONFORMING
    assert f"{path}: fails alike" in again.stdout
    mended = clers("replay", str(path), "-a", coder())
    assert mended.exit_code == Exit.CONFORMING
    assert f"{path}: passes" in mended.stdout
    otherwise = clers("replay", str(path), "-a", coder("forgets-a-bit"), "--json")
    assert otherwise.exit_code == Exit.NOT_CONFORMING
    (said,) = json.loads(otherwise.stdout)
    assert (said["came"], said["op"]) == ("fails otherwise", "code.encode")
    assert said["judged"]["status"] == "fail"


def test_a_hang_is_bounded(tmp_path: Path) -> None:
    """ORCL-FUZZ-5, ORCL-SHRINK-4, ORCL-RUN-2."""
    done = fuzzed(tmp_path, coder("hangs-on-two"), "--examples", "60", "--seconds", "0.4")
    assert done.exit_code == Exit.NOT_CONFORMING
    assert "not asked further: 3 times timeout" in done.stdout
    _, found = only_finding(tmp_path)
    assert found.judged.status == "timeout"
    assert found.shrunk is not msgspec.UNSET
    assert found.shrunk.after == 2
    assert '"word":"EE"' in found.request


def test_as_json(tmp_path: Path) -> None:
    """TOOL-OUTPUT-1, ORCL-FUZZ-6: nothing found, in time; counts of each family."""
    options = ("--max-time", "0.6", "--json")
    done = fuzzed(tmp_path / "new", coder(), *options)
    assert done.exit_code == Exit.CONFORMING
    said = json.loads(done.stdout)
    assert said["findings"] == []
    assert said["gone"] == ""
    assert [f["name"] for f in said["families"]] == ["code.encode"]
    assert said["families"][0]["drawn"] >= said["families"][0]["asked"] > 0
    assert list((tmp_path / "new").iterdir()) == []


def test_nobody_there(tmp_path: Path) -> None:
    """ORCL-FUZZ-6, ORCL-REPLAY-2."""
    for options in ((), ("--json",)):
        done = clers("fuzz", "-a", "/no/such/program", "-o", str(tmp_path), *options)
        assert done.exit_code == Exit.ADAPTER
        assert "no answer to hello" in done.output
    wrong = clers("fuzz", "-a", "true", "--op", "word.guess", "-o", str(tmp_path))
    assert wrong.exit_code == Exit.USAGE
    nowhere = clers("fuzz", "-a", "true", "-o", "/dev/null/x")
    assert nowhere.exit_code == Exit.USAGE


def test_workers_find_what_one_finds(tmp_path: Path) -> None:
    """ORCL-FUZZ-3, ORCL-FUZZ-4: families are shared out, each with its own examples."""
    found = []
    for workers in ("1", "2"):
        options = ("--examples", "8", "--workers", workers, "--json")
        done = fuzzed(tmp_path / workers, coder("forgets-a-bit"), *options)
        assert done.exit_code == Exit.NOT_CONFORMING
        said = json.loads(done.stdout)
        shrunk = {
            each["finding"].get("law", ""): each["finding"]["shrunk"]["after"]
            for each in said["findings"]
        }
        found.append((shrunk, said["families"], len(list((tmp_path / workers).iterdir()))))
    assert found[0] == found[1]
    assert found[0][0] == {"": 1}


def test_an_interrupt_keeps_what_was_found(tmp_path: Path) -> None:
    """ORCL-FUZZ-4, TOOL-EXIT-2: the finding's file, the counts so far, and one line."""
    command = (
        sys.executable, "-c", "from clers.cli.main import main; main()",
        "fuzz", "-a", coder("forgets-a-bit"), "-o", str(tmp_path), "--max-time", "60",
    )  # fmt: skip
    process = subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True
    )
    until = time.monotonic() + 30
    while not list(tmp_path.glob("fuzz-*.json")) and time.monotonic() < until:
        time.sleep(0.02)
    os.kill(process.pid, signal.SIGINT)
    out, err = process.communicate(timeout=20)
    assert process.returncode == Exit.INTERRUPTED
    assert "clers: interrupted" in err
    assert "family" in out
    assert isinstance(read(only_finding(tmp_path)[0]), Accepted)


def test_a_vector_and_a_mesh_are_shrunk(tmp_path: Path) -> None:
    """ORCL-SHRINK-6."""
    suite = tmp_path / "suite"
    (vector,) = CODED
    small_suite(suite)
    done = clers(
        "shrink", vector.id, "--vectors", str(suite),
        "-a", coder("forgets-a-bit"), "-o", str(tmp_path / "of-vector"), "--json",
    )  # fmt: skip
    assert done.exit_code == Exit.NOT_CONFORMING
    found = json.loads(done.stdout)["finding"]
    assert (found["shrunk"]["before"], found["shrunk"]["after"]) == (3, 1)
    options = ("-a", faulty("mirrors-handles"), "-o", str(tmp_path), "--json")
    mesh = ROOT / "corpus" / "meshes" / "eight.off"
    plain = clers("shrink", str(mesh), "--op", "word.encode", *options[:-1])
    assert plain.exit_code == Exit.NOT_CONFORMING
    assert "→ 8 faces" in plain.stdout
    again = clers("shrink", str(only_finding(tmp_path)[0]), *options)
    shrunk = json.loads(again.stdout)["finding"]["shrunk"]
    assert shrunk["after"] == 8
    assert shrunk["before"] > 100


def test_nothing_to_shrink(tmp_path: Path) -> None:
    """ORCL-SHRINK-6: it passes; and what cannot be shrunk at all."""
    mesh = str(ROOT / "corpus" / "meshes" / "cube.ply")
    options = ("-a", faulty("sound"), "-o", str(tmp_path))
    for op in ("codec.roundtrip", "mesh.encode"):
        done = clers("shrink", mesh, "--op", op, *options)
        assert done.exit_code == Exit.CONFORMING
        assert "passes" in done.stdout
    said = clers("shrink", mesh, "--op", "word.encode", *options, "--json")
    assert json.loads(said.stdout) == {"file": None, "finding": None}
    assert clers("shrink", mesh, *options).exit_code == Exit.USAGE
    small_suite(tmp_path / "suite")
    there = ("--vectors", str(tmp_path / "suite"))
    none = clers("shrink", "no-such-vector-aaaaaaaa", *options, *there)
    assert none.exit_code == Exit.USAGE
    nobody = clers("shrink", mesh, "--op", "word.encode", "-a", "/no/such", "-o", str(tmp_path))
    assert nobody.exit_code == Exit.ADAPTER
    bad = tmp_path / "bad.json"
    bad.write_text("{}")
    assert clers("shrink", str(bad), *options).exit_code == Exit.NOT_CONFORMING
    assert clers("replay", str(bad), "-a", faulty("sound")).exit_code == Exit.NOT_CONFORMING


def test_one_against_the_other(tmp_path: Path) -> None:
    """ORCL-AGAINST-1, ORCL-AGAINST-2, ORCL-REPLAY-1."""
    other = coder()
    done = fuzzed(tmp_path, coder("forgets-a-bit"), "--examples", "5", "--against", other)
    assert done.exit_code == Exit.NOT_CONFORMING
    path, found = only_finding(tmp_path)
    assert found.against is not msgspec.UNSET
    assert (found.against.first.status, found.against.second.status) == ("fail", "pass")
    assert "plain-coder, says the reference: pass" in done.stdout
    assert f"--against '{other}'" in done.stdout
    wrong = ("-a", coder("forgets-a-bit"))
    assert "not asked" in clers("replay", str(path), *wrong).stdout
    alike = clers("replay", str(path), *wrong, "--against", other)
    assert (alike.exit_code, "fails alike" in alike.stdout) == (1, True)
    same = clers("replay", str(path), "-a", other, "--against", other, "--json")
    assert same.exit_code == Exit.CONFORMING
    assert json.loads(same.stdout)[0]["came"] == "passes"


@pytest.fixture
def finding(tmp_path: Path) -> Finding:
    """A finding that needs no process."""
    done = fuzzed(tmp_path, coder("forgets-a-bit"), "--examples", "2")
    assert done.exit_code == Exit.NOT_CONFORMING
    return only_finding(tmp_path)[1]


def test_the_literal_line_is_sent(finding: Finding) -> None:
    """ORCL-REPLAY-1, ORCL-REPLAY-2: as it stands in the file, with its spaces and its id."""
    lines: list[bytes] = []
    spaced = msgspec.structs.replace(finding, request=finding.request.replace(",", " , "))
    right, wrong = planted(FAULTS["sound"]), planted(FAULTS["forgets-a-bit"])

    def listening(asked: Asked) -> Outcome:
        lines.append(asked.line)
        return right(asked)

    assert ask_again(spaced, asker(listening, SAID)).came is Came.PASSES
    assert lines == [spaced.request.encode() + b"\n"]
    assert ask_again(spaced, asker(wrong, SAID)).came is Came.FAILS_ALIKE
    slow = asker(lambda _: TimedOut(1.0, ""), SAID)
    assert ask_again(spaced, slow).came is Came.FAILS_OTHERWISE
    less = msgspec.structs.replace(SAID, ops=("echo",))
    unasked = ask_again(spaced, asker(lambda _: Answered({}), less))
    assert (unasked.came, unasked.why) == (Came.NOT_ASKED, "code.encode is not declared")


def test_a_law_is_judged_again(finding: Finding) -> None:
    """ORCL-REPLAY-1, ORCL-REPLAY-2."""
    right, wrong = planted(FAULTS["sound"]), planted(FAULTS["forgets-a-bit"])
    lawful = msgspec.structs.replace(finding, law="comes-back")
    assert ask_again(lawful, asker(right, SAID)).came is Came.PASSES
    assert ask_again(lawful, asker(wrong, SAID)).came is Came.FAILS_OTHERWISE
    less = msgspec.structs.replace(SAID, ops=("echo", "code.encode"))
    unasked = ask_again(lawful, asker(right, less))
    assert unasked.came is Came.NOT_ASKED
    assert unasked.why == "the law comes-back needs operations that are not declared"
    mute = asker(lambda _: TimedOut(1.0, ""), SAID)
    assert ask_again(lawful, mute).came is Came.NOT_ASKED


def test_where_nothing_can_be_written_it_is_said(finding: Finding, tmp_path: Path) -> None:
    """TOOL-WRITE-4, ORCL-FIND-2."""
    assert isinstance(write(tmp_path / "nowhere" / "else", finding), Rejected)


def test_what_a_cluster_finds_is_written_here(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """ORCL-FUZZ-8: each family by itself; and what is lost is said."""
    places: list[Place] = []

    def elsewhere(
        task: Callable[[Item], Iterable[News | NoProcess]], items: Iterable[Item], place: Place
    ) -> Iterator[News | NoProcess | Lost]:
        places.append(place)
        for item in items:
            told = tuple(task(item))
            assert list(tmp_path.iterdir()) == []
            yield from told
        yield Lost("its worker ended")

    monkeypatch.setattr(campaign, "spread", elsewhere)
    command = tuple(shlex.split(coder("forgets-a-bit")))
    plan = Plan(command, tmp_path, examples=2, workers=3, scheduler="tcp://there:1")
    news = list(campaign.fuzz(plan, ("code.encode",)))
    assert places == [Cluster("tcp://there:1")]
    assert news[-1] == NoProcess("its worker ended")
    wrote = [each for each in news if isinstance(each, Wrote)]
    assert wrote[-1].path == only_finding(tmp_path)[0]
    assert campaign.place_of(Plan(command, tmp_path, workers=3)) == Local(3)
