"""The list of everything that clauses leave open, seen to be complete and to hold nothing else."""

from pathlib import Path

import pytest
from toy_repository import CLAUSES, FILES, found, lock, write

from clers.specification.leave import leave

BOXES = "spec/01-boxes.md"
INDEX = "spec/README.md"
FREEDOM = "spec/freedom.md"
LIST = """# Freedom

| clause | before the list, and no part of it |
|---|---|
| BOX-LID-2 | nothing |

## Every *may*

Of BOX-LID-2 nothing is said in the first column.

| clause | left |
|---|---|
| BOX-LID-1 | the side; see BOX-LID-2 |

## Other things

| clause | after it |
|---|---|
| BOX-LID-2 | nothing |
"""


def files(text: str, freedom: str | None = LIST) -> dict[str, str]:
    """The toys, with another text for BOX-LID-1, which is locked, and a list of freedoms."""
    old = "A box has one lid;\n> it lies on top."
    assert FILES[BOXES].count(old) == 1
    changed = {**FILES, BOXES: FILES[BOXES].replace(old, text)}
    changed["spec/lock.json"] = lock({**CLAUSES, "BOX-LID-1": " ".join(text.split())})
    if freedom is not None:
        changed[FREEDOM] = freedom
        changed[INDEX] = FILES[INDEX] + "\n[Freedom](freedom.md)\n"
    return changed


def test_a_may_that_is_listed(tmp_path: Path) -> None:
    """Clause: TOOL-PAGE-3."""
    assert found(write(tmp_path, files("The lid may lie below."))) == []


@pytest.mark.parametrize(
    "text",
    [
        "The lid may lie below.",
        "May a lid lie below?",
        "A lid lies anywhere.",
        "Its colour is *free*.",
        "Lids lie in any order.",
        "The name of a lid is advice.",
        "Lids are chosen at random.",
        "A lid need not fit.",
    ],
)
@pytest.mark.parametrize("freedom", [None, LIST.replace("| BOX-LID-1 |", "| BOX-LID-9 |")])
def test_a_may_that_is_not_listed(text: str, freedom: str | None, tmp_path: Path) -> None:
    """Clause: TOOL-PAGE-3."""
    faults = found(write(tmp_path, files(text, freedom)))
    assert ("leave", BOXES, 7, "BOX-LID-1") in faults
    assert {rule for rule, *_ in faults} <= {"leave", "dangling"}


def test_a_clause_that_leaves_nothing_is_not_listed(tmp_path: Path) -> None:
    """Clause: TOOL-PAGE-3."""
    faults = found(write(tmp_path, files("A box has one lid.")))
    assert faults == [("leave", FREEDOM, 13, "BOX-LID-1")]


def test_what_gives_leave() -> None:
    """Clause: TOOL-PAGE-3. Words within words, in code and in formulas give none."""
    assert leave("It may, or might not; the\nrest is free.") == ("may", "might", "free")
    assert leave("In whatever\norder; Optionally.") == ("whatever order", "optionally")
    assert leave("A mayor of `not-free` and $may$ is freed from any ordering.") == ()
