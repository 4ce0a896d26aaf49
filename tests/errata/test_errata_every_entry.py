"""`spec/errata.md` and these tests agree: each entry is shown by tests, each test by an entry."""

import ast
import re
from functools import cache
from pathlib import Path
from typing import Final

import pytest

TESTS: Final = Path(__file__).parents[1]
PAGE: Final = (TESTS.parent / "spec" / "errata.md").read_text(encoding="utf-8")

_HEADING: Final = re.compile(r"^### ERRATUM-(\d+)\. ", re.MULTILINE)
_NAME: Final = re.compile(r"`(test_\w+)`")


@cache
def entries() -> dict[int, str]:
    """Each entry's text, by its number."""
    _, *parts = _HEADING.split(PAGE.partition("## Slips of the pen")[0])
    return {int(number): text for number, text in zip(parts[::2], parts[1::2], strict=True)}


@cache
def functions() -> dict[str, str]:
    """Each test function with its docstring."""
    return {
        node.name: ast.get_docstring(node) or ""
        for path in TESTS.rglob("test_*.py")
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.FunctionDef) and node.name.startswith("test_")
    }


def test_entries_are_numbered_from_1() -> None:
    assert list(entries()) == list(range(1, len(entries()) + 1))


@pytest.mark.parametrize("number", entries())
def test_entry_is_complete(number: int) -> None:
    """Four parts in their order, and each test named shows this entry."""
    text, known = entries()[number], functions()
    assert re.findall(r"^- \*\*(\w+)\.\*\*", text, re.MULTILINE) == [
        "Printed", "Fault", "Counterexample", "Here",
    ]  # fmt: skip
    named = _NAME.findall(text)
    assert named
    for name in named:
        assert re.search(rf"ERRATUM-{number}\b", known[name]), name


def test_tests_cite_entries_that_exist() -> None:
    cited = {int(n) for text in functions().values() for n in re.findall(r"ERRATUM-(\d+)", text)}
    assert cited == set(entries())


def test_right_as_printed_names_tests_that_exist() -> None:
    named = _NAME.findall(PAGE.partition("## Right as printed")[2])
    assert len(named) > 5
    assert set(named) <= functions().keys()
