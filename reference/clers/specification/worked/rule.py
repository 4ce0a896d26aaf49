"""The rule on worked examples: each table is what the reference computes. Clause: TOOL-PAGE-1."""

from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Final

from clers.complexes.surface import Surface
from clers.specification.finding import Finding
from clers.specification.markdown import Page
from clers.specification.repository import Repository
from clers.specification.worked import bits, coder, decoding, files, walks
from clers.specification.worked.table import Fault, Kind, Worked, worked

KINDS: Final[Mapping[str, Kind]] = MappingProxyType(
    {
        "corners": walks.corners,
        "walk": walks.walk,
        "records": walks.records,
        "created": walks.created,
        "undo": decoding.undo,
        "wrap": decoding.wrap,
        "stars": decoding.closed_stars,
        "closings": bits.closings,
        "codewords": bits.codewords,
        "coder": coder.steps,
        "decoder": coder.back,
        "file": files.file,
    }
)
"""What each kind of table demands; `faces` alone demands nothing and names a mesh."""


def as_worked(of: Repository) -> Iterator[Finding]:
    """Every table of a worked example is right. Clause: TOOL-PAGE-1."""
    for page in of.pages:
        for line, text in _faults(page):
            yield Finding("worked", page.path, line, "", text)


def _faults(page: Page) -> Iterator[Fault]:
    meshes: dict[str, Surface] = {}
    for table in worked(page):
        if not table.rows:
            yield table.line, f"no table of the kind {table.kind!r} stands here"
        elif not table.words:
            yield table.line, "which mesh the table is about is not said"
        elif table.kind == "faces":
            read = walks.named(table)
            if isinstance(read, str):
                yield table.line, read
            else:
                meshes[table.words[0]] = read
        elif table.kind not in KINDS:
            yield table.line, f"there is no kind of table {table.kind!r}"
        elif table.words[0] not in meshes:
            yield table.line, f"no table of faces above names {table.words[0]!r}"
        else:
            yield from _checked(table, meshes)


def _checked(table: Worked, meshes: Mapping[str, Surface]) -> Iterator[Fault]:
    yield from KINDS[table.kind](table, meshes)
