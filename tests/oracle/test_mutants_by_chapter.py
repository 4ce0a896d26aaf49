"""Mutants of a chapter: beside its tests, then beside cases; kept, and shown."""

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import msgspec
import pytest
from test_mutants_of_the_reference import CASES, ENCODE, written

from clers.cli.mutation_by_chapter import kept, put
from clers.measure.mutation.mutant import Mutant, difference
from clers.oracle.mutants.by_chapter import CHAPTERS, Chapter, Result, Row, asked, of
from clers.oracle.mutants.chapters_page import page
from clers.oracle.mutants.reached import PACKAGES, Reached
from clers.oracle.mutants.unnoticed import READ, Kind, Why, why

TOY = "def small(number):\n    return number < 3\n\n\ndef other(number):\n    return -number\n"
TESTS = "from toy.sums import small\n\ndef test():\n    assert small(2) and not small(4)\n"
ALONE = """
import sys
import msgspec
from clers.oracle.mutants import by_chapter
from clers.oracle.mutants.by_chapter import Chapter, Row, tried
from clers.oracle.mutants.unnoticed import Kind, Why
same = Why(Kind.EQUIVALENT, "nobody asks")
by_chapter.why = lambda _, change: same if change.endswith("+     return number") else None
chapter = Chapter("Toy", "toy", ("tests",))
before = msgspec.json.decode(sys.stdin.buffer.read(), type=tuple[Row, ...])
found = tried(chapter, 9, 1, before, lambda _: None)
sys.stdout.buffer.write(msgspec.json.encode(found))
"""
CHAPTER = Chapter("Toy", "toy", ("tests",))


@pytest.fixture
def toy(tmp_path: Path) -> Path:
    for name in ("toy", "tests"):
        (tmp_path / name).mkdir()
    (tmp_path / "toy" / "__init__.py").write_text("")
    (tmp_path / "toy" / "sums.py").write_text(TOY)
    (tmp_path / "tests" / "test_sums.py").write_text(TESTS)
    return tmp_path


def result(toy: Path, before: tuple[Row, ...] = ()) -> Result:
    """What the tests of the toy notice."""
    done = subprocess.run(
        [sys.executable, "-c", ALONE],
        input=msgspec.json.encode(before),
        cwd=toy,
        env={**os.environ, "PYTHONPATH": str(toy), "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"},
        capture_output=True,
        check=True,
    )
    return msgspec.json.decode(done.stdout, type=Result)


def test_what_tests_notice_is_not_tried_again(toy: Path) -> None:
    """Clause: ORCL-MUTANT-9."""
    first = result(toy)
    assert (first.mutants, first.drawn, len(first.rows)) == (5, 5, 5)
    by = {row.difference.split("\n")[1]: row.by for row in first.rows}
    test = "tests/test_sums.py::test"
    assert by == {
        "+     return number <= 3": "",
        "+     return number >= 3": test,
        "+     return number < 4": "",
        "+     return number < 2": test,
        "+     return number": "",
    }
    assert (first.by_tests, first.by_cases, len(first.left)) == (2, 0, 3)
    # Now there is a test of the border alone: what was noticed stays so, if it is the same change.
    # What is known to be equivalent is not tried, though the test would notice it.
    (toy / "tests" / "test_sums.py").write_text(
        "from toy.sums import other, small\n\n"
        "def test_three():\n    assert not small(3)\n    assert other(1) == -1\n"
    )
    before = tuple(
        replace(row, mutant=replace(row.mutant, line=7)) if row.mutant.after == "2" else row
        for row in first.rows
    )
    retried = result(toy, before)
    late = {row.difference.split("\n")[1] for row in retried.late}
    assert late == {"+     return number <= 3", "+     return number < 4"}
    again = {row.difference.split("\n")[1]: row.by for row in retried.rows}
    assert again == {
        "+     return number <= 3": f"{test}_three",
        "+     return number >= 3": test,
        "+     return number < 4": f"{test}_three",
        "+     return number < 2": "",
        "+     return number": "",
    }


