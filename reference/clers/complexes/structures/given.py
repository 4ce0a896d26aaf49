"""The domains that the laws of structures range over; `clers.generate` draws from them."""

from typing import Final

from clers.complexes.structures.compact import Level3
from clers.complexes.structures.half_edge import HalfEdges
from clers.complexes.surface import Surface
from clers.conventions.law import Given

HALF_EDGES: Final = Given(
    "half-edges", "regular half-edge structures under any numbers of half-edges", HalfEdges
)
FOREIGN: Final = Given(
    "foreign-half-edges", "half-edge structures, good or with a few entries changed", HalfEdges
)
FLIPS: Final[Given[tuple[HalfEdges, int]]] = Given(
    "half-edge-flips", "a regular half-edge structure and a half-edge of it", tuple
)
FOREIGN_TABLES: Final = Given(
    "foreign-corner-tables", "corner tables, good or with a few entries changed", Surface
)
FOREIGN_COMPACT: Final = Given(
    "foreign-compact-half-edges", "all four levels, good or with a few entries changed", Level3
)
