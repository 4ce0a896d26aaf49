"""Rules on cover and lock, each seen to fail on a small repository with one fault in it."""

from dataclasses import replace
from pathlib import Path

import pytest
from toy_repository import CLAUSES, FILES, edited, found, lock, write

import clers
from clers.cli.reading import registry_of
from clers.specification.citation import Citation, Kind
from clers.specification.finding import Finding
from clers.specification.python_sites import Module, Span
from clers.specification.registry import REGISTRY, registered
from clers.specification.repository import read

BOXES = "spec/01-boxes.md"
RULES = "spec/00-conventions.md"
TOYS = "reference/clers/toys.py"
LAWS = "reference/clers/boxes/laws.py"
TEST = "tests/test_toys.py"
NOTE = "proofs_notes/lids.md"
PROOFS = "proofs_notes/README.md"
README = "README.md"
LOCK = "spec/lock.json"


def test_sound(tmp_path: Path) -> None:
    """The repository that the other tests spoil breaks no rule. Clause: CONV-CLAUSE-2."""
    assert found(write(tmp_path)) == []


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
    text = "law no-such-law is not in reference/clers/laws.py"
    ours = replace(toys, registry=("one-lid",))
    assert list(registered(ours)) == [Finding("registry", LAWS, 4, "", text)]
    assert list(registered(replace(toys, registry=("no-such-law",)))) == []


def test_registry_that_is_unsound(tmp_path: Path) -> None:
    """Clause: CONV-LAW-3: a name twice, or a chapter that cannot be imported."""
    toys = read(write(tmp_path), ("one-lid", "one-lid"))
    twice = Finding("law-twice", REGISTRY, 1, "", "two laws are registered as one-lid")
    assert list(registered(toys)) == [twice]
    broken = Finding("registry", REGISTRY, 1, "", "cannot be imported: no chapter")
    assert list(registered(replace(toys, registry="no chapter"))) == [broken]
    here = registry_of(Path(clers.__file__).parents[2])
    assert len(here) > 300
    assert registry_of(tmp_path) == ()


def test_kinds(tmp_path: Path) -> None:
    """Where an id stands says what cites. Clause: CONV-CLAUSE-2."""
    sites = read(write(tmp_path)).sites
    assert sites("BOX-LID-2") == (
        Citation("BOX-LID-2", Kind.CODE, TOYS, 13, "lid"),
        Citation("BOX-LID-2", Kind.TEST, TEST, 9, "test_lid"),
        Citation("BOX-LID-2", Kind.NOTE, PROOFS, 9),
        Citation("BOX-LID-2", Kind.NOTE, NOTE, 3),
        Citation("BOX-LID-2", Kind.NOTE, NOTE, 8),
        Citation("BOX-LID-2", Kind.PROSE, BOXES, 20),
    )
    assert sites("TOY-RULE-1") == (
        Citation("TOY-RULE-1", Kind.CODE, TOYS, 8, "Toy.count"),
        Citation("TOY-RULE-1", Kind.TEST, TEST, 5, "test_count"),
        Citation("TOY-RULE-1", Kind.PROSE, BOXES, 5),
    )