def test_the_cases_are_asked_what_tests_let_pass(tmp_path: Path) -> None:
    """Clause: ORCL-MUTANT-9."""
    chapter = CHAPTERS[-1]
    module = "clers.kernels.walk"
    source = next(subject.source for subject in of(chapter) if subject.module == module)
    assert not any("laws" in subject.module for subject in of(CHAPTERS[0]))

    def row(before: str, after: str, by: str = "") -> Row:
        line, text = next((i, t) for i, t in enumerate(source.split("\n"), 1) if before in t)
        at = text.index(before)
        mutant = Mutant(line, at, line, at + len(before), "constant", before, after, line, line)
        return Row(module, mutant, difference(source, mutant), by)

    told, noticed = row("word.append(R)", "word.append(L)"), row("word.append(L)", "pass", "a test")
    same, never = row("word.append(R)", "(word.append(R))"), row("word.append(E)", "pass")
    every = tuple(range(len(CASES)))
    at = {change.mutant.line: every for change in (told, noticed)}
    result = Result(chapter, 9, 4, (told, noticed, same, never))
    folder = written(tmp_path, CASES)
    found = asked(result, Reached({module: at}), folder, len(CASES), lambda _: None)
    assert [change.by for change in found.rows] == [ENCODE.id, "a test", "", ""]
    assert [change.case for change in found.rows] == [True, False, False, False]
    assert asked(result, Reached({}), folder, len(CASES), lambda _: None) == result


NOTICED = Row("m", Mutant(1, 0, 1, 1, "constant", "1", "2", 1, 1), "- 1\n+ 2", "tests/x.py::y")
BY_CASE = Row("m", Mutant(2, 0, 2, 1, "constant", "1", "2", 2, 2), "- 1\n+ 2", "case-a", case=True)
LATE = Row(
    "m", Mutant(5, 0, 5, 1, "constant", "1", "2", 5, 5), "- z\n+ w", "tests/x.py::z", late=True
)
LEFT = Row("m", Mutant(3, 0, 3, 1, "constant", "1", "2", 3, 3), "- x = 1\n+ x = 2", "")
SAME = Row(
    "m",
    Mutant(4, 0, 4, 1, "constant", "1", "2", 4, 4),
    "- y = 1\n+ y = 2",
    "",
    why=Why(Kind.EQUIVALENT, "y is never read"),
)


def test_what_the_page_says() -> None:
    """Clause: ORCL-MUTANT-9."""
    one = Result(CHAPTER, 70, 4, (NOTICED, BY_CASE, LEFT, SAME))
    two = Result(CHAPTER, 30, 2, (NOTICED, LATE))
    text = list(page([one, two], 4, 7, commit="abc1234"))
    assert "    python -m clers.cli.mutation_by_chapter --sample 4 --seed 7" in text
    assert "| Toy | 70 | 4 | 1 | 1 | 2 | 50.0 % | 50.0 % | 66.7 % |" in text
    assert "| Toy | 30 | 2 | 2 | 0 | 0 | 50.0 % | 100.0 % | 100.0 % |" in text
    assert "| all | 100 | 6 | 3 | 1 | 2 | 50.0 % | 66.7 % | 80.0 % |" in text
    assert any(line.endswith("as commit abc1234 left them.") for line in text)
    assert text.index("`m`: now by `tests/x.py::z`") < text.index("- z\n+ w")
    assert "`m`: **not read yet**" in text
    assert "`m`: **equivalent**; y is never read" in text
    assert "- y = 1\n+ y = 2" in text
    again = page([one], 4, 7, cases=False, kept=True)
    assert "by_chapter --sample 4 --seed 7 --no-cases --keep FOLDER" in "\n".join(again)
    alone = list(page([replace(two, rows=(NOTICED,))], 4, 7))
    assert not any("late" in line for line in alone)
    assert not any("commit" in line for line in alone)
    assert not any("all" in line.split(" ")[:2] or "nothing noticed" in line for line in alone)


def test_what_is_kept_is_read_again(tmp_path: Path) -> None:
    """Clause: ORCL-MUTANT-9."""
    found = Result(CHAPTER, 70, 5, (NOTICED, BY_CASE, LEFT, SAME, LATE))
    put(tmp_path / "new", found)
    assert kept(tmp_path / "new", CHAPTER) == found.rows
    assert kept(tmp_path, CHAPTER) == kept(None, CHAPTER) == ()
    (tmp_path / "new" / "toy.json").write_text("{")
    assert kept(tmp_path / "new", CHAPTER) == ()


def test_each_chapter_has_its_tests_and_what_is_read_is_a_change() -> None:
    """Clause: ORCL-MUTANT-9."""
    assert {chapter.package for chapter in CHAPTERS} == set(PACKAGES)
    here = Path(__file__).parent.parent.parent
    named = [tests.partition("::") for chapter in CHAPTERS for tests in chapter.tests]
    assert all((here / path).exists() for path, _, _ in named)
    for path, _, test in named:
        assert f"def {test.partition('[')[0]}(" in (here / path).read_text() if test else True
    for (module, change), known in READ.items():
        assert module.startswith(tuple(f"{name}." for name in PACKAGES))
        assert known.because
        lines = change.replace(" + ", "\n+     ", 1)
        assert lines != change
        assert why(module, lines) == known
    assert why("m", "- 1\n+ 2") is None
