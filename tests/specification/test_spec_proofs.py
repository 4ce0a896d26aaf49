"""Rules on the proof notes, each seen to fail on a small repository with one fault in it."""

import json
from pathlib import Path

import pytest
from toy_repository import FILES, edited, found, write
from typer.testing import CliRunner

from clers.cli.main import app
from clers.specification.markdown import page
from clers.specification.proof_table import ids_in_words, ways_in_words
from clers.specification.proofs import RULES, all_theorems, without_comments
from clers.specification.repository import read
from clers.specification.theorems import Prose, Smt, theorems, ways

NOTE = "proofs_notes/lids.md"
README = "proofs_notes/README.md"
COQ = "proofs_notes/coq/Lids.v"
SMT = "proofs_notes/smt/lids.py"
BOXES = "spec/01-boxes.md"


def sentences(root: Path, registry: tuple[str, ...] | str = ()) -> list[str]:
    """What the rules on proofs find, the stale table apart."""
    of = read(root, registry)
    found = [finding for rule in RULES for finding in rule(of)]
    return [finding.sentence for finding in found if finding.path != README]


def call(root: Path, *arguments: str) -> tuple[int, str]:
    result = CliRunner().invoke(app, ["spec", "proofs", *arguments, "--root", str(root)])
    return result.exit_code, result.stdout


@pytest.mark.parametrize(
    ("path", "old", "new", "line", "said"),
    [
        (NOTE, "`no-lid-of-a-lid`", "no-lid", 7, "a theorem's name is `like-this`, not no-lid"),
        (NOTE, "- **Clauses.** BOX-LID-2", "- **Clauses.** lids", 8, "justifies no clause"),
        (
            NOTE,
            "that lids are boxes",
            "",
            12,
            "does not say what it assumes, or that it is nothing",
        ),
        (NOTE, "`tests/test_toys.py`\n", "none\n", 11, "has no laws, and no reason after `none:`"),
        (NOTE, "; prose", "; of course", 9, "is known in no way there is: Coq"),
        (NOTE, "- **Assumes.** that lids are boxes\n", "", 7, "its fields are Theorem, Clauses"),
        (NOTE, "`Clers.Lids.none`", "`Clers.Lips.none`", 9, "there is no proofs_notes/coq/Lips.v"),
        (NOTE, "`Clers.Lids.none`", "`Clers.Lids.lid`", 9, "Lids.v states no theorem lid"),
        (NOTE, "`Clers.Lids.none`", "`Lids.none`", 9, "is not of the form Clers.File.theorem"),
        (NOTE, "smt/lids.py: none", "smt/lips.py: none", 9, "no proofs_notes/smt/lips.py"),
        (NOTE, "smt/lids.py: none", "smt/lids.py: some", 9, "smt/lids.py has no lemma some"),
        (NOTE, "certificates/lids", "certificates/lips", 9, "no proofs_notes/certificates/lips"),
        (NOTE, "(`tests/test_toys.py`)", "(`two-lids`)", 9, "no law is named two-lids"),
        (NOTE, "`tests/test_toys.py`\n", "`two-lids`\n", 11, "no law is named two-lids"),
        (NOTE, "`tests/test_toys.py`\n", "`tests/test_lid.py`\n", 11, "no test tests/test_lid.py"),
        (COQ, "exact I. Qed", "Admitted", 4, "takes something unproved: Admitted"),
        (SMT, ', Control("some", 2)', "", 1, "has lemmas and no control"),
        (BOXES, "[why BOX-LID-2]", "[why BOX-LID-1]", 20, "BOX-LID-1: a note is"),
        (BOXES, "](../proofs_notes/lids.md)", "]", 10, "theorem no-lid-of-a-lid justifies it"),
    ],
)
def test_dead_reference(
    path: str, old: str, new: str, line: int, said: str, tmp_path: Path
) -> None:
    """Clauses: TOOL-PROOF-1 to TOOL-PROOF-5, TOOL-PROOF-7."""
    faults = sentences(write(tmp_path, edited((path, old, new))))
    assert [fault for fault in faults if fault.startswith(f"{path}:{line}:") and said in fault], (
        faults
    )
    assert call(tmp_path)[0] == 1


def test_no_head_and_a_name_twice(tmp_path: Path) -> None:
    """Clause: TOOL-PROOF-1."""
    head = FILES[NOTE]
    other = {"proofs_notes/campaigns.md": "# C\n", "proofs_notes/coq/a.md": "# D\n"}
    files = {**FILES, **other, "proofs_notes/a.md": "# A\n", "proofs_notes/b.md": head}
    faults = sentences(write(tmp_path, files))
    assert [fault for fault in faults if "no theorem with a head" in fault] == [
        "proofs_notes/a.md:1: has no theorem with a head [proof]"
    ]
    twice = "theorem no-lid-of-a-lid is at proofs_notes/b.md:7 too [proof]"
    assert f"{NOTE}:7: {twice}" in faults


def test_an_id_of_no_clause(tmp_path: Path) -> None:
    """Clauses: CONV-CLAUSE-8, TOOL-PROOF-6."""
    code, said = call(write(tmp_path, edited((NOTE, "** BOX-LID-2", "** BOX-LID-9"))), "--check")
    assert code == 1
    assert f"{NOTE}:8: BOX-LID-9: no such clause [dangling]" in said.splitlines()


