"""`clers spec` on a small repository: what it prints, writes, and ends with."""

import json
from pathlib import Path

import pytest
from toy_repository import CLAUSES, FILES, edited, lock, write
from typer.testing import CliRunner

from clers.cli.main import app
from clers.specification.clause_module import replace_file
from clers.specification.lock import write_lock

BOXES = "spec/01-boxes.md"
CLAUSE_PY = "reference/clers/conventions/clause.py"
LOCK = "spec/lock.json"


def call(root: Path, *arguments: str) -> tuple[int, str]:
    """Exit code and standard output of `clers spec`."""
    result = CliRunner().invoke(app, ["spec", *arguments, "--root", str(root)])
    return result.exit_code, result.stdout


def test_check_accepts(tmp_path: Path) -> None:
    """Clause: TOOL-EXIT-1."""
    assert call(write(tmp_path), "check") == (0, "4 clauses, 15 citations, 0 findings\n")


def test_check_names_file_line_and_id(tmp_path: Path) -> None:
    """Clauses: TOOL-EXIT-1, CONV-CLAUSE-4."""
    files = edited((BOXES, "> **BOX-LID-2.** A lid", "> **BOX-LID-2.** The lid"))
    code, said = call(write(tmp_path, files), "check")
    places = (
        "reference/clers/toys.py:13 (lid); tests/test_toys.py:9 (test_lid); "
        "proofs_notes/README.md:9; proofs_notes/lids.md:3; proofs_notes/lids.md:8; "
        "spec/01-boxes.md:20"
    )
    text = f"{BOXES}:10: BOX-LID-2: changed since it was locked; read again: {places} [changed]"
    assert (code, said.splitlines()[0]) == (1, text)


def test_check_as_json(tmp_path: Path) -> None:
    """Clause: TOOL-OUTPUT-1."""
    code, said = call(write(tmp_path, edited((BOXES, "2.** A", "2.** The"))), "check", "--json")
    answer = json.loads(said)
    finding = answer["findings"][0]
    assert (code, answer["clauses"], len(answer["findings"])) == (1, 4, 1)
    assert (finding["rule"], finding["line"], finding["clause"]) == ("changed", 10, "BOX-LID-2")


