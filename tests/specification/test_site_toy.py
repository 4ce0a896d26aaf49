"""The site of a small repository: what is linked to what, word for word."""

import re
from pathlib import Path
from typing import Final

import pytest
from toy_repository import FILES, edited, write

from clers.site.build import Material, site
from clers.site.dossier import Vectors
from clers.site.sound import Site
from clers.specification.repository import read

VECTORS: Final = {"BOX-LID-1": (Vectors("core", "echo", ("lid-aaaaaaaa", "box-aaaaaaaa")),)}
TAG: Final = re.compile(r"<[^>]*>")


def made(root: Path) -> Site:
    found, faults = site(Material(read(root), (), VECTORS), lambda _: None)
    assert faults == ()
    return found


@pytest.fixture(scope="module")
def toys(tmp_path_factory: pytest.TempPathFactory) -> Site:
    return made(write(tmp_path_factory.mktemp("toys")))


def html(of: Site, path: str) -> str:
    return of.files[path].decode()


def main_of(of: Site, path: str) -> str:
    """The main part of a page."""
    return html(of, path).partition("<main")[2].partition("</main>")[0]


def said(text: str) -> str:
    """The words of some HTML."""
    return " ".join(TAG.sub(" ", text).split())


def test_its_pages(toys: Site) -> None:
    """Clauses: TOOL-SITE-1, TOOL-SITE-4, TOOL-SITE-5."""
    assert sorted(toys.files) == [
        "00-conventions.html",
        "01-boxes.html",
        "README.html",
        "clause/BOX-LID-1.html",
        "clause/BOX-LID-2.html",
        "clause/TOY-RULE-1.html",
        "clause/TOY-RULE-2.html",
        "clauses.html",
        "index.html",
        "laws.html",
        "proofs_notes/README.html",
        "proofs_notes/lids.html",
        "search-index.js",
        "search.js",
        "source/proofs_notes/coq/Lids.v.html",
        "source/reference/clers/boxes/laws.py.html",
        "source/reference/clers/toys.py.html",
        "source/tests/test_toys.py.html",
        "style.css",
    ]


def test_a_clause_is_set_off(toys: Site) -> None:
    """Clauses: TOOL-SITE-2, TOOL-SITE-4."""
    page = main_of(toys, "01-boxes.html")
    block = page.partition('<div class="clause" id="BOX-LID-1">')[2].partition("</div>")[0]
    assert said(block) == (
        "BOX-LID-1 A box has one lid; it lies on top. "
        "code 2 · laws 1 · tests 0 · vectors 2 · proofs 1 · errata 0"
    )
    assert re.findall(r'href="([^"]*)"', block) == [
        "#BOX-LID-1",
        "clause/BOX-LID-1.html#code",
        "clause/BOX-LID-1.html#laws",
        "clause/BOX-LID-1.html#vectors",
        "clause/BOX-LID-1.html#proofs",
    ]


def test_a_mention_is_a_link(toys: Site) -> None:
    """Clause: TOOL-SITE-3."""
    link = '<a class="id" href="{}#{}">{}</a>'
    assert link.format("00-conventions.html", "TOY-RULE-1", "TOY-RULE-1") in main_of(
        toys, "01-boxes.html"
    )
    note = main_of(toys, "proofs_notes/lids.html")
    assert link.format("../01-boxes.html", "BOX-LID-2", "BOX-LID-2") in note
    code = main_of(toys, "source/reference/clers/toys.py.html")
    there = "../../../01-boxes.html"
    assert f"Clause.{link.format(there, 'BOX-LID-1', 'BOX_LID_1')}" in code


def test_what_cites_a_clause(toys: Site) -> None:
    """Clause: TOOL-SITE-4."""
    page = main_of(toys, "clause/BOX-LID-1.html")
    words = said(page)
    assert "reference/clers/toys.py:9 Toy.count" in words
    assert "reference/clers/toys.py:13 lid" in words
    assert "one-lid reference/clers/boxes/laws.py:4" in words
    assert "clers vectors list --clause BOX-LID-1" in words
    assert "core, echo : 2 lid-aaaaaaaa box-aaaaaaaa" in words
    assert "Lids proofs_notes/lids.md" in words
    assert 'href="../source/reference/clers/toys.py.html#L9"' in page
    assert 'href="../01-boxes.html#BOX-LID-1"' in page
    assert 'href="../laws.html#one-lid"' in page


def test_links_between_pages(toys: Site) -> None:
    """Clause: TOOL-SITE-1."""
    assert 'href="00-conventions.html#conventions"' in main_of(toys, "01-boxes.html")
    assert 'href="01-boxes.html#what-is-a-box"' in main_of(toys, "README.html")


