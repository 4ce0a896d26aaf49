"""What the readme shows is what the program prints."""

import os
import re
import shlex
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Final

import pytest
from typer.testing import CliRunner

from clers.cli.main import app

ROOT: Final = Path(__file__).parents[2]
BLOCK: Final = re.compile(r"```console\n(.*?)```", re.DOTALL)


def sessions() -> Iterator[tuple[str, str]]:
    """Each command with what is shown to come of it, up to an ellipsis."""
    for block in BLOCK.findall((ROOT / "README.md").read_text()):
        for piece in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]:
            command, _, shown = piece.partition("\n")
            yield command, shown.strip().removesuffix("…").strip()


@pytest.mark.parametrize(("command", "shown"), list(sessions()), ids=lambda text: str(text)[:40])
def test_the_readme_is_true(command: str, shown: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every command that is shown; one that is cut off is shown from its beginning."""
    monkeypatch.chdir(ROOT)
    monkeypatch.setenv("PATH", str(Path(sys.executable).parent), prepend=os.pathsep)
    program, *arguments = shlex.split(command)
    assert program == "clers"
    done = CliRunner().invoke(app, arguments)
    lines = [line.rstrip() for line in (done.stdout + done.stderr).splitlines()]
    assert "\n".join(lines).startswith(shown)


def test_there_are_sessions() -> None:
    assert len(list(sessions())) > 5
