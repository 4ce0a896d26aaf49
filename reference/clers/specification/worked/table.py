"""Tables on pages that say what they are: an HTML comment `<!--: kind words -->` before them."""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from clers.geometry.mesh import Mesh
from clers.specification.markdown import Page

_OPENING: Final = re.compile(r"<!--:\s*(.*?)\s*-->")
_ROW: Final = re.compile(r"\s*\|(.*)\|\s*")
_RULE: Final = re.compile(r"[\s|:-]+")
NONE: Final = "–"
"""A cell that says that there is nothing."""


@dataclass(frozen=True, slots=True)
class Worked:
    """A table of an example: its first line (from 1), its kind, the words after it, its cells.

    `rows` are the cells below the heading, each with its line, by the heading of their column,
    without the marks of code.
    """

    line: int
    kind: str
    words: tuple[str, ...]
    columns: tuple[str, ...]
    rows: tuple[tuple[int, Mapping[str, str]], ...]

    def column(self, name: str) -> tuple[str, ...]:
        """The cells of a column, empty where the table has none of this name."""
        return tuple(row.get(name, "") for _, row in self.rows)


Meshes = Mapping[str, Mesh]
"""The meshes that a page has named so far."""

Fault = tuple[int, str]
"""The line, and what is wrong there."""

Kind = Callable[[Worked, Meshes], Iterator[Fault]]
"""What a kind of table demands, given the meshes that the page has named."""


def worked(of: Page) -> Iterator[Worked]:
    """Every table of a page that says what it is. Clause: TOOL-PAGE-1."""
    lines = of.text.splitlines()
    fenced = False
    for at, text in enumerate(lines):
        fenced ^= text.lstrip().startswith("```")
        opening = None if fenced else _OPENING.fullmatch(text.strip())
        if opening:
            kind, *words = opening[1].split() or [""]
            yield _table(at + 2, kind, tuple(words), lines[at + 1 :])


def _table(line: int, kind: str, words: tuple[str, ...], lines: Sequence[str]) -> Worked:
    """The table that begins at `line`; blank lines before it are stepped over."""
    start = next((k for k, text in enumerate(lines) if text.strip()), len(lines))
    found: list[tuple[int, tuple[str, ...]]] = []
    for k, text in enumerate(lines[start:], start):
        row = _ROW.fullmatch(text)
        if row is None:
            break
        if not _RULE.fullmatch(text):
            cells = tuple(cell.strip().replace("`", "") for cell in row[1].split("|"))
            found.append((line + k, cells))
    columns = found[0][1] if found else ()
    rows = ((at, dict(zip(columns, cells, strict=False))) for at, cells in found[1:])
    return Worked(line + start, kind, words, columns, tuple(rows))


def compared(table: Worked, expected: Sequence[Mapping[str, str]]) -> Iterator[Fault]:
    """Where a table differs from the rows that it should have; other columns are words of its own.

    Clause: TOOL-PAGE-1.
    """
    missing = [name for name in (expected[0] if expected else ()) if name not in table.columns]
    if missing:
        yield table.line, f"the table {table.kind} has no column {', '.join(missing)}"
        return
    if len(table.rows) != len(expected):
        text = f"the table {table.kind} has {len(table.rows)} rows, should have {len(expected)}"
        yield table.line, text
    for (line, row), want in zip(table.rows, expected, strict=False):
        for name, cell in want.items():
            if row.get(name) != cell:
                yield line, f"{name}: expected {cell}, got {row.get(name, 'no cell')}"


def listed(values: Sequence[object]) -> str:
    """Values in a cell."""
    return " ".join(map(str, values)) or NONE
