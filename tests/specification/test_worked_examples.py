"""Worked examples: every checked cell of the pages can be wrong, and is then found."""

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from toy_repository import FILES, found, write
from typer.testing import CliRunner

import clers
from clers.cli.main import app
from clers.geometry.mesh import Mesh
from clers.specification.markdown import page
from clers.specification.worked.rule import KINDS, made
from clers.specification.worked.table import Worked, worked

ROOT = Path(clers.__file__).parents[2]
PAGES = sorted(file.name for file in (ROOT / "spec").glob("examples-*.md"))
WORDS = {
    "walk": {"because"},
    "codewords": {"column of CODE-KR-1"},
    "coder": {"field"},
    "file": {"meaning", "clause"},
}
"""The columns of the pages that no program compares."""

PAGE = "spec/01-boxes.md"
TRIANGLE = """
<!--: faces triangle -->
| face | vertices |
|---|---|
| 0 | 0 1 2 |
"""
WALK = """
<!--: walk triangle -->
| step | symbol | face | gate | apex | left | right | stack | new | opens | closes | χ | because |
|---|---|---|---|---|---|---|---|---|---|---|---|---|
| 0 | `E` | 0 | 1→2 | 0 | closed | closed | 0 | 1 2 0 | – | – | 2 | it is alone |
"""


def tables(name: str) -> tuple[dict[str, Mesh], list[Worked]]:
    meshes: dict[str, Mesh] = {}
    others: list[Worked] = []
    for table in worked(page(name, (ROOT / "spec" / name).read_text())):
        if table.kind in ("faces", "positions"):
            mesh = made(table, meshes)
            assert isinstance(mesh, Mesh)
            meshes[table.words[0]] = mesh
        else:
            others.append(table)
    return meshes, others


def changes(table: Worked) -> Iterator[tuple[str, Worked]]:
    """The table with the first character of one cell changed, in the first row and in the last."""
    for place in {0, len(table.rows) - 1}:
        line, row = table.rows[place]
        for column in set(table.columns) - WORDS.get(table.kind, set()):
            cell = row[column]
            wrong = {**row, column: ("1" if cell[:1] == "0" else "0") + cell[1:]}
            rows = (*table.rows[:place], (line, wrong), *table.rows[place + 1 :])
            yield f"{table.kind}: {column} of row {place}", replace(table, rows=rows)


@pytest.mark.parametrize("name", PAGES)
def test_every_cell_is_compared(name: str) -> None:
    """Clause: TOOL-PAGE-1. A word like `selector` is no symbol, and may be another."""
    meshes, others = tables(name)
    for table in others:
        assert not list(KINDS[table.kind](table, meshes))
        for what, wrong in changes(table):
            selector = "codewords: symbol" in what and len(table.rows[0][1]["symbol"]) > 1
            assert list(KINDS[table.kind](wrong, meshes)) or selector, f"{name}: {what}"


@pytest.mark.parametrize("name", PAGES)
def test_every_row_is_compared(name: str) -> None:
    """Clause: TOOL-PAGE-1."""
    meshes, others = tables(name)
    for table in others:
        shorter = replace(table, rows=table.rows[:-1])
        assert list(KINDS[table.kind](shorter, meshes)), f"{name}: {table.kind}"
        columns = tuple(c for c in table.columns if c in WORDS.get(table.kind, set()))
        bare = replace(table, columns=columns, rows=tuple((line, {}) for line, _ in table.rows))
        assert list(KINDS[table.kind](bare, meshes)), f"{name}: {table.kind}"


def test_the_examples_have_tables_of_every_kind() -> None:
    """Clause: TOOL-PAGE-1."""
    kinds = [table.kind for name in PAGES for table in tables(name)[1]]
    assert set(kinds) == set(KINDS)
    assert (len(PAGES), len(DRAWN)) == (6, 5)
    assert sum(len(table.rows) for name in PAGES for table in tables(name)[1]) > 400


