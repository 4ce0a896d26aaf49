"""`clers operators`, run as a user runs it: TOOL-OPERATORS-1 to TOOL-OPERATORS-3."""

import json
from pathlib import Path
from typing import Final
from xml.etree import ElementTree

import pytest
from typer.testing import CliRunner, Result

from clers.cli.main import app
from clers.cli.output import Exit

MESHES: Final = Path(__file__).parents[2] / "corpus" / "meshes"
RING: Final = str(MESHES / "ring.off")
TORUS_WITH_HANDLES: Final = str(MESHES / "eight.off")


def clers(*arguments: str, typed: str = "") -> Result:
    return CliRunner().invoke(app, list(arguments), input=typed)


def last_numbers(done: Result) -> dict[str, int]:
    assert done.exit_code == Exit.CONFORMING, done.output
    numbers: dict[str, int] = json.loads(done.stdout)["stages"][-1]["numbers"]
    return numbers


@pytest.mark.parametrize("by", ["handles", "euler", "word"])
def test_build_then_apply(by: str) -> None:
    """TOOL-OPERATORS-1: each way ends with the annulus; the word's has its curves as polygons."""
    script = clers("operators", "build", RING, "--by", by).stdout
    numbers = last_numbers(clers("operators", "apply", "-", "--json", typed=script))
    closed = 2 if by == "word" else 0
    assert numbers["vertices"] == 6
    assert numbers["faces"] == 6 + closed
    assert numbers["loops"] == 2 - closed
    assert numbers["χ"] == closed
    assert ("make-stv" in script) == (by == "euler")
    assert ("zero-handle-polygon" in script) == (by == "word")


@pytest.mark.parametrize("by", ["handles", "euler", "word"])
def test_apart(by: str) -> None:
    """TOOL-OPERATORS-1: nothing is left."""
    script = clers("operators", "build", RING, "--by", by, "--apart").stdout
    numbers = last_numbers(clers("operators", "apply", "-", "--json", typed=script))
    assert set(numbers.values()) == {0}


def test_build_as_json() -> None:
    """TOOL-OPERATORS-1: eight.off has genus 2."""
    lines = json.loads(clers("operators", "build", TORUS_WITH_HANDLES, "--json").stdout)
    numbers = last_numbers(clers("operators", "apply", "-", "--json", typed=";".join(lines)))
    assert (numbers["χ"], numbers["genus"], numbers["loops"]) == (-2, 2, 0)


def test_apply_prints_a_table(tmp_path: Path) -> None:
    """TOOL-OPERATORS-2."""
    script = tmp_path / "script"
    script.write_text("zero-handle 0 1 2; glue 1 0 3")
    done = clers("operators", "apply", str(script))
    assert done.exit_code == Exit.CONFORMING
    rows = [line.split() for line in done.stdout.splitlines()]
    assert rows == [
        ["step", "operator", *["vertices", "edges", "faces", "χ", "components", "genus", "loops"]],
        ["0", *["zero-handle", "0", "1", "2"], *["3", "3", "1", "1", "1", "0", "1"]],
        ["1", *["glue", "1", "0", "3"], *["4", "5", "2", "1", "1", "0", "1"]],
    ]


def test_dimensions_that_come_later_are_zero_before() -> None:
    """TOOL-OPERATORS-2: the first stage has no edges."""
    done = clers("operators", "apply", "-", typed="attach 0; attach 0 1 / 0")
    assert [line.split()[-7:] for line in done.stdout.splitlines()] == [
        ["operator", "#0", "χ", "components", "b0", "#1", "b1"],
        ["0", "1", "1", "1", "1", "0", "0"],
        ["0", "2", "1", "1", "1", "1", "0"],
    ]


def test_what_did_nothing_says_why() -> None:
    """TOOL-OPERATORS-2: a closed surface has no corner to fill."""
    done = clers("operators", "apply", "-", typed="fill-corner 0; split-face 0")
    assert done.stdout.splitlines()[0].endswith("nothing done")
    assert done.stdout.splitlines()[2].endswith("no-candidate")


