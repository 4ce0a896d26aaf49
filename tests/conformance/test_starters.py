"""The sources to begin with: written, compiled, run, and examined by the doctor."""

import shutil
import subprocess
from pathlib import Path
from typing import Final

import pytest
from typer.testing import CliRunner

from clers.cli.main import app
from clers.conformance.bounds import Bounds
from clers.conformance.doctor import CHECKS, examine
from clers.conformance.outcome import NoProcess
from clers.conformance.starters import STARTERS, source

TOOLS: Final = {"python": "python3", "javascript": "node", "c": "cc", "rust": "rustc", "go": "go"}
HERE: Final = [language for language, tool in TOOLS.items() if shutil.which(tool)]


def test_each_language_has_a_tool() -> None:
    """ORCL-STARTER-1: and at least Python's is here."""
    assert list(STARTERS) == list(TOOLS)
    assert "python" in HERE


@pytest.mark.parametrize("language", HERE)
def test_a_starter_passes_the_doctor(language: str, tmp_path: Path) -> None:
    """Clauses: ORCL-STARTER-1, ORCL-STARTER-2."""
    starter = STARTERS[language]
    written = CliRunner().invoke(app, ["adapter", "init", language, "--into", str(tmp_path)])
    assert written.exit_code == 0, written.output
    assert written.stdout.splitlines() == [
        f"{tmp_path / starter.file}: written. Then:",
        *(f"  {command}" for command in starter.commands),
    ]
    if starter.build:
        subprocess.run(starter.build, cwd=tmp_path, check=True, timeout=300)
    program, *arguments = starter.run
    command = (program, *(str(tmp_path / argument) for argument in arguments))
    if program.startswith("./"):
        command = (str(tmp_path / program),)
    found = examine(command, Bounds(request=30.0, farewell=20.0))
    assert not isinstance(found, NoProcess), found
    assert [finding for finding in found if not finding.passed] == []
    assert len(found) == len(CHECKS)
    hello = found[0].found
    assert hello == f"my mesh library 0.1 in {language}: echo"


def test_nothing_is_overwritten(tmp_path: Path) -> None:
    """ORCL-STARTER-1."""
    mine = tmp_path / "adapter.c"
    mine.write_text("mine")
    again = CliRunner().invoke(app, ["adapter", "init", "c", "--into", str(tmp_path)])
    assert again.exit_code == 2
    assert mine.read_text() == "mine"
    fresh = tmp_path / "new" / "folder"
    assert CliRunner().invoke(app, ["adapter", "init", "c", "--into", str(fresh)]).exit_code == 0
    assert (fresh / "adapter.c").read_text() == source(STARTERS["c"])


def test_a_language_that_is_not_there(tmp_path: Path) -> None:
    """ORCL-STARTER-1."""
    done = CliRunner().invoke(app, ["adapter", "init", "cobol", "--into", str(tmp_path)])
    assert done.exit_code == 2
    assert list(tmp_path.iterdir()) == []
