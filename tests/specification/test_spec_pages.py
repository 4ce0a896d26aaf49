"""Rules on pages, each seen to fail on a small repository with one fault in it."""

from pathlib import Path

import pytest
from toy_repository import FILES, edited, found, write

BOXES = "spec/01-boxes.md"
RULES = "spec/00-conventions.md"
README = "README.md"
INDEX = "spec/README.md"


@pytest.mark.parametrize(
    "target",
    [
        "02-none.md",
        "00-conventions.md#rules",
        "#boxes-1",
        "#Boxes",
        "../../outside.md",
        "/spec/00-conventions.md",
        "../reference/none/",
    ],
)
def test_link(target: str, tmp_path: Path) -> None:
    """Clause: CONV-PROSE-1."""
    files = edited((BOXES, "It takes", f"A [dead\nlink]({target})\nand ![one]({target}). It takes"))
    assert found(write(tmp_path, files)) == [("link", BOXES, 12, ""), ("link", BOXES, 14, "")]


@pytest.mark.parametrize(
    "target",
    [
        "#what-is-a-box",
        "../README.md",
        "../reference/clers/toys.py",
        "../reference/clers",
        "https://example.org/none#none",
        "mailto:toys@example.org",
        "#the-lid-χ-and-under-code--more",
        "#boxes-1",
        "#here",
    ],
)
def test_good_link(target: str, tmp_path: Path) -> None:
    """Anchors are GitHub's: no punctuation, marks or case, repeated ones numbered. CONV-PROSE-1."""
    more = '# The lid, χ, and **_under_** `code` & more!\n\n# Boxes\n\n<a id="here"></a>\n'
    files = edited((BOXES, "It takes", f"{more}\nA [link]({target}). It takes"))
    assert found(write(tmp_path, files)) == []


def test_links_are_relative(tmp_path: Path) -> None:
    """A path from the root leads elsewhere on GitHub. Clause: CONV-PROSE-1."""
    files = edited((README, "(spec/01-boxes.md", "(/spec/01-boxes.md"))
    assert found(write(tmp_path, files)) == [("link", README, 3, "")]


def test_link_in_code_is_none(tmp_path: Path) -> None:
    """Clause: CONV-PROSE-1."""
    files = edited((BOXES, "It takes", "`[a](none.md)`\n\n    [a](none.md)\n\nIt takes"))
    assert found(write(tmp_path, files)) == []


def test_page_outside_the_index(tmp_path: Path) -> None:
    """Clause: CONV-PROSE-4."""
    files = edited((INDEX, "[boxes](01-boxes.md#boxes)", "boxes"))
    assert found(write(tmp_path, files)) == [("index", BOXES, 1, "")]
    gone = {path: text for path, text in FILES.items() if path != INDEX}
    (tmp_path / INDEX).unlink()
    assert found(write(tmp_path, gone)) == [("index", RULES, 1, ""), ("index", BOXES, 1, "")]


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [
        (">>> lids + 1\n3", ">>> lids + 1\n4", 16),
        (">>> lids = 2\n", ">>> lids = two\n", 15),
        (">>> lids + 1\n3", ">>> lids + 1", 16),
        (">>> lids + 1\n3", ">>> lids +\n3", 16),
        (">>> lids + 1\n3", ">>>lids + 1\n3", 15),
    ],
)
def test_example(old: str, new: str, line: int, tmp_path: Path) -> None:
    """Clause: CONV-PROSE-2."""
    faults = found(write(tmp_path, edited((BOXES, old, new))))
    assert faults[0] == ("example", BOXES, line, "")
    assert {fault[0] for fault in faults} == {"example"}


def test_examples_of_a_page_are_run_together(tmp_path: Path) -> None:
    """Clause: CONV-PROSE-2."""
    more = "```python\n>>> lids\n2\n```\n"
    assert found(write(tmp_path, {**FILES, BOXES: FILES[BOXES] + more})) == []
    assert found(write(tmp_path, {**FILES, README: FILES[README] + more})) == [
        ("example", README, 5, "")
    ]


@pytest.mark.parametrize(
    "printed",
    [
        "1.7355<!--= golden.bits-per-triangle -->",
        "1.73561<!--= golden.bits-per-triangle -->",
        "1.73<!--= golden.bits-per-triangle -->",
        "−1.7356<!--= golden.bits-per-triangle -->",
        "2.01<!--= rossignac.bits-per-triangle -->",
        "21.7356<!--= golden.bits-per-triangle -->",
        "1.7356<!--= golden.bits-per-pixel -->",
        "many<!--= golden.bits-per-triangle -->",
        "v1.7356<!--= golden.bits-per-triangle -->",
    ],
)
def test_number(printed: str, tmp_path: Path) -> None:
    """Clause: CONV-PROSE-3. The value is 1.7356047841…."""
    files = edited((BOXES, "1.7356<!--= golden.bits-per-triangle -->", f"words\n{printed}"))
    assert found(write(tmp_path, files)) == [("number", BOXES, 13, "")]


@pytest.mark.parametrize(
    "printed",
    [
        "2<!--= golden.bits-per-triangle -->",
        "1.7<!--= golden.bits-per-triangle -->",
        "**1.73560**<!--= golden.bits-per-triangle -->",
        "$1.735604784$<!--= golden.bits-per-triangle -->",
        "2<!--= rossignac.bits-per-triangle -->",
        "2.00<!--= rossignac.bits-per-triangle -->",
        "4/2<!--= rossignac.bits-per-triangle -->",
        "`1.8<!--= golden.bits-per-triangle -->`",
        "1.8<!-- about -->",
    ],
)
def test_good_number(printed: str, tmp_path: Path) -> None:
    """Clause: CONV-PROSE-3."""
    files = edited((BOXES, "1.7356<!--= golden.bits-per-triangle -->", printed))
    assert found(write(tmp_path, files)) == []