def test_a_good_example(tmp_path: Path) -> None:
    """Clause: TOOL-PAGE-1. What is fenced is no table."""
    fenced = f"\n```markdown\n{WALK.replace('1→2', '2→1')}\n```\n"
    files = {**FILES, PAGE: FILES[PAGE] + TRIANGLE + WALK + fenced}
    assert found(write(tmp_path, files)) == []


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (WALK, 23),
        (TRIANGLE + WALK.replace("1→2", "0→1"), 30),
        (TRIANGLE + WALK.replace(" left |", " port |"), 28),
        (TRIANGLE + WALK.replace("walk triangle", "walk"), 28),
        (TRIANGLE + WALK.replace("walk triangle", "way triangle"), 28),
        (TRIANGLE + "\n<!--: walk triangle -->\nNo table.\n", 28),
        (TRIANGLE.replace("0 1 2 |", "0 1 1 |"), 23),
        (TRIANGLE.replace("0 1 2 |", "0 1 |"), 23),
        (TRIANGLE.replace("0 1 2 |", "0 1 x |"), 23),
        (TRIANGLE.replace("| 0 | 0", "| 1 | 0"), 23),
        (TRIANGLE + "\n<!--: file triangle gold -->\n| offset | bytes |\n|---|---|\n| 0 | 8 |", 28),
        (
            TRIANGLE + "\n<!--: file triangle plain -->\n| offset | bytes |\n|---|---|\n| 0 | 8 |",
            30,
        ),
        (TRIANGLE + "\n<!--: coder triangle plain -->\n| symbol |\n|---|\n| E |", 28),
    ],
)
def test_a_faulty_example(text: str, line: int, tmp_path: Path) -> None:
    """Clause: TOOL-PAGE-1."""
    faults = found(write(tmp_path, {**FILES, PAGE: FILES[PAGE] + text}))
    assert faults == [("worked", PAGE, line, "")]


PLACES = "\n<!--: positions triangle -->\n| vertex | x | y | z |\n|---|---|---|---|\n"
CORNERS = "| 0 | 0 | 0 | 0 |\n| 1 | 1 | 0 | 0 |\n| 2 | 0 | 1 | 0 |\n"


@pytest.mark.parametrize(
    "rows",
    [
        CORNERS.replace("| 2 |", "| 3 |"),
        CORNERS.replace("| 1 | 1 |", "| 1 | one |"),
        CORNERS.replace("| 1 | 1 |", "| 1 | nan |"),
        CORNERS + "| 3 | 0 | 0 | 1 |\n",
    ],
)
def test_faulty_positions(rows: str, tmp_path: Path) -> None:
    """Clause: TOOL-PAGE-1."""
    good = {**FILES, PAGE: FILES[PAGE] + TRIANGLE + PLACES + CORNERS}
    assert found(write(tmp_path, good)) == []
    bad = {**FILES, PAGE: FILES[PAGE] + TRIANGLE + PLACES + rows}
    assert found(write(tmp_path, bad)) == [("worked", PAGE, 28, "")]


COMMAND = re.compile(r"`clers trace (spec/pictures/\w+\.off) (.*?) -o (spec/pictures/\w+\.svg)`")


DRAWN = [name for name in PAGES if "](pictures/" in (ROOT / "spec" / name).read_text()]


@pytest.mark.parametrize("name", DRAWN)
def test_pictures_are_drawn_anew(name: str, tmp_path: Path) -> None:
    """The page's own command draws the committed picture, which the page shows. TOOL-PAGE-2."""
    text = (ROOT / "spec" / name).read_text()
    commands = [match.groups() for match in COMMAND.finditer(text)]
    assert len(commands) == 1
    mesh, options, picture = commands[0]
    assert f"]({picture.removeprefix('spec/')})" in text
    drawn = tmp_path / "drawn.svg"
    arguments = ["trace", str(ROOT / mesh), *options.split(), "-o", str(drawn)]
    assert CliRunner().invoke(app, arguments).exit_code == 0
    assert drawn.read_text() == (ROOT / picture).read_text()


@pytest.mark.parametrize("name", DRAWN)
def test_pictures_show_the_mesh_of_the_page(name: str) -> None:
    """Clause: TOOL-PAGE-2."""
    (surface,) = (mesh.surface for mesh in tables(name)[0].values())
    (mesh,) = {ROOT / match[1] for match in COMMAND.finditer((ROOT / "spec" / name).read_text())}
    _, counts, *rows = mesh.read_text().splitlines()
    assert counts == f"{surface.vertices} {surface.faces} 0"
    faces = [tuple(map(int, row.split()[1:])) for row in rows[surface.vertices :]]
    assert faces == list(surface.triangles())
