"""The program as a whole: start-up, versions, exit codes, interrupts."""

import subprocess
import sys

from typer.testing import CliRunner

from clers import SPEC_VERSION, __version__
from clers.cli.main import app

INTERRUPTED = """
import sys
from clers.cli import main

@main.app.command()
def wait() -> None:
    print("working", flush=True)
    raise KeyboardInterrupt

sys.argv = ["clers", "wait"]
main.main()
"""

LOADED = """
import sys
from clers.cli import main
print(*sorted({".".join(name.split(".")[:2]) for name in sys.modules}))
"""


def python(program: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)


def test_interrupt() -> None:
    """Clause: TOOL-EXIT-2."""
    ended = python(INTERRUPTED)
    assert (ended.returncode, ended.stdout) == (130, "working\n")
    assert ended.stderr == "clers: interrupted\n"


def test_start_loads_nothing_heavy() -> None:
    """No library but Typer, and no chapter but chapter 0, before a command is known."""
    loaded = set(python(LOADED).stdout.split())
    ours = {name for name in loaded if name.startswith("clers.")}
    assert ours == {"clers.cli", "clers.conventions"}
    heavy = {"hypothesis", "numpy", "trimesh", "manifold3d", "matplotlib", "markdown_it", "msgspec"}
    assert not heavy & loaded
    assert "typer" in loaded


def test_version() -> None:
    """Clause: TOOL-EXIT-1."""
    result = CliRunner().invoke(app, ["--version"])
    assert result.exit_code == 0
    assert result.stdout == f"clers {__version__}, specification {SPEC_VERSION}\n"


def test_wrong_usage() -> None:
    """Clause: TOOL-EXIT-1."""
    for arguments in ([], ["none"], ["spec", "none"], ["spec", "show"], ["laws", "--none"]):
        assert CliRunner().invoke(app, arguments).exit_code == 2, arguments
