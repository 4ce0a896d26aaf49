"""The Markdown report. Clauses: ORCL-HTML-1, ORCL-HTML-2, ORCL-HTML-5."""

from itertools import pairwise

import pytest
from markdown_it import MarkdownIt
from markdown_it.token import Token
from reported import HOSTILE, RULINGS, report

from clers.oracle.reports.markdown import code, markdown, plain

READER = MarkdownIt("commonmark").enable("table")


def _tokens(text: str) -> list[Token]:
    return [token for block in READER.parse(text) for token in (block, *(block.children or []))]


def _shown(text: str) -> str:
    """What a reader sees."""
    return "".join(t.content for t in _tokens(text) if t.type in ("text", "code_inline"))


PAGE = markdown(report())

TEXT = frozenset(
    ("paragraph_open", "inline", "text", "text_special", "code_inline", "paragraph_close")
)
"""What a line without markup consists of."""


def test_equal_runs_have_equal_reports() -> None:
    """Clause: ORCL-HTML-1."""
    assert markdown(report()) == PAGE
    assert PAGE.endswith("\n")
    assert not PAGE.endswith("\n\n")


def test_headings() -> None:
    """Clause: ORCL-HTML-2."""
    heads = [
        (token.tag, _shown(inline.content))
        for token, inline in zip(_tokens(PAGE), _tokens(PAGE)[1:], strict=False)
        if token.type == "heading_open"
    ]
    assert heads[:5] == [
        ("h1", f"{HOSTILE} against the suite abcdefgh"),
        ("h2", "Summary"),
        ("h2", "Skipped"),
        ("h2", "Failures"),
        ("h3", "word.decode fail face: 22"),
    ]
    assert sum(tag == "h4" for tag, _ in heads) == 22
    assert len(heads) == 4 + 3 + 22


def test_blocks_are_apart() -> None:
    """Clause: ORCL-HTML-2: readers differ in what may follow what without a blank line."""
    lines = PAGE.splitlines()
    for k, line in enumerate(lines):
        if line.startswith("#") and k:
            assert lines[k - 1] == lines[k + 1] == ""
    assert "" not in (lines[0], lines[-1])
    assert all(one or other for one, other in pairwise(lines))


@pytest.mark.parametrize(
    "line",
    [
        "24 of 26 cases failed, 1 of 26 skipped.",
        "| profile | cases | pass | fail | skip | crash |",
        "| core | 23 | 1 | 22 | 0 | 0 |",
        "| components is not declared | 1 |",
        "`word.decode`, profile core, **fail**",
        "- first divergence: `face 2, made by symbol 1 (R)`",
        "- expected: `(0, 3, 1)`",
        "- got: `(0, 1, 3)`",
        "- clause **EB-WORD-1**",
        "- flag **mirrored**: right for left \\<b\\>; it matters",
        "- flag **deaf**",
        "- more: `clers explain turned-0-aaaaaaaa -a "
        "''\"'\"'./fast mesh'\"'\"' '\"'\"'<x>'\"'\"''`",
        "- clause **EB-ORDER-1**: Vertices $v$ are numbered `so`, by <i>order</i>, "
        "see [there](05-edgebreaker.md).",
    ],
)
def test_lines(line: str) -> None:
    """Clause: ORCL-HTML-2."""
    assert line in PAGE.splitlines()


def test_others_stand_in_a_table() -> None:
    """Clause: ORCL-HTML-2."""
    row = next(text for text in PAGE.splitlines() if text.startswith("| `turned-20-aaaaaaaa`"))
    assert row.startswith("| `turned-20-aaaaaaaa` | core | `face 2, made by symbol 1 (R): expected")
    assert "turned-19-aaaaaaaa` |" not in PAGE


def test_a_crash_says_why() -> None:
    """Clause: ORCL-HTML-2."""
    (line,) = [text for text in PAGE.splitlines() if text.startswith("- why: ")]
    assert "crash: exit code -11" in line


def test_nothing_is_said_of_what_is_not_there() -> None:
    """Clause: ORCL-HTML-2."""
    page = markdown(report(RULINGS[:1]))
    assert "## Failures" not in page
    assert "## Skipped" not in page


def test_what_others_say_is_no_markup() -> None:
    """Clause: ORCL-HTML-5."""
    assert not any(t.type in ("html_inline", "html_block") and "script" in t.content
                   for t in _tokens(PAGE))  # fmt: skip
    for wild in (HOSTILE, "a``b", "`", "``x`", "#x", "~~a~~", "&amp;", "a\\b", "x\ny"):
        flat = " ".join(wild.split())
        for text in (plain(wild), code(wild)):
            tokens = _tokens(text)
            assert _shown(text) == flat
            assert {token.type for token in tokens} <= TEXT
    assert code("") == ""


def test_bars_do_not_end_a_cell() -> None:
    """Clause: ORCL-HTML-5."""
    rows = [text for text in PAGE.splitlines() if text.startswith("| adapter |")]
    assert len(rows) == 1
    cells = [
        t for t in READER.parse("\n".join(("| | |", "|---|---|", rows[0]))) if t.type == "td_open"
    ]
    assert len(cells) == 2
    assert "a|b" in _shown("| | |\n|---|---|\n" + rows[0])