@pytest.mark.parametrize(
    "laws", ["`one-lid`", "one-lid", "`one-lid`, `tests/test_toys.py`", "none: nothing to run"]
)
def test_laws_that_are_there(laws: str, tmp_path: Path) -> None:
    """Clause: TOOL-PROOF-3."""
    files = edited((NOTE, "- **Laws.** `tests/test_toys.py`", f"- **Laws.** {laws}"))
    assert sentences(write(tmp_path, files)) == []


def test_a_broken_registry_is_no_fault_of_the_notes(tmp_path: Path) -> None:
    """Another rule says that it cannot be imported. Clause: TOOL-PROOF-3."""
    root = write(tmp_path, edited((NOTE, "`tests/test_toys.py`\n", "`two-lids`\n")))
    assert len(sentences(root)) == 1
    assert sentences(root, registry=("two-lids",)) == []
    assert sentences(root, registry="no module") == []


def test_other_ways(tmp_path: Path) -> None:
    """Several names at once, other people's proofs; and heads in fences are none. TOOL-PROOF-2."""
    ways = "Coq `Clers.Lids.none`, `Clers.Lids.M.none`; cited (A. Box; *Lids*, 1999)."
    other = _head("prose").replace("a-", "b-")
    text = f"# A\n\n```\n- **Theorem.** `x`\n```\n\n{_head(ways)}\n{other}"
    read_ = tuple(theorems(page("proofs_notes/a.md", text)))
    assert [type(item).__name__ for item in read_] == ["Theorem", "Theorem"]


def _head(ways: str) -> str:
    fields = ["Theorem.** `a-b`", "Clauses.** BOX-LID-1", f"Known by.** {ways}"]
    return "\n".join(f"- **{x}" for x in [*fields, "Laws.** none: no", "Assumes.** nothing"])


def test_comments_of_coq_nest() -> None:
    """Clause: TOOL-PROOF-4."""
    assert without_comments("a (* b (* c\n *) Axiom *) d") == "a \n d"
    assert without_comments("a (* Admitted") == "a "


def test_a_hole_in_a_comment_is_none(tmp_path: Path) -> None:
    """Clause: TOOL-PROOF-4."""
    assert sentences(write(tmp_path, edited((COQ, "(* No", "(* No Axiom")))) == []


def test_several_lemmas_of_a_file() -> None:
    """Clauses: TOOL-PROOF-2, TOOL-PROOF-6."""
    listed = ways("z3 `smt/a.py: x, y`, `smt/b.py: z`; prose.")
    assert listed == (Smt("smt/a.py", "x"), Smt("smt/a.py", "y"), Smt("smt/b.py", "z"), Prose())
    assert ways_in_words(listed) == "z3 `smt/a.py` (2 lemmas); z3 `smt/b.py: z`; prose"


def test_ranges() -> None:
    """Clause: TOOL-PROOF-6."""
    ids = ["BOX-LID-1", "BOX-LID-2", "BOX-LID-3", "BOX-LID-5", "BOX-LID-6", "TOY-RULE-7"]
    assert ids_in_words(ids) == "BOX-LID-1 to BOX-LID-3, BOX-LID-5, BOX-LID-6, TOY-RULE-7"
    assert ids_in_words(()) == ""


def test_table_is_written_and_checked(tmp_path: Path) -> None:
    """What was written by hand in the toy is what the command writes. Clause: TOOL-PROOF-6."""
    stale = edited((README, "| [`no-lid-of-a-lid`]", "| [`a-lid`]"))
    write(tmp_path, stale)
    assert found(tmp_path) == [("proof", README, 1, "")]
    assert call(tmp_path, "--check")[0] == 1
    assert (tmp_path / README).read_text() == stale[README]
    assert call(tmp_path, "--write")[0] == 0
    assert (tmp_path / README).read_text() == FILES[README]
    assert call(tmp_path, "--check")[0] == 0
    assert call(tmp_path, "--check", "--write")[0] == 2


def test_no_marks(tmp_path: Path) -> None:
    """Clause: TOOL-PROOF-6."""
    write(tmp_path, edited((README, "<!-- end of theorems -->", "")))
    assert found(tmp_path) == [("proof", README, 1, "")]
    assert call(tmp_path, "--write")[0] == 1


def test_output(tmp_path: Path) -> None:
    """Clauses: TOOL-PROOF-6, TOOL-OUTPUT-1."""
    said = call(write(tmp_path))[1].splitlines()
    assert said[0] == "no-lid-of-a-lid  (proofs_notes/lids.md:7)"
    assert said[2] == "  clauses   BOX-LID-2"
    assert said[-1].endswith("0 findings")
    answer = json.loads(call(tmp_path, "--json")[1])
    assert answer["findings"] == []
    assert answer["theorems"][0]["known_by"][0] == ["coq", "Coq `Clers.Lids.none`"]
    assert answer["theorems"][0]["assumes"] == "that lids are boxes"


def test_no_notes_at_all(tmp_path: Path) -> None:
    """A repository without proofs has nothing to say of them. Clause: TOOL-PROOF-6."""
    files = {path: text for path, text in FILES.items() if not path.startswith("proofs_notes")}
    files[BOXES] = files[BOXES].replace("See [why BOX-LID-2](../proofs_notes/lids.md).", "")
    assert found(write(tmp_path, files)) == []
    assert all_theorems(read(tmp_path)) == ()
