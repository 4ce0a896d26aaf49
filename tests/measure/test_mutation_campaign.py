"""Campaigns over a small package, made for it, of which each mutant's fate is known."""

import os
import signal
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from time import monotonic, sleep

import msgspec
import pytest

from clers.measure.mutation.campaign import limits, reached
from clers.measure.mutation.outcome import Baseline, Fate, Report
from clers.measure.mutation.sample import draw, subjects

TOY = '''
"""A toy."""

LIMIT = 3
TABLE = (LIMIT,)


def small(number):
    return number < LIMIT


def steps(number):
    while number > 0:
        number -= 1
    return "done"


def unused(number):
    return -number


def idle(number):
    return [number][:9]


def eats(size):
    return bytes(size - 8589934592)[:1]
'''

TESTS = """
from pathlib import Path

import pytest

from toy.sums import TABLE, eats, idle, small, steps

def test_small():
    assert small(2)
    assert not small(4)

def test_table():
    assert len(TABLE) == 1

def test_steps():
    assert steps(3) == "done"

def test_idle():
    assert idle(5) == [5]

def test_eats():
    assert eats(8589934593) == b"\\0"

def test_that_fails():
    assert small(9)

def test_that_passes_once():
    assert idle(5) == [5]
    Path("once").touch(exist_ok=False)
"""

FATES: Mapping[tuple[str, str], tuple[Fate, str]] = {
    ("LIMIT = 3", "LIMIT = 4"): (Fate.SURVIVED, ""),
    ("LIMIT = 3", "LIMIT = 2"): (Fate.KILLED, "test_small"),
    ("    return number < LIMIT", "    return number <= LIMIT"): (Fate.SURVIVED, ""),
    ("    return number < LIMIT", "    return number >= LIMIT"): (Fate.KILLED, "test_small"),
    ("    while number > 0:", "    while number >= 0:"): (Fate.SURVIVED, ""),
    ("    while number > 0:", "    while number <= 0:"): (Fate.SURVIVED, ""),
    ("    while number > 0:", "    while number > 1:"): (Fate.SURVIVED, ""),
    ("    while number > 0:", "    while number > (-1):"): (Fate.SURVIVED, ""),
    ("        number -= 1", "        number += 1"): (Fate.TIMED_OUT, "test_steps"),
    ("        number -= 1", "        pass"): (Fate.TIMED_OUT, "test_steps"),
    ("        number -= 1", "        number -= 0"): (Fate.TIMED_OUT, "test_steps"),
    ("        number -= 1", "        number -= 2"): (Fate.SURVIVED, ""),
    ("    return -number", "    return number"): (Fate.UNREACHED, ""),
    ("    return [number][:9]", "    return [number][:10]"): (Fate.SURVIVED, ""),
    ("    return [number][:9]", "    return [number][:8]"): (Fate.SURVIVED, ""),
    ("    return [number][:9]", "    return [number][:]"): (Fate.SURVIVED, ""),
    # 16 GiB are more than the campaign allows
    ("    return bytes(size - 8589934592)[:1]", "    return bytes(size + 8589934592)[:1]"): (
        Fate.KILLED,
        "test_eats",
    ),
}
"""The fates of mutants, by the line before and after, worked out by hand."""


@pytest.fixture
def toy(tmp_path: Path) -> Path:
    package = tmp_path / "toy"
    package.mkdir()
    (package / "__init__.py").write_text("")
    (package / "sums.py").write_text(TOY)
    (package / "laws_sums.py").write_text("A = 1\n")
    (package / "given.py").write_text("A = 1\n")
    (package / "other.py").write_text("A = 1\nassert A == 1\n")
    (tmp_path / "tests").mkdir()
    (tmp_path / "tests" / "test_toy.py").write_text(TESTS)
    return tmp_path


BARE: Mapping[str, str] = {**os.environ, "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}
"""The toy's tests need no plugin, and to load them takes longer than to run these."""

AS_A_USER: tuple[str, ...] = ("-m", "clers.cli.mutation")

IMPATIENT: tuple[str, ...] = (
    "-c",
    "from clers.measure.mutation import campaign; campaign.GRACE = 0.5;"
    "from clers.cli import mutation; import typer; typer.run(mutation.main)",
)
"""The same, with half a second for a test that never ends; `limits` is tested by itself."""


def command(
    toy: Path, *options: str, by: tuple[str, ...] = AS_A_USER
) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, *by, *options],
        cwd=toy, env=BARE, capture_output=True, text=True, check=False,
    )  # fmt: skip


def read(path: Path) -> Report:
    return msgspec.json.decode(path.read_bytes(), type=Report)


def test_fates_of_a_toy(toy: Path) -> None:
    """Clauses: TOOL-MUTATION-3, TOOL-MUTATION-4, TOOL-MUTATION-5."""
    before = {path: path.read_bytes() for path in toy.rglob("*.py")}
    options = ("toy.sums", "--workers", "2", "--memory", "2048", "--json", "out.json")
    done = command(toy, *options, by=IMPATIENT)
    assert done.returncode == 0, done.stderr
    report = read(toy / "out.json")
    found = {
        (old[2:], new[2:]): (judged.fate, judged.by.rpartition("::")[2])
        for judged in report.judged
        for old, new in [judged.difference.split("\n")]
    }
    assert {change: found[change] for change in FATES} == FATES
    assert report.left_out == (
        "tests/test_toy.py::test_that_fails",
        "tests/test_toy.py::test_that_passes_once",
    )
    counts = (report.killed, report.timed_out, report.survived, report.unreached)
    assert counts == tuple(sum(j.fate is fate for j in report.judged) for fate in Fate)
    assert report.mutants == report.sampled == len(report.judged) == sum(counts)
    assert report.score == (report.killed + report.timed_out) / report.mutants
    assert report.complete
    assert list(report.judged) == sorted(report.judged, key=lambda j: (j.module, j.mutant))
    assert {path: path.read_bytes() for path in toy.rglob("*.py")} == before
    printed = done.stdout
    assert "toy.sums:9:19 comparison survived\n-     return number < LIMIT\n+     return" in printed
    assert "toy.sums:19:12 sign unreached\n-     return -number\n+     return number\n" in printed
    assert "left out" in printed.splitlines()[-2]
    assert f"score {100 * report.score:.1f} %" in printed.splitlines()[-1]


