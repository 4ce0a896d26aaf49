"""Reasons and the clauses that rejections name: the one is in the text of the other."""

from pathlib import Path

import pytest
from toy_repository import CLAUSES, FILES, found, lock, write

from clers.specification.citation import Kind
from clers.specification.python_sites import read_module

TOYS = "reference/clers/toys.py"


def files(*lines: str) -> dict[str, str]:
    """The toys, with a function more."""
    body = "".join(f"    {line}\n" for line in lines)
    return {**FILES, TOYS: FILES[TOYS] + f"\n\ndef refused() -> object:\n{body}"}


def test_a_reason_that_the_clause_does_not_name(tmp_path: Path) -> None:
    """Clause: CONV-RESULT-6."""
    line = "return Rejected(Reason.BAD_TABLE, Clause.BOX_LID_1, WHOLE)"
    at = 1 + files(line)[TOYS].splitlines().index(f"    {line}")
    assert found(write(tmp_path, files(line))) == [("reason", TOYS, at, "BOX-LID-1")]


def test_a_reason_that_it_names(tmp_path: Path) -> None:
    """Clause: CONV-RESULT-6."""
    line = "return Rejected(Reason.BAD_TABLE, Clause.BOX_LID_1, WHOLE)"
    page, words = "spec/01-boxes.md", "A box has one lid;\n> it lies on top."
    text = "A box has one lid, else it is `bad-table`."
    changed = {**files(line), page: FILES[page].replace(words, text)}
    changed["spec/lock.json"] = lock({**CLAUSES, "BOX-LID-1": text})
    assert found(write(tmp_path, changed)) == []


@pytest.mark.parametrize(
    "line",
    [
        "return Rejected(reason, Clause.BOX_LID_1)",
        "return Rejected(Reason.BAD_TABLE, clause)",
        "return Refused(Reason.BAD_TABLE, Clause.BOX_LID_1)",
        "return Reason.BAD_TABLE, Clause.BOX_LID_1",
    ],
)
def test_what_does_not_write_both_out_is_not_seen(tmp_path: Path, line: str) -> None:
    """Clause: CONV-RESULT-6."""
    assert found(write(tmp_path, files(line))) == []


def test_only_code_is_read() -> None:
    """Clause: CONV-RESULT-6."""
    source = "Rejected(Reason.NOT_A_CURVE, Clause.BOX_LID_2, where, 'why')\n"
    (one,) = read_module("a.py", source, Kind.CODE).rejections
    assert (one.reason, one.clause, one.line) == ("not-a-curve", "BOX-LID-2", 1)
    assert read_module("a.py", source, Kind.TEST).rejections == ()