def test_root_is_found_upward(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Clause: TOOL-EXIT-1."""
    write(tmp_path)
    monkeypatch.chdir(tmp_path / "reference/clers")
    assert CliRunner().invoke(app, ["spec", "check"]).exit_code == 0


def test_no_repository_is_wrong_usage(tmp_path: Path) -> None:
    """Clause: TOOL-EXIT-1."""
    assert call(tmp_path, "check") == (2, "")
    assert call(tmp_path / "none", "check") == (2, "")
    assert call(write(tmp_path) / "reference", "check") == (2, "")


def test_generate(tmp_path: Path) -> None:
    """The module written is the one written by hand. Clause: CONV-CLAUSE-9."""
    write(tmp_path, {**FILES, CLAUSE_PY: "stale\n"})
    assert call(tmp_path, "generate", "--check")[0] == 1
    assert (tmp_path / CLAUSE_PY).read_text() == "stale\n"
    assert call(tmp_path, "generate") == (0, f"{CLAUSE_PY}: 4 clauses, written\n")
    assert (tmp_path / CLAUSE_PY).read_text() == FILES[CLAUSE_PY]
    assert (tmp_path / CLAUSE_PY).stat().st_mode & 0o777 == 0o644
    assert call(tmp_path, "generate", "--check") == (0, f"{CLAUSE_PY}: 4 clauses, unchanged\n")


def test_a_file_is_replaced_whole_or_not(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-9."""
    target = tmp_path / "folder"
    (target / "inside").mkdir(parents=True)
    with pytest.raises(OSError, match="folder"):
        replace_file(target, "text")
    assert [path.name for path in tmp_path.iterdir()] == ["folder"]


def test_lock_writes_the_named_clauses(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-4."""
    write(tmp_path, {**FILES, LOCK: "{}"})
    code, said = call(tmp_path, "lock", "BOX-LID-2", "TOY-RULE-1")
    part = {name: CLAUSES[name] for name in ("BOX-LID-2", "TOY-RULE-1")}
    assert code == 0
    assert json.loads((tmp_path / LOCK).read_text()) == json.loads(lock(part))
    assert said.splitlines()[:4] == [
        "BOX-LID-2 locked; read again:",
        "  code   reference/clers/toys.py:13 (lid)",
        "  test   tests/test_toys.py:9 (test_lid)",
        "  note   proofs_notes/README.md:9",
    ]


def test_lock_is_sorted_by_number() -> None:
    """So that a change of one clause is a change of one line. Clause: CONV-CLAUSE-4."""
    written = write_lock({"BOX-LID-10": "a", "TOY-RULE-1": "b", "BOX-LID-9": "c", "": "d"})
    assert list(json.loads(written)) == ["", "BOX-LID-9", "BOX-LID-10", "TOY-RULE-1"]
    assert len(written.splitlines()) == 6


def test_a_spoilt_lock_is_no_lock(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-4."""
    write(tmp_path, {**FILES, LOCK: "<<<<<<< ours\n"})
    assert call(tmp_path, "check")[1].count("[not-locked]") == 4


def test_example_says_what_it_got(tmp_path: Path) -> None:
    """Clause: CONV-PROSE-2."""
    for new, told in [
        ("+ 1\n4", "lids + 1 expected: 4 got: 3"),
        ("+ 1", "lids + 1 expected nothing got: 3"),
        ("/ 0\n3", "lids / 0 raised ZeroDivisionError: division by zero"),
    ]:
        said = call(write(tmp_path, edited((BOXES, "+ 1\n3", new))), "check")[1]
        assert said.splitlines()[0] == f"{BOXES}:16: {told} [example]"


def test_lock_all(tmp_path: Path) -> None:
    """New, changed and gone clauses, and no other, are printed. Clause: CONV-CLAUSE-4."""
    stale = {name: text for name, text in CLAUSES.items() if name != "BOX-LID-2"}
    old = lock({**stale, "BOX-LID-1": "A box.", "BOX-LID-9": "Gone."})
    write(tmp_path, {**FILES, LOCK: old})
    code, said = call(tmp_path, "lock", "--all")
    assert code == 0
    assert json.loads((tmp_path / LOCK).read_text()) == json.loads(lock())
    assert [line for line in said.splitlines() if not line.startswith("  ")] == [
        "BOX-LID-1 locked; read again:",
        "BOX-LID-2 locked; read again:",
        "BOX-LID-9 dropped",
        f"{LOCK}: 3 entries changed, 4 in all",
    ]
    assert call(tmp_path, "check")[0] == 0


@pytest.mark.parametrize("words", [["BOX-LID-3"], [], ["--all", "BOX-LID-2"]])
def test_lock_refuses(words: list[str], tmp_path: Path) -> None:
    """Unknown ids, and neither or both of ids and `--all`. Clause: TOOL-EXIT-1."""
    write(tmp_path, {**FILES, LOCK: "{}"})
    assert call(tmp_path, "lock", *words) == (2, "")
    assert (tmp_path / LOCK).read_text() == "{}"


def test_show(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-2."""
    assert call(write(tmp_path), "show", "BOX-LID-2") == (
        0,
        "BOX-LID-2  (spec/01-boxes.md:10)\nA lid has no box.\n\n"
        "  code   reference/clers/toys.py:13 (lid)\n"
        "  test   tests/test_toys.py:9 (test_lid)\n"
        "  note   proofs_notes/README.md:9\n"
        "  note   proofs_notes/lids.md:3\n"
        "  note   proofs_notes/lids.md:8\n"
        "  prose  spec/01-boxes.md:20\n",
    )
    assert call(tmp_path, "show", "BOX-LID-3") == (2, "")


def test_show_as_json(tmp_path: Path) -> None:
    """Clause: TOOL-OUTPUT-1."""
    answer = json.loads(call(write(tmp_path), "show", "BOX-LID-1", "--json")[1])
    assert answer["clause"]["text"] == "A box has one lid;\nit lies on top."
    assert answer["hash"] == json.loads(lock())["BOX-LID-1"]
    assert answer["sites"]["law"] == ["reference/clers/boxes/laws.py:6 (one-lid)"]


def test_list(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-2."""
    assert call(write(tmp_path), "list", "--chapter", "1") == (
        0,
        "clause     code  law  test  note  prose  text\n"
        "BOX-LID-1  2     1    0     1     1      A box has one lid; it lies on top.\n"
        "BOX-LID-2  1     0    1     3     1      A lid has no box.\n",
    )
    answer = json.loads(call(tmp_path, "list", "--json")[1])
    assert [clause["clause"] for clause in answer] == list(CLAUSES)