def test_mutant_that_cannot_be_imported_is_killed(toy: Path) -> None:
    """Clause: TOOL-MUTATION-3."""
    (toy / "tests" / "test_toy.py").write_text("import toy.other\n\ndef test():\n    pass\n")
    done = command(toy, "toy.other", "--json", "out.json")
    assert done.returncode == 0, done.stderr
    found = {(j.mutant.after, j.fate, j.by) for j in read(toy / "out.json").judged}
    assert found == {("0", Fate.KILLED, "import"), ("2", Fate.KILLED, "import")}


def test_mutant_that_takes_the_tests_away_survives(toy: Path) -> None:
    """Clause: TOOL-MUTATION-3."""
    (toy / "toy" / "other.py").write_text("A = 1\n")
    (toy / "tests" / "test_toy.py").write_text(
        "import pytest\nfrom toy.other import A\n\n"
        "@pytest.mark.parametrize('a', [A])\ndef test(a):\n    pass\n"
    )
    done = command(toy, "toy.other", "--json", "out.json")
    assert done.returncode == 0, done.stderr
    found = {(j.mutant.after, j.fate, j.by) for j in read(toy / "out.json").judged}
    assert found == {("0", Fate.SURVIVED, ""), ("2", Fate.SURVIVED, "")}


def test_sample_by_the_seed_alone(toy: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Clause: TOOL-MUTATION-5."""
    monkeypatch.syspath_prepend(toy)
    found = subjects(["toy"], [])
    assert not isinstance(found, str)
    assert [of.module for of in found] == ["toy", "toy.other", "toy.sums"]

    def drawn(sample: int | None, seed: int) -> tuple[str, ...]:
        total, chosen = draw(found, "toy", sample, seed)
        assert total == len(draw(found, "toy", None, 0)[1])
        return tuple(f"{d.subject.module} {d.mutant}" for d in chosen)

    every = drawn(None, 1)
    five = drawn(5, 1)
    assert five == drawn(5, 1)
    assert len(five) == 5
    assert five == drawn(9, 1)[:5] == every[:5]
    assert len(set(every)) == len(every)
    assert len({drawn(5, seed) for seed in range(10)}) > 5
    assert set(drawn(len(every) + 1, 3)) == set(drawn(len(every), 4)) == set(every)
    assert subjects(["toy"], ["*.sums", "toy"]) == (found[1],)
    assert subjects(["toy.laws_sums"], []) != ()
    assert subjects(["toy.nothing"], []) == "toy.nothing"
    assert subjects(["nothing.at_all"], []) == "nothing.at_all"


def test_tests_that_execute_the_statement(toy: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Clause: TOOL-MUTATION-4."""
    monkeypatch.syspath_prepend(toy)
    found = subjects(["toy.sums"], [])
    assert not isinstance(found, str)
    _, every = draw(found, "toy", None, 1)
    tests = {"a": 1.0, "b": 0.5, "c": 0.2, "d": 0.1}
    path = found[0].path
    known = Baseline(tests, (), {path: {4: (-1,), 9: (1, 2), 13: (0,)}}, ())
    by_line = {drawn.mutant.line: reached(drawn, known) for drawn in every}
    assert by_line[4] == ("a", "b", "c", "d")
    assert by_line[9] == ("b", "c")
    assert by_line[13] == ("a",)
    assert by_line[19] == ()
    assert list(limits("abc", {"a": 1, "b": 0, "c": 0}, known).items()) == [
        ("a", 7.0), ("c", 3.0), ("b", 4.5),
    ]  # fmt: skip


def test_wrong_names_and_no_tests(toy: Path) -> None:
    """Clause: TOOL-MUTATION-5."""
    assert command(toy, "toy.nothing").returncode == 2
    assert command(toy, "toy.sums", "json").returncode == 2
    empty = command(toy, "toy.sums", "--tests", "toy")
    assert (empty.returncode, empty.stderr) == (4, "no test passes\n")


def test_interrupted_it_reports_what_was_done(toy: Path) -> None:
    """Clause: TOOL-MUTATION-5."""
    (toy / "tests" / "test_toy.py").write_text(
        "import pathlib, time\nfrom toy.sums import small\n\n"
        "def test_small():\n    pathlib.Path('ran').open('a').write('x')\n"
        "    time.sleep(1)\n    assert small(2)\n"
    )
    begun = subprocess.Popen(
        [sys.executable, *AS_A_USER, "toy.sums", "--json", "out.json"],
        cwd=toy, env=BARE, stdout=subprocess.PIPE, text=True,
    )  # fmt: skip
    end = monotonic() + 60
    while not ((toy / "ran").exists() and (toy / "ran").stat().st_size >= 4):
        assert monotonic() < end
        sleep(0.05)
    os.kill(begun.pid, signal.SIGINT)
    printed, _ = begun.communicate(timeout=60)
    report = read(toy / "out.json")
    assert begun.returncode == 130
    assert not report.complete
    assert 0 < len(report.judged) < report.sampled
    assert printed.splitlines()[-1].startswith("interrupted: ")
