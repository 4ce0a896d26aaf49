"""The lemmas that z3 settles: each holds, and each control has a counterexample."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

FOLDER = Path(__file__).parents[2] / "proofs_notes/smt"
FILES = sorted(path.name for path in FOLDER.glob("*.py") if path.name != "asking.py")


def asked(path: Path) -> tuple[int, str]:
    """Exit code and output of one file, asked for JSON."""
    done = subprocess.run(
        [sys.executable, str(path), "--json"], capture_output=True, text=True, timeout=100
    )
    return done.returncode, done.stdout


@pytest.mark.parametrize("name", FILES)
def test_lemmas_hold_and_controls_fail(name: str) -> None:
    """Clause: TOOL-PROOF-7."""
    code, said = asked(FOLDER / name)
    rows = json.loads(said)
    names = [row["name"] for row in rows]
    answers = {(row["kind"], row["answer"]) for row in rows}
    assert answers == {("lemma", "holds"), ("control", "fails")}
    assert len(names) == len(set(names))
    assert code == 0


@pytest.mark.parametrize(
    ("kind", "claim", "code"),
    [
        ("Lemma", "n * n >= n", 0),
        ("Lemma", "n * n > n", 1),
        ("Control", "n * n > n", 0),
        ("Control", "n * n >= n", 1),
    ],
)
def test_exit_code(tmp_path: Path, kind: str, claim: str, code: int) -> None:
    """A lemma that is false ends with 1, and so does a control that is true. TOOL-PROOF-7."""
    file = tmp_path / "squares.py"
    file.write_text(
        f"""
import sys
sys.path.insert(0, {str(FOLDER)!r})
from asking import Control, Lemma, main
from z3 import Int
n = Int("n")
sys.exit(main([{kind}("square", "a square is no less", (), {claim})]))
"""
    )
    assert asked(file)[0] == code


def test_there_are_files() -> None:
    """Clause: TOOL-PROOF-7."""
    assert FILES == ["bytewise.py", "coder.py", "kernels.py", "lattice.py", "shifts.py"]
