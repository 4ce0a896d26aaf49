"""The page about the tutorial: no place is passed over, none is made up."""

from dataclasses import replace
from pathlib import Path

import pytest
from toy_repository import FILES, found, write

import clers
from clers.specification.clause_text import ClauseText
from clers.specification.markdown import page
from clers.specification.places import PLACES
from clers.specification.repository import read
from clers.specification.tutorial import every_place, rows

ROOT = Path(clers.__file__).parents[2]
PAGE = "spec/tutorial.md"
HEAD = "# Tutorial\n\n| place | what it says | here |\n|---|---|---|\n"
LAST = len(PLACES) + 4


def files(*changes: tuple[str, str], head: str = HEAD) -> dict[str, str]:
    """The toys with a page on the tutorial that has all places and both errata, then changed."""
    table = head + "".join(f"| {place} | – | BOX-LID-1 |\n" for place in PLACES)
    table = table.replace("| Notation | – | BOX-LID-1 |", "| Notation | – | ERRATUM-1, ERRATUM-2 |")
    for old, new in changes:
        assert table.count(old) == 1, old
        table = table.replace(old, new)
    links = "\n[Tutorial](tutorial.md), [errata](errata.md)\n"
    errata = "# Errata\n\n### ERRATUM-1. A lid\n\n### ERRATUM-2. A box\n"
    index = FILES["spec/README.md"] + links
    return {**FILES, PAGE: table, "spec/README.md": index, "spec/errata.md": errata}


def test_a_page_with_all_places(tmp_path: Path) -> None:
    """Clause: TOOL-PAGE-4."""
    reason = ("| Figure 7 | – | BOX-LID-1 |", "| Figure 7 | – | left out: too small |")
    assert found(write(tmp_path, files(reason))) == []


ROW = "| Figure 7 | – | BOX-LID-1 |"
AT = 5 + PLACES.index("Figure 7")


@pytest.mark.parametrize(
    ("new", "lines"),
    [
        ("| Figure 77 | – | BOX-LID-1 |", [AT, 1]),
        ("| Figure 6 | – | BOX-LID-1 |", [AT, 1]),
        ("| Figure 7 | BOX-LID-1 | here |", [AT]),
        ("| Figure 7 | – | left out |", [AT]),
        ("| Figure 7 | – | BOX-LID-1; lids are left out |", [AT]),
        ("| Figure 7 | – | ERRATUM-3 |", [AT]),
    ],
)
def test_a_page_with_a_fault(new: str, lines: list[int], tmp_path: Path) -> None:
    """Clause: TOOL-PAGE-4."""
    faults = found(write(tmp_path, files((ROW, new))))
    assert faults == [("tutorial", PAGE, line, "") for line in lines]


def test_an_erratum_without_a_place(tmp_path: Path) -> None:
    """Clause: TOOL-PAGE-4."""
    faults = found(write(tmp_path, files(("ERRATUM-1, ERRATUM-2", "ERRATUM-2"))))
    assert faults == [("tutorial", PAGE, 1, "")]


def test_a_page_that_is_not_there(tmp_path: Path) -> None:
    """Clause: TOOL-PAGE-4. Where the clause is stated the page must be there."""
    of = read(write(tmp_path))
    stated = ClauseText("TOOL-PAGE-4", "The page is there.", 10, "spec/10-pages.md", 1)
    assert list(every_place(of)) == []
    faults = list(every_place(replace(of, clauses=(stated,))))
    assert [(fault.rule, fault.path, fault.clause) for fault in faults] == [
        ("tutorial", PAGE, "TOOL-PAGE-4")
    ]


def test_the_page_itself() -> None:
    """Clause: TOOL-PAGE-4. Nothing is said to be left out in more than a fifth of the rows."""
    of = page(PAGE, (ROOT / PAGE).read_text())
    told = {place: where for _, place, where in rows(of)}
    assert set(told) == set(PLACES)
    assert len(PLACES) > 120
    alone = [place for place, where in told.items() if where.startswith("left out:")]
    assert len(alone) < len(PLACES) / 5
