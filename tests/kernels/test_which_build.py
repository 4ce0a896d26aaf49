"""Which text of a kernel runs: on copies that lie alone, with false machine code beside them.

What is no machine code cannot be imported, so that an attempt to run it shows.
"""

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from hashlib import sha256
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path

import pytest

from clers import kernels
from clers.kernels import COMPILED, STAMP, digest

NAMES = tuple(sorted(path.stem for path in kernels.HERE.glob("*.py") if path.stem != "__init__"))

SAY = """
import sys
from importlib import import_module
from clers.kernels import COMPILED
print(COMPILED)
for name in sys.argv[1:]:
    try:
        print(import_module(f"clers.kernels.{name}").__file__)
    except ImportError:
        print("machine code")
"""


def said(folder: Path, *names: str, wish: str | None = None) -> list[str]:
    """Whether the kernels in a folder are compiled, and where those named come from."""
    environment = {key: value for key, value in os.environ.items() if key != "CLERS_KERNELS"}
    environment["PYTHONPATH"] = str(folder)
    if wish is not None:
        environment["CLERS_KERNELS"] = wish
    ended = subprocess.run(
        [sys.executable, "-c", SAY, *names], env=environment, capture_output=True, text=True
    )
    assert ended.returncode == 0, ended.stderr
    return ended.stdout.split("\n")[:-1]


@pytest.fixture
def copied(tmp_path: Path) -> Path:
    """A folder with a copy of the kernels and nothing else of the package."""
    into = tmp_path / "clers" / "kernels"
    into.mkdir(parents=True)
    shutil.copy(kernels.HERE.parent / "__init__.py", into.parent)
    for source in kernels.HERE.glob("*.py"):
        shutil.copy(source, into)
    return into


@pytest.fixture
def built(copied: Path) -> Path:
    """The same with what pretends to be machine code of `table`, and the right stamp."""
    (copied / f"table{EXTENSION_SUFFIXES[0]}").write_bytes(b"no machine code")
    (copied / STAMP).write_text(f"{digest(copied)}\n", "ascii")
    return copied


def test_kernels_stand_alone(copied: Path) -> None:
    """TOOL-BUILD-1: all are imported where no other part of the package is; from their sources."""
    sources = [str(copied / f"{name}.py") for name in NAMES]
    assert said(copied.parents[1], *NAMES) == ["False", *sources]
    assert len(NAMES) == 14


def test_machine_code_of_these_sources_runs(built: Path) -> None:
    """TOOL-BUILD-3: the stamp is right; the kernel that has no machine code is its source."""
    assert said(built.parents[1], "table", "flat") == [
        "True",
        "machine code",
        str(built / "flat.py"),
    ]


def changed(folder: Path) -> None:
    with (folder / "urn.py").open("a", encoding="utf-8") as source:
        source.write("\n")


def renamed(folder: Path) -> None:
    (folder / "urn.py").rename(folder / "lottery.py")


def added(folder: Path) -> None:
    (folder / "another.py").write_bytes(b"")


def unstamped(folder: Path) -> None:
    (folder / STAMP).unlink()


def stamped_otherwise(folder: Path) -> None:
    (folder / STAMP).write_text(f"{digest(folder)[1:]}0\n", "ascii")


@pytest.mark.parametrize("spoil", [changed, renamed, added, unstamped, stamped_otherwise])
def test_machine_code_of_other_sources_does_not_run(
    built: Path, spoil: Callable[[Path], None]
) -> None:
    """Clause: TOOL-BUILD-3."""
    spoil(built)
    assert said(built.parents[1], "table") == ["False", str(built / "table.py")]


def test_the_package_itself_may_change(built: Path) -> None:
    """TOOL-BUILD-3: `__init__.py` is no kernel."""
    changed_too = built / "__init__.py"
    changed_too.write_text(f"{changed_too.read_text('utf-8')}\n", "utf-8")
    assert said(built.parents[1], "table") == ["True", "machine code"]


@pytest.mark.parametrize(
    ("wish", "compiled"),
    [("interpreted", False), ("", True), ("compiled", True), ("Interpreted", True)],
)
def test_the_environment_asks_for_sources(built: Path, wish: str, compiled: bool) -> None:
    """Clause: TOOL-BUILD-4."""
    found = "machine code" if compiled else str(built / "table.py")
    assert said(built.parents[1], "table", wish=wish) == [str(compiled), found]


def test_the_same_choice_in_this_process(built: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """TOOL-BUILD-3, TOOL-BUILD-4: what the processes above do, where a changed text shows too."""
    monkeypatch.setattr(kernels, "HERE", built)
    monkeypatch.delenv("CLERS_KERNELS", raising=False)
    assert kernels._compiled()
    monkeypatch.setenv("CLERS_KERNELS", "interpreted")
    assert not kernels._compiled()
    monkeypatch.setenv("CLERS_KERNELS", "")
    changed(built)
    assert not kernels._compiled()
    unstamped(built)
    assert not kernels._compiled()


def test_the_digest_by_hand(tmp_path: Path) -> None:
    """Clause: TOOL-BUILD-3."""
    for name, text in (("b.py", "2"), ("a.py", "1"), ("__init__.py", "0"), ("c.txt", "3")):
        (tmp_path / name).write_text(text, "ascii")
    assert digest(tmp_path) == sha256(b"a.py\x001\x00b.py\x002\x00").hexdigest()


def test_here_all_kernels_are_of_one_build() -> None:
    """TOOL-BUILD-5: what COMPILED says is what is imported."""
    endings = [Path(line).name for line in said(kernels.HERE.parents[1], *NAMES, wish=wish())[1:]]
    suffix = EXTENSION_SUFFIXES[0] if COMPILED else ".py"
    assert endings == [f"{name}{suffix}" for name in NAMES]


def wish() -> str:
    """What this process was asked for."""
    return os.environ.get("CLERS_KERNELS", "")
