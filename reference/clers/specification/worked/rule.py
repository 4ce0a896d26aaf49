"""The rule on worked examples: each table is what the reference computes. Clause: TOOL-PAGE-1."""

from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Final

from clers.geometry.mesh import Mesh
from clers.specification.finding import Finding
from clers.specification.markdown import Page
from clers.specification.repository import Repository
from clers.specification.worked import bits, coder, decoding, files, places, walks
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
        "codes": bits.every_code,
        "coder": coder.steps,
        "decoder": coder.back,
        "lattice": places.lattice,
        "file": files.file,
    }
)
"""What each kind of table demands; `faces` and `positions` demand nothing and make a mesh."""


def as_worked(of: Repository) -> Iterator[Finding]:
    """Every table of a worked example is right. Clause: TOOL-PAGE-1."""
    for page in of.pages:
        for line, text in _faults(page):
            yield Finding("worked", page.path, line, "", text)


def _faults(page: Page) -> Iterator[Fault]:
    meshes: dict[str, Mesh] = {}
    for table in worked(page):
        if not table.rows:
            yield table.line, f"no table of the kind {table.kind!r} stands here"
        elif not table.words:
            yield table.line, "which mesh the table is about is not said"
        elif table.kind != "faces" and table.words[0] not in meshes:
            yield table.line, f"no table of faces above names {table.words[0]!r}"
        elif table.kind in ("faces", "positions"):
            read = made(table, meshes)
            if isinstance(read, Mesh):
                meshes[table.words[0]] = read
            else:
                yield table.line, read
        elif table.kind in KINDS:
            yield from KINDS[table.kind](table, meshes)
        else:
            yield table.line, f"there is no kind of table {table.kind!r}"


def made(table: Worked, meshes: Mapping[str, Mesh]) -> Mesh | str:
    """The mesh of a table of faces, or a mesh with positions; or what is wrong. TOOL-PAGE-1."""
    if table.kind == "positions":
        return places.placed(table, meshes[table.words[0]])
    return walks.named(table)
