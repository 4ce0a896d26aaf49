"""What `--json` prints of meshes, files and words: frozen records, with a published schema each.

The schemas in spec/schemas/ are made from these classes by `clers schema`. Clause: TOOL-SCHEMA-1.
"""

from dataclasses import dataclass

from clers.codes.registry import CODES
from clers.complexes.surface import Surface
from clers.complexes.topology import Component, components
from clers.container.file import Description
from clers.edgebreaker.stream import Encoding


@dataclass(frozen=True, slots=True)
class ComponentView:
    """The counts of one component."""

    vertices: int
    faces: int
    edges: int
    boundary_edges: int
    curves: int
    genus: int
    euler: int


@dataclass(frozen=True, slots=True)
class SectionView:
    """A section of a file and the length of its payload."""

    tag: str
    bytes: int


@dataclass(frozen=True, slots=True)
class FileView:
    """What a `.clers` file says of itself."""

    version: int
    bytes: int
    code: str
    guarantee: str
    most_bits: int | None
    positions: str
    symbols: int
    records: int
    components_with_boundary: int
    sections: tuple[SectionView, ...]


@dataclass(frozen=True, slots=True)
class InfoView:
    """`clers info --json`. Clause: TOOL-INFO-1."""

    vertices: int
    faces: int
    components: tuple[ComponentView, ...]
    file: FileView | None = None


@dataclass(frozen=True, slots=True)
class HandleView:
    """One record of the handle data."""

    kind: str
    s: int
    at: int
    side: str


@dataclass(frozen=True, slots=True)
class WordView:
    """`clers word --json`. Clause: TOOL-WORD-1."""

    word: str
    handles: tuple[HandleView, ...]
    components_with_boundary: int
    vertex_order: tuple[int, ...]


def component_view(c: Component) -> ComponentView:
    """The counts of a component, without its place."""
    return ComponentView(c.vertices, c.faces, c.edges, c.boundary_edges, c.curves, c.genus, c.euler)


def info_view(surface: Surface, file: FileView | None = None) -> InfoView:
    """A surface in numbers."""
    parts = tuple(map(component_view, components(surface)))
    return InfoView(surface.vertices, surface.faces, parts, file)


def file_view(description: Description, size: int, surface: Surface) -> FileView:
    """A file in numbers, with what the code of its word promises for its surface."""
    head = description.head
    promise = CODES[head.code].guarantee
    return FileView(
        description.version,
        size,
        str(head.code),
        promise.text,
        promise.bits(components(surface)),
        str(head.positions),
        head.symbols,
        head.records,
        head.components_with_boundary,
        tuple(SectionView(s.tag, s.stop - s.start) for s in description.sections),
    )


def word_view(encoding: Encoding) -> WordView:
    """A stream and its vertex order."""
    stream = encoding.stream
    return WordView(
        stream.word,
        tuple(HandleView(str(r.kind), r.s, r.at, str(r.side)) for r in stream.records),
        stream.components_with_boundary,
        encoding.vertex_order,
    )
