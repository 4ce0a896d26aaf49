"""The site of this repository, made once and read back."""

import json
import re
from pathlib import Path
from typing import Final

import pytest
from typer.testing import CliRunner

from clers.cli.main import app
from clers.cli.output import Exit
from clers.conventions.clause import Clause
from clers.conventions.result import Accepted
from clers.laws import ALL
from clers.oracle.suite.files import DEFAULT, read_suite
from clers.site.entries import Kind, entries_of
from clers.specification.clause_text import ClauseText
from clers.specification.repository import read_specification

ROOT: Final = Path(__file__).parents[2]
TAG: Final = re.compile(r"<[^>]*>")
CODE: Final = re.compile(r"<(pre|code)\b.*?</\1>", re.DOTALL)


@pytest.fixture(scope="module")
def here(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("site") / "site"
    done = CliRunner().invoke(app, ["spec", "site", "--root", str(ROOT), "-o", str(out)])
    assert done.exit_code == Exit.CONFORMING, done.output
    return out


def stated() -> list[str]:
    """The ids of all clauses, in the order of the chapters."""
    found = read_specification(ROOT)
    return [item.clause for item in found if isinstance(item, ClauseText)]


def test_this_site(here: Path) -> None:
    """Clauses: TOOL-SITE-1, -2, -4, -6, -7; one test, because the site is made once a process."""
    pages = {path: path.read_text(encoding="utf-8") for path in sorted(here.glob("*.html"))}
    _every_clause(pages)
    _vectors(here)
    _laws(here)
    _formulas(pages)
    _search(here)


def _every_clause(pages: dict[Path, str]) -> None:
    set_off = [
        id_
        for text in pages.values()
        for id_ in re.findall(r'<div class="clause" id="([^"]*)">', text)
    ]
    assert sorted(set_off) == sorted(stated())


def _vectors(here: Path) -> None:
    """A clause with many vectors has them all on its page."""
    suite = read_suite(DEFAULT)
    assert isinstance(suite, Accepted)
    expected = [case.id for case in suite.value.cases if Clause.EB_DECODE_1 in case.clauses]
    page = (here / "clause" / "EB-DECODE-1.html").read_text(encoding="utf-8")
    lists = "".join(re.findall(r'<ul class="cases">(.*?)</ul>', page, re.DOTALL))
    assert re.findall(r"<li>(.*?)</li>", lists) == expected
    assert f'<h2 id="vectors">Vectors <b>{len(expected)}</b> ' in page


def _laws(here: Path) -> None:
    page = (here / "laws.html").read_text(encoding="utf-8")
    shown = re.findall(r'<div class="law" id="([^"]*)">', page)
    assert sorted(shown) == sorted(law.name for law in ALL)


def _formulas(pages: dict[Path, str]) -> None:
    """No dollar sign and no command of TeX is left where text is; and formulas there are."""
    assert sum(text.count("<math ") for text in pages.values()) > 1000
    for path, text in pages.items():
        words = TAG.sub("", CODE.sub("", text))
        assert re.findall(r"\$|\\[a-z]+", words) == [], path


def _search(here: Path) -> None:
    entries = entries_of((here / "search-index.js").read_bytes())
    titles = [entry.title for entry in entries if entry.kind is Kind.CLAUSE]
    assert titles == stated()
    assert {entry.title for entry in entries if entry.kind is Kind.LAW} == {law.name for law in ALL}
    assert json.loads((here / "site.json").read_bytes())["format"] == "clers site 1"
