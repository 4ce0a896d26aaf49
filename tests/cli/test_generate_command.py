"""`clers generate sphere`: words, files of connectivity, and mesh files with made-up points."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from clers.cli.main import app
from clers.cli.output import Exit
from clers.edgebreaker.encode import encode
from clers.generate.uniform import uniform_sphere


def clers(*arguments: str) -> Result:
    return CliRunner().invoke(app, list(arguments))


def test_words_of_several_seeds() -> None:
    """TOOL-GENERATE-1."""
    done = clers("generate", "sphere", "-n", "30", "--seed", "5", "--count", "3")
    assert done.exit_code == Exit.CONFORMING
    words = [encode(uniform_sphere(30, seed)).stream.word for seed in (5, 6, 7)]
    assert done.stdout.splitlines() == words


def test_without_a_seed_it_is_0() -> None:
    """TOOL-GENERATE-1."""
    one = clers("generate", "sphere", "-n", "12").stdout
    assert one == clers("generate", "sphere", "-n", "12", "--seed", "0").stdout
    assert one == encode(uniform_sphere(12, 0)).stream.word + "\n"


@pytest.mark.parametrize("suffix", [".ply", ".off", ".obj", ".clers"])
def test_files(tmp_path: Path, suffix: str) -> None:
    """TOOL-GENERATE-1: a sphere of so many vertices, with positions only in mesh files."""
    out = tmp_path / f"ball{suffix}"
    done = clers("generate", "sphere", "-n", "25", "--seed", "1", "-o", str(out))
    assert done.stdout == f"{out}: 25 vertices, 46 faces, seed 1\n"
    said = json.loads(clers("info", str(out), "--json").stdout)
    assert (said["vertices"], said["faces"], len(said["components"])) == (25, 46, 1)
    assert said["components"][0]["genus"] == 0
    assert json.loads(clers("word", str(out), "--json").stdout)["word"] == (
        encode(uniform_sphere(25, 1)).stream.word
    )


def test_several_files(tmp_path: Path) -> None:
    """TOOL-GENERATE-1: their names are numbered."""
    out = tmp_path / "ball.off"
    assert clers("generate", "sphere", "-n", "9", "--count", "2", "-o", str(out)).exit_code == 0
    assert sorted(p.name for p in tmp_path.iterdir()) == ["ball-0.off", "ball-1.off"]


def test_a_file_that_cannot_be_written(tmp_path: Path) -> None:
    """TOOL-GENERATE-1: one line and exit 1; three vertices are wrong usage."""
    for name in ("ball.xyz", "none/ball.clers"):
        done = clers("generate", "sphere", "-n", "9", "-o", str(tmp_path / name))
        assert done.exit_code == Exit.NOT_CONFORMING
        assert name in done.output
    assert clers("generate", "sphere", "-n", "3").exit_code == Exit.USAGE
