"""The program as a whole: start-up, versions, exit codes, interrupts."""

import os
import subprocess
import sys

import pytest
from typer.testing import CliRunner

from clers import SPEC_VERSION, __version__
from clers.cli.main import app
from clers.kernels import COMPILED

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

RUN = """
from clers.cli.main import main
main()
"""

LOADED = """
import sys
from clers.cli import main
print(*sorted({".".join(name.split(".")[:2]) for name in sys.modules}))
"""

AFTER = """
import atexit, sys
from clers.__main__ import main
atexit.register(lambda: print(*sorted({".".join(x.split(".")[:2]) for x in sys.modules}),
                              file=sys.stderr))
sys.argv[1:] = sys.stdin.buffer.readline().decode().split()
main()
"""

HEAVY = {
    "hypothesis", "numpy", "trimesh", "manifold3d", "matplotlib", "markdown_it", "jinja2",
    "distributed", "rich",
}  # fmt: skip


def python(program: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)


def test_interrupt() -> None:
    """Clause: TOOL-EXIT-2."""
    ended = python(INTERRUPTED)
    assert (ended.returncode, ended.stdout) == (130, "working\n")
    assert ended.stderr == "clers: interrupted\n"


def test_start_loads_nothing_heavy() -> None:
    """TOOL-START-1: no library but Typer, no chapter but chapter 0, before a command is known."""
    loaded = set(python(LOADED).stdout.split())
    ours = {name for name in loaded if name.startswith("clers.")}
    assert ours == {"clers.cli", "clers.conventions"}
    assert not (HEAVY | {"msgspec"}) & loaded
    assert "typer" in loaded


ECHO = '{"id":1,"op":"echo","in":{}}'
ENCODE = (
    '{"id":2,"op":"mesh.encode","in":{"vertices":4,"accuracy":{"kind":"exact"},'
    '"faces":[[0,1,2],[0,2,3],[0,3,1],[1,3,2]],"code":"best"}}'
)
TUTORIAL = (
    '{"id":3,"op":"word.decode",'
    '"in":{"word":"CCCRCRRCRRE","handles":[],"components_with_boundary":0}}'
)
APPLY = '{"id":4,"op":"operator.apply","in":{"script":"attach 0 1"}}'


@pytest.mark.parametrize(
    ("words", "more"),
    [
        ("--help", {"msgspec"}),
        ("--version", {"msgspec"}),
        ("adapter --help", {"msgspec"}),
        (f"adapter reference\n{ECHO}\n{ENCODE}\n{TUTORIAL}", {"typer", "clers.operators"}),
        (f"adapter reference\n{ECHO}\n{TUTORIAL}", {"clers.container", "clers.operators"}),
        (f"adapter reference\n{APPLY}", {"typer", "clers.cli", "clers.container"}),
    ],
)
def test_what_is_quick_loads_nothing_heavy(words: str, more: set[str]) -> None:
    """Clauses: TOOL-START-1, TOOL-START-2."""
    ended = subprocess.run(
        [sys.executable, "-c", AFTER], input=f"{words}\n", capture_output=True, text=True
    )
    assert ended.returncode == 0, ended.stderr
    assert not (HEAVY | more) & set(ended.stderr.split())
    assert ended.stdout.count('"ok":') == words.count("\n")


def test_version() -> None:
    """Clauses: TOOL-EXIT-1, TOOL-BUILD-5."""
    result = CliRunner().invoke(app, ["--version"])
    assert result.exit_code == 0
    build = "compiled" if COMPILED else "interpreted"
    said = f"clers {__version__}, specification {SPEC_VERSION}, kernels {build}\n"
    assert result.stdout == said


def test_version_of_the_interpreted_build() -> None:
    """Clauses: TOOL-BUILD-4, TOOL-BUILD-5."""
    ended = subprocess.run(
        [sys.executable, "-c", "import sys; sys.argv[1:] = ['--version']\n" + RUN],
        env={**os.environ, "CLERS_KERNELS": "interpreted"},
        capture_output=True,
        text=True,
    )
    assert ended.returncode == 0
    assert ended.stdout.endswith(", kernels interpreted\n")


def test_wrong_usage() -> None:
    """Clause: TOOL-EXIT-1."""
    for arguments in ([], ["none"], ["spec", "none"], ["spec", "show"], ["laws", "--none"]):
        assert CliRunner().invoke(app, arguments).exit_code == 2, arguments