def test_begin_on_a_complex(tmp_path: Path) -> None:
    """TOOL-OPERATORS-2: the frontier of a triangle gets its inside."""
    start = tmp_path / "circle.json"
    start.write_text("[[0,1],[0,2],[1,2]]")
    script = "attach 0 1 2 / 0 1 / 0 2 / 1 2"
    done = clers("operators", "apply", "-", "--start", str(start), "--json", typed=script)
    assert last_numbers(done)["b1"] == 0
    start.write_text("[[0,1")
    done = clers("operators", "apply", "-", "--start", str(start), typed=script)
    assert done.exit_code == Exit.NOT_CONFORMING
    assert f"{start}: malformed: unreadable-file" in done.stderr


def test_begin_on_a_mesh() -> None:
    """TOOL-OPERATORS-2."""
    done = clers("operators", "apply", "-", "--start", RING, "--json", typed="glue 0 2 9")
    document = json.loads(done.stdout)
    assert document["stages"][0]["operator"] == ""
    assert document["stages"][0]["numbers"]["loops"] == 2


def test_a_script_that_does_not_apply() -> None:
    """TOOL-OPERATORS-2: the stages before, one line, exit code 1."""
    text = "zero-handle 0 1 2; glue 0 1 3"
    done = clers("operators", "apply", "-", typed=text)
    assert done.exit_code == Exit.NOT_CONFORMING
    assert len(done.stdout.splitlines()) == 2
    assert done.stderr.startswith("-: invalid: operator-not-applicable at step 1 [OPER-SURFACE-3]")
    assert len(done.stderr.splitlines()) == 1
    said = clers("operators", "apply", "-", "--json", typed=text)
    assert said.exit_code == Exit.NOT_CONFORMING
    document = json.loads(said.stdout)
    assert len(document["stages"]) == 1
    assert document["reject"]["at"] == {"step": 1}
    assert document["reject"]["class"] == "invalid"
    assert document["reject"]["reason"] == "operator-not-applicable"
    assert document["reject"]["clause"] == "OPER-SURFACE-3"


def test_no_such_script(tmp_path: Path) -> None:
    """TOOL-OPERATORS-2."""
    done = clers("operators", "apply", str(tmp_path / "none"))
    assert done.exit_code == Exit.NOT_CONFORMING
    assert "unreadable-file" in done.stderr


@pytest.mark.parametrize("suffix", ["svg", "png"])
def test_draw(tmp_path: Path, suffix: str) -> None:
    """TOOL-OPERATORS-3."""
    out = tmp_path / f"steps.{suffix}"
    done = clers("operators", "draw", "-", "-o", str(out), typed="attach 0 1 2; attach 3")
    assert done.exit_code == Exit.CONFORMING
    assert done.stdout == f"{out}: 2 stages\n"
    data = out.read_bytes()
    if suffix == "png":
        assert data.startswith(b"\x89PNG")
    else:
        groups = [g.get("id") for g in ElementTree.fromstring(data) if g.get("id")]
        assert groups == ["stage-0", "stage-1"]


@pytest.mark.parametrize(
    ("typed", "words"),
    [
        ("attach 0 1 2; attach 0 1 2 3 / 0 1 2", "not-drawable at step 1"),
        ("", "not-drawable of the whole input"),
        ("glue 0 1 2", "operator-not-applicable at step 0"),
    ],
)
def test_not_drawable(tmp_path: Path, typed: str, words: str) -> None:
    """TOOL-OPERATORS-3: nothing is written."""
    out = tmp_path / "steps.svg"
    done = clers("operators", "draw", "-", "-o", str(out), typed=typed)
    assert done.exit_code == Exit.NOT_CONFORMING
    assert words in done.stderr
    assert not out.exists()


def test_draw_into_another_format(tmp_path: Path) -> None:
    """TOOL-OPERATORS-3."""
    done = clers("operators", "draw", "-", "-o", str(tmp_path / "steps.gif"), typed="attach 0")
    assert done.exit_code == Exit.USAGE
