"""Each rule of `clers spec check`, seen to fail on a small repository with one fault in it."""

from dataclasses import replace
from pathlib import Path

import pytest
from toy_repository import CLAUSES, FILES, edited, found, lock, renamed, write

import clers
from clers.specification.citation import Citation, Kind
from clers.specification.finding import Finding
from clers.specification.python_sites import Module, Span
from clers.specification.registry import registered
from clers.specification.repository import read

BOXES = "spec/01-boxes.md"
RULES = "spec/00-conventions.md"
TOYS = "reference/clers/toys.py"
LAWS = "reference/clers/boxes/laws.py"
TEST = "tests/test_toys.py"
NOTE = "proofs_notes/lids.md"
README = "README.md"
CLAUSE_PY = "reference/clers/conventions/clause.py"
LOCK = "spec/lock.json"
INDEX = "spec/README.md"


def test_sound(tmp_path: Path) -> None:
    """The repository that the other tests spoil breaks no rule. Clause: CONV-CLAUSE-2."""
    assert found(write(tmp_path)) == []


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
        path: text.replace("BOX-LID-1 … BOX-LID-3", "BOX-LID-1, BOX-LID-3").replace(" to ", ", ")
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


def test_no_code(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-2. Laws, tests and notes are not code."""
    files = edited((TOYS, "BOX-LID-1 … BOX-LID-2", "none"))
    assert found(write(tmp_path, files)) == [("no-code", BOXES, 10, "BOX-LID-2")]


def test_a_string_is_neither_code_nor_test(tmp_path: Path) -> None:
    """Expected output is no evidence; a comment or a constant's docstring is. CONV-CLAUSE-2."""
    both = ((TOYS, "BOX-LID-1 … BOX-LID-2", "none"), (TEST, "Clause.BOX_LID_2", "'BOX-LID-2'"))
    files = edited(*both)
    strings = {**files, TOYS: files[TOYS] + '\n\nLID = "BOX-LID-2"\n'}
    faults = [("no-code", BOXES, 10, "BOX-LID-2"), ("no-law", BOXES, 10, "BOX-LID-2")]
    assert found(write(tmp_path, strings)) == faults
    words = {
        **strings,
        TOYS: strings[TOYS] + '"""By BOX-LID-2."""\n',
        TEST: files[TEST] + "    # BOX-LID-2\n",
    }
    assert found(write(tmp_path, words)) == []


def test_a_laws_words_are_not_code(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-2."""
    files = edited((TOYS, "BOX-LID-1 … BOX-LID-2", "none"), (LAWS, "boxes.", "boxes. BOX-LID-2"))
    assert found(write(tmp_path, files)) == [("no-code", BOXES, 10, "BOX-LID-2")]


@pytest.mark.parametrize(
    ("path", "old", "clause"),
    [(TEST, "Clause.BOX_LID_2", "BOX-LID-2"), (LAWS, "Clause.BOX_LID_1", "BOX-LID-1")],
)
def test_no_law(path: str, old: str, clause: str, tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-2."""
    faults = found(write(tmp_path, edited((path, old, "None"))))
    assert [(rule, name) for rule, _, _, name in faults] == [("no-law", clause)]


@pytest.mark.parametrize("end", ["untestable:", "untestable: .", "*untestable:*"])
def test_no_reason(end: str, tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-2."""
    text = {**CLAUSES, "TOY-RULE-2": f"Toys are kept. {end}"}
    files = edited((RULES, "untestable: nobody looks.", end))
    assert found(write(tmp_path, {**files, LOCK: lock(text)})) == [
        ("no-reason", RULES, 10, "TOY-RULE-2")
    ]


def test_the_word_in_code_marks_is_no_reason(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-2."""
    text = {**CLAUSES, "TOY-RULE-2": "Toys are kept. `untestable:` nobody looks."}
    files = edited((RULES, "untestable:", "`untestable:`"))
    assert found(write(tmp_path, {**files, LOCK: lock(text)})) == [
        ("no-law", RULES, 10, "TOY-RULE-2")
    ]


def test_changed_text(tmp_path: Path) -> None:
    """The places to read again are named. Clause: CONV-CLAUSE-4."""
    files = edited((BOXES, "> it lies on top.", "> it lies below."))
    repository = read(write(tmp_path, files))
    assert found(tmp_path) == [("changed", BOXES, 7, "BOX-LID-1")]
    assert [site.place for site in repository.sites("BOX-LID-1")] == [
        f"{TOYS}:9 (Toy.count)",
        f"{TOYS}:13 (lid)",
        f"{LAWS}:6 (one-lid)",
        f"{NOTE}:3",
        f"{README}:3",
    ]


def test_new_line_breaks_are_no_change(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-4."""
    assert found(write(tmp_path, edited((BOXES, "one lid;\n> it", "one\n> lid; it")))) == []


def test_hash(tmp_path: Path) -> None:
    """As `printf 'Toys are counted from 0.' | sha256sum` prints it. Clause: CONV-CLAUSE-4."""
    clause = read(write(tmp_path)).clauses[0]
    assert clause.hash == "26c3b6cf63fa274faa7f11aab85109dbc4a0297dc45d16c8da2a4c682c8b1731"


def test_lock_lacks_a_clause(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-4."""
    part = {name: text for name, text in CLAUSES.items() if name != "BOX-LID-2"}
    files = {**FILES, LOCK: lock(part)}
    assert found(write(tmp_path, files)) == [("not-locked", BOXES, 10, "BOX-LID-2")]


def test_lock_of_nothing(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-4."""
    files = {**FILES, LOCK: lock({**CLAUSES, "BOX-LID-3": "gone"})}
    assert found(write(tmp_path, files)) == [("lock-of-nothing", LOCK, 1, "BOX-LID-3")]


def test_generated(tmp_path: Path) -> None:
    """Clause: CONV-CLAUSE-9."""
    files = edited((CLAUSE_PY, '    TOY_RULE_2 = "TOY-RULE-2"\n', ""))
    assert found(write(tmp_path, files)) == [("generated", CLAUSE_PY, 1, "")]


def test_source_that_does_not_parse(tmp_path: Path) -> None:
    """Its citations would go unseen. Clause: CONV-CLAUSE-2."""
    files = {**FILES, "reference/clers/broken.py": '"""BOX-LID-9"""\n\ndef (:\n'}
    assert found(write(tmp_path, files)) == [("syntax", "reference/clers/broken.py", 3, "")]


def test_law_twice(tmp_path: Path) -> None:
    """Clause: CONV-LAW-3."""
    again = "reference/clers/lids/laws.py"
    files = {**FILES, again: FILES[LAWS]}
    assert found(write(tmp_path, files)) == [("law-twice", again, 4, "")]


def test_law_name(tmp_path: Path) -> None:
    """Clause: CONV-LAW-3."""
    files = edited((LAWS, "one-lid", "One lid"))
    assert found(write(tmp_path, files)) == [("law-name", LAWS, 4, "")]


def test_law_outside_the_registry(tmp_path: Path) -> None:
    """Clause: CONV-LAW-3. Only the running program's own repository has a registry to ask."""
    forgotten = Module(LAWS, laws=(Span(4, 8, "no-such-law"),))
    toys = replace(read(write(tmp_path)), modules=(forgotten,))
    assert list(registered(toys)) == []
    ours = replace(toys, root=Path(clers.__file__).parents[2])
    text = "law no-such-law is not in reference/clers/laws.py"
    assert list(registered(ours)) == [Finding("registry", LAWS, 4, "", text)]


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


def test_kinds(tmp_path: Path) -> None:
    """Where an id stands says what cites. Clause: CONV-CLAUSE-2."""
    sites = read(write(tmp_path)).sites
    assert sites("BOX-LID-2") == (
        Citation("BOX-LID-2", Kind.CODE, TOYS, 13, "lid"),
        Citation("BOX-LID-2", Kind.TEST, TEST, 9, "test_lid"),
        Citation("BOX-LID-2", Kind.NOTE, NOTE, 3),
    )
    assert sites("TOY-RULE-1") == (
        Citation("TOY-RULE-1", Kind.CODE, TOYS, 8, "Toy.count"),
        Citation("TOY-RULE-1", Kind.TEST, TEST, 5, "test_count"),
        Citation("TOY-RULE-1", Kind.PROSE, BOXES, 5),
    )
