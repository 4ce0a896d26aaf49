"""The second implementation, written from the specification alone, judged like any other."""

import re
import shlex
import shutil
from collections import Counter
from pathlib import Path
from typing import Final

import msgspec
import pytest
from typer.testing import CliRunner, Result

from clers.cli.main import app
from clers.cli.output import Exit
from clers.conformance.bounds import Bounds
from clers.conformance.doctor import CHECKS, examine
from clers.conformance.judging.judged import Judged, Status
from clers.conformance.outcome import NoProcess
from clers.conventions.clause import Clause

SECOND: Final = Path(__file__).parents[1] / "second"
SOURCES: Final = sorted(SECOND.rglob("*.js"))
IDS: Final = re.compile(r"\b[A-Z]+-[A-Z]+-[0-9]+\b")
REQUIRED: Final = re.compile(r"require\('([^']*)'\)")
UNDECLARED: Final = {"operator.apply is not declared", "max_faces is not declared"}
PATIENT: Final = ("--seconds", "30", "--start", "60")


def node() -> str:
    """The interpreter: without it nothing can be said of this implementation, so tests fail."""
    found = shutil.which("node")
    assert found is not None, "tests/second needs Node 20: the command `node` is not there"
    return found


def check(folder: Path, *arguments: str) -> Result:
    line = shlex.join((node(), str(folder / "adapter.js")))
    return CliRunner().invoke(app, ["check", "-a", line, *PATIENT, *arguments])


def judged(path: Path) -> list[Judged]:
    return [msgspec.json.decode(line, type=Judged) for line in path.read_bytes().splitlines()]


def test_the_doctor_finds_it_well() -> None:
    """ORCL-DOCTOR-1."""
    found = examine((node(), str(SECOND / "adapter.js")), Bounds(request=30.0, farewell=20.0))
    assert not isinstance(found, NoProcess), found
    assert [finding for finding in found if not finding.passed] == []
    assert len(found) == len(CHECKS)
    assert found[0].found.startswith("second 1.0 in javascript: echo, surface.classify, ")


def test_it_passes_every_vector_of_what_it_declares(tmp_path: Path) -> None:
    """Clauses: ORCL-CHECK-1, ORCL-HELLO-2, ORCL-JUDGE-6."""
    report = tmp_path / "report.jsonl"
    done = check(SECOND, "--report", f"jsonl={report}")
    assert done.exit_code == Exit.CONFORMING, done.output
    results = judged(report)
    assert {result.status for result in results} == {Status.PASS, Status.SKIP}
    skipped = [result for result in results if result.status is Status.SKIP]
    assert {result.why for result in skipped} == UNDECLARED
    passed = Counter(result.op for result in results if result.status is Status.PASS)
    assert set(passed) == {result.op for result in results} - {"operator.apply"}
    assert len(skipped) * 20 < len(results)


@pytest.mark.parametrize(
    ("file", "right", "mistake", "cases"),
    [
        ("codes/golden.js", "[2, 4, 3, 4, 5]", "[2, 4, 4, 3, 5]", "golden-cube-*"),
        ("rejection.js", "'bad-residual'],", "],", "file-lattice-*"),
    ],
)
def test_a_mistake_in_it_is_seen(
    tmp_path: Path, file: str, right: str, mistake: str, cases: str
) -> None:
    """ORCL-CHECK-1: so that passing says something."""
    copy = tmp_path / "second"
    shutil.copytree(SECOND, copy)
    source = (copy / file).read_text()
    assert source.count(right) == 1
    (copy / file).write_text(source.replace(right, mistake))
    assert check(copy, "--only", cases).exit_code == Exit.NOT_CONFORMING


def test_it_stands_alone() -> None:
    """Nothing of the reference and no package is used: its own modules and Node's."""
    assert len(SOURCES) > 40
    for source in SOURCES:
        for name in REQUIRED.findall(source.read_text()):
            own = (source.parent / name).resolve()
            assert name == "node:fs" or (own in SOURCES), f"{source}: {name}"


@pytest.mark.parametrize("source", [*SOURCES, SECOND / "README.md"], ids=lambda path: path.name)
def test_the_clauses_that_it_cites_are_there(source: Path) -> None:
    """CONV-CLAUSE-8."""
    assert set(IDS.findall(source.read_text())) <= {clause.value for clause in Clause}


def test_its_readme_names_its_files() -> None:
    """CONV-CLAUSE-2 is about the reference; here the readme is what leads to the code."""
    readme = (SECOND / "README.md").read_text()
    for source in SOURCES:
        folder = f"{source.parent.name}/"
        assert f"`{source.name}`" in readme or f"`{folder}`" in readme, source