def test_the_lists_beside_a_page(toys: Site) -> None:
    """Clause: TOOL-SITE-10."""
    page = html(toys, "01-boxes.html")
    nav = page.partition('<nav id="site-chapters"')[2].partition("</nav>")[0]
    assert re.findall(r'href="([^#"]+)"', nav) == [
        *("index.html", "00-conventions.html", "01-boxes.html"),
        *("clauses.html", "laws.html"),
        *("proofs_notes/README.html", "proofs_notes/lids.html", "README.html"),
    ]
    assert 'href="01-boxes.html" aria-current="page"' in nav
    around = page.partition('<nav class="neighbours"')[2].partition("</nav>")[0]
    assert re.findall(r'rel="(\w+)" href="([^"]*)"', around) == [
        ("prev", "00-conventions.html"),
        ("next", "clauses.html"),
    ]
    sections = page.partition('<nav id="site-sections"')[2].partition("</nav>")[0]
    assert re.findall(r'href="([^"]*)"', sections) == ["#site-content", "#what-is-a-box"]


def test_comments_are_not_shown(toys: Site) -> None:
    assert "golden.bits" not in html(toys, "01-boxes.html")
    assert "1.7356 bits" in main_of(toys, "01-boxes.html")


BROKEN: Final = (
    ("spec/01-boxes.md", "boxes obey", "[boxes](gone.md) obey", "01-boxes.html", "no such file"),
    ("spec/01-boxes.md", "#conventions)", "#gone)", "01-boxes.html", "no such anchor"),
    ("spec/01-boxes.md", "boxes obey", "$\\gone$ obey", "spec/01-boxes.md", "cannot be set"),
    ("spec/01-boxes.md", "boxes obey", "<b>boxes obey", "01-boxes.html", "not well-formed"),
    ("spec/01-boxes.md", "boxes obey", "![](x.svg) obey", "01-boxes.html", "no words"),
    ("spec/01-boxes.md", "boxes obey", '<a id="BOX-LID-1"></a> obey', "01-boxes.html", "2 times"),
    ("README.md", "# Toys", '# Toys\n\n<a id="BOX-LID-1"></a>', "01-boxes.html", "README.html"),
    ("README.md", "# Toys", "# Toys\n\n# Toys", "README.html", "2 <h1>"),
)


@pytest.mark.parametrize(("path", "old", "new", "page", "words"), BROKEN)
def test_what_breaks_is_found(
    tmp_path: Path, path: str, old: str, new: str, page: str, words: str
) -> None:
    """Clauses: TOOL-SITE-8, TOOL-SITE-9."""
    root = write(tmp_path, edited((path, old, new)))
    _, faults = site(Material(read(root), (), {}), lambda _: None)
    assert [(found.path, words in found.text) for found in faults][:1] == [(page, True)], faults


def test_pictures_are_copied(tmp_path: Path) -> None:
    """Clause: TOOL-SITE-6."""
    files = edited(("spec/01-boxes.md", "boxes obey", "![A lid](pictures/lid.svg) obey"))
    root = write(tmp_path, {**files, "spec/pictures/lid.svg": "<svg/>"})
    found = made(root)
    assert found.files["picture/lid.svg"] == b"<svg/>"
    assert '<img src="picture/lid.svg" alt="A lid" />' in html(found, "01-boxes.html")


def test_files_and_theorems_in_code_type(tmp_path: Path) -> None:
    """Clause: TOOL-SITE-5."""
    files = edited(
        ("spec/01-boxes.md", "boxes obey", "`Clers.Lids.flat` of `reference/clers/toys.py` obey")
    )
    root = write(tmp_path, {**files, "proofs_notes/coq/Lids.v": "(* BOX-LID-1 *)\nLemma flat : 1."})
    page = main_of(made(root), "01-boxes.html")
    assert 'href="source/proofs_notes/coq/Lids.v.html#L2"><code>Clers.Lids.flat</code>' in page
    assert 'href="source/reference/clers/toys.py.html"><code>reference/clers/toys.py' in page


def test_formulas_and_tables(tmp_path: Path) -> None:
    """Clause: TOOL-SITE-6."""
    table = "boxes obey $n \\le 2$\n\n| $a$ | b |\n|---|---|\n| 1 | 2 |\n\nand"
    page = main_of(
        made(write(tmp_path, edited(("spec/01-boxes.md", "boxes obey", table)))), "01-boxes.html"
    )
    assert page.count("<math ") == 2
    assert '<div class="table" role="region" aria-label="Table" tabindex="0"><table>' in page
    assert "<th><math" in page


def test_the_files_are_the_toys() -> None:
    """What the expectations above were read off."""
    assert FILES["reference/clers/toys.py"].splitlines()[8].strip() == "return Clause.BOX_LID_1"
