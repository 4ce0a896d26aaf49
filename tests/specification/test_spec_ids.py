"""Rules on ids, each seen to fail on a small repository with one fault in it."""

from pathlib import Path

import pytest
from toy_repository import FILES, edited, found, renamed, write

BOXES = "spec/01-boxes.md"
RULES = "spec/00-conventions.md"
TOYS = "reference/clers/toys.py"
LAWS = "reference/clers/boxes/laws.py"
TEST = "tests/test_toys.py"
NOTE = "proofs_notes/lids.md"
README = "README.md"
CLAUSE_PY = "reference/clers/conventions/clause.py"
INDEX = "spec/README.md"


def test_id_twice(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-1."""
    files = edited((BOXES, "It takes", "> **BOX-LID-2.** A lid has no box.\n\nIt takes"))
    assert found(write(tmp_path, files)) == [("id-twice", BOXES, 12, "BOX-LID-2")]


@pytest.mark.parametrize(
    ("wrong", "line"),
    [
        ("> **BOX-LID-3** has no full stop.", 12),
        ("> **BOX-Lid-3.** is not in capitals.", 12),
        ("> **BOX-LID-03.** begins with a zero.", 12),
        ("> words first.\n> **BOX-LID-3.** then an id.", 13),
        ("> **BOX-3.** has no topic.", 12),
    ],
)
def test_misshapen(wrong: str, line: int, tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-1."""
    files = edited((BOXES, "It takes", f"{wrong}\n\nIt takes"))
    assert [f for f in found(write(tmp_path, files)) if f[0] == "misshapen"] == [
        ("misshapen", BOXES, line, "")
    ]


def test_two_clauses_in_one_quote(tmp_path: Path) -> None:
    """The second would vanish in the first's text. Clause: CONV-CLAUSE-1."""
    files = edited((BOXES, "on top.\n\n> **BOX", "on top.\n> **BOX"))
    assert ("misshapen", BOXES, 9, "") in found(write(tmp_path, files))


def test_quote_in_a_fence_is_no_clause(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-1."""
    files = edited((BOXES, "It takes", "```\n> **FOX-LID-1.** no.\n```\n\nIt takes"))
    assert [f[0] for f in found(write(tmp_path, files))] == ["dangling"]


def test_gap(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-7. The ranges now cite the missing clause, too: CONV-CLAUSE-8."""
    files = renamed("BOX-LID-2", "BOX-LID-3")
    assert found(write(tmp_path, files)) == [
        ("gap", BOXES, 10, "BOX-LID-2"),
        ("dangling", TOYS, 13, "BOX-LID-2"),
        ("dangling", NOTE, 3, "BOX-LID-2"),
    ]


def test_retired_fills_a_gap(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-7."""
    files = {
        path: text.replace("BOX-LID-1 … BOX-LID-3", "BOX-LID-1, BOX-LID-3").replace(
            "-1 to ", "-1, "
        )
        for path, text in renamed("BOX-LID-2", "BOX-LID-3").items()
    }
    retired = "# Retired\n\n- **BOX-LID-2.** Said what BOX-LID-3 says.\n"
    index = FILES[INDEX] + "And [these](retired.md).\n"
    assert found(write(tmp_path, {**files, "spec/retired.md": retired, INDEX: index})) == []


def test_retired_is_not_stated(tmp_path: Path) -> None:
    """Clauses: CONV-CLAUSE-1, CONV-CLAUSE-7."""
    retired = "# Retired\n\n- **BOX-LID-2.** Wrong.\n"
    index = FILES[INDEX] + "And [these](retired.md).\n"
    assert found(write(tmp_path, {**FILES, "spec/retired.md": retired, INDEX: index})) == [
        ("id-retired", BOXES, 10, "BOX-LID-2")
    ]


@pytest.mark.parametrize(("number", "clause"), [("9", "BOX-LID-1"), ("1", "TOY-RULE-1")])
def test_chapter_of_a_prefix(number: str, clause: str, tmp_path: Path) -> None:
    """A clause in another chapter, and a prefix that the table lacks. Clause: CONV-CLAUSE-6."""
    row = {"9": ("| 1 | `BOX`", "| 9 | `BOX`"), "1": ("| 0 | `TOY`", "| 0 | TOY")}[number]
    faults = found(write(tmp_path, edited((RULES, *row))))
    assert {fault[0] for fault in faults} == {"prefix"}
    assert clause in {fault[3] for fault in faults}


@pytest.mark.parametrize(
    ("path", "old", "new", "line", "clause"),
    [
        (TOYS, '"""Toys. ', '"""Toys. BOX-LID-7. ', 1, "BOX-LID-7"),
        (TOYS, "by TOY-RULE-1", "by TOY-RULE-1 and BOX-LID-8", 8, "BOX-LID-8"),
        (TOYS, "Clause.BOX_LID_1", "Clause.BOX_LID_1, Clause.BOX_LIP_1", 9, "BOX-LIP-1"),
        (TOYS, '"""A toy."""', '"""A toy.\n\n    FOX-LID-1\n    """', 7, "FOX-LID-1"),
        (LAWS, "one lid.", "one lid by BOX-LID-7.", 7, "BOX-LID-7"),
        (TEST, "assert", "assert 'BOX-LID-7',", 9, "BOX-LID-7"),
        (BOXES, "obey TOY-RULE-1", "obey\nTOY-RULE-4", 6, "TOY-RULE-4"),
        (NOTE, "no.", "no; see FOX-LID-1.", 3, "FOX-LID-1"),
        (README, "and BOX-LID-1", "and BOX-LID-3", 3, "BOX-LID-3"),
    ],
)
def test_citation_of_nothing(
    path: str, old: str, new: str, line: int, clause: str, tmp_path: Path
) -> None:
    """In every kind of place. Clause: CONV-CLAUSE-8."""
    files = edited((path, old, new))
    assert found(write(tmp_path, files)) == [("dangling", path, line, clause)]


def test_foreign_prefix_is_free_in_tests(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-8."""
    assert found(write(tmp_path, edited((TEST, "assert", "assert 'FOX-LID-1',")))) == []


def test_generated(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-9."""
    files = edited((CLAUSE_PY, '    TOY_RULE_2 = "TOY-RULE-2"\n', ""))
    assert found(write(tmp_path, files)) == [("generated", CLAUSE_PY, 1, "")]
