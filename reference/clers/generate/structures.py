"""Half-edges, corner tables and compact half-edges, good or with a few entries changed."""

from collections.abc import Mapping
from dataclasses import replace
from random import Random
from typing import Final

from hypothesis import strategies as st

from clers.complexes.polytopes.polygons import PolygonList
from clers.complexes.structures.compact import Level3, compact
from clers.complexes.structures.half_edge import HalfEdges
from clers.complexes.structures.half_edge_polygons import from_polygons
from clers.complexes.surface import Corner, Surface, Vertex, corners_listed
from clers.conventions.result import Accepted
from clers.generate.polytopes import of_triangles, oriented_polygons
from clers.generate.scripts import CHOICES
from clers.generate.surfaces import small_surfaces, surfaces

SEEDS: Final = st.integers(0, 1 << 16)


def _built(of: PolygonList) -> HalfEdges:
    answer = from_polygons(of)
    if isinstance(answer, Accepted):
        return answer.value
    raise AssertionError(f"no half-edges were made: {answer.line()}")


def renumbered(of: HalfEdges, seed: int) -> HalfEdges:
    """The same under other numbers of half-edges, by a seed; 0 changes nothing."""
    name = list(range(len(of.next)))
    if seed:
        Random(seed).shuffle(name)
    old = sorted(name, key=name.__getitem__)
    return HalfEdges(
        next=tuple(name[of.next[h]] for h in old),
        previous=tuple(name[of.previous[h]] for h in old),
        twin=tuple(name[of.twin[h]] for h in old),
        origin=tuple(of.origin[h] for h in old),
        face=tuple(of.face[h] for h in old),
        of_vertex=tuple(name[h] for h in of.of_vertex),
        of_face=tuple(name[h] for h in of.of_face),
    )


def half_edges(max_faces: int = 16) -> st.SearchStrategy[HalfEdges]:
    """Regular structures under any numbers."""
    return st.builds(renumbered, oriented_polygons(max_faces).map(_built), SEEDS)


ARRAYS: Final = ("next", "previous", "twin", "origin", "face", "of_vertex", "of_face")


def _arrays(of: HalfEdges) -> dict[str, tuple[int, ...]]:
    by_half_edge = (of.next, of.previous, of.twin, of.origin, of.face)
    return dict(zip(ARRAYS, (*by_half_edge, of.of_vertex, of.of_face), strict=True))


def _with(of: HalfEdges, name: str, array: tuple[int, ...]) -> HalfEdges:
    return HalfEdges(**{**_arrays(of), name: array})


@st.composite
def foreign_half_edges(draw: st.DrawFn) -> HalfEdges:
    """Structures with up to two entries changed, doubled or lost, or two entries exchanged."""
    of = draw(half_edges(6))
    for _ in range(draw(st.integers(0, 2))):
        name = draw(st.sampled_from(ARRAYS))
        of = _with(of, name, draw(_changed(_arrays(of)[name])))
    return of


@st.composite
def _changed(draw: st.DrawFn, array: tuple[int, ...]) -> tuple[int, ...]:
    """Most often with the length and the numbers it had: other faults than the plainest."""
    if not array:
        return (draw(st.integers(-2, 1)),)
    i, j = (draw(st.integers(0, len(array) - 1)) for _ in range(2))
    changed = list(array)
    match draw(st.sampled_from(("exchange", "copy", "exchange", "copy", "turn", "set", "length"))):
        case "exchange":
            changed[i], changed[j] = changed[j], changed[i]
        case "copy":
            changed[i] = changed[j]
        case "turn":
            changed = changed[1:] + changed[:1]
        case "set":
            changed[i] = draw(st.integers(-2, len(array) + 1))
        case _:
            changed = draw(st.sampled_from((changed[:-1], [*changed, i])))
    return tuple(changed)


@st.composite
def flips(draw: st.DrawFn) -> tuple[HalfEdges, int]:
    """A structure and one of its half-edges."""
    triangles = surfaces(24, (0, 1), (0, 2), (1, 2)).map(of_triangles).map(_built)
    of = draw(st.one_of(triangles, half_edges()))
    return of, draw(CHOICES) % len(of.next)


@st.composite
def foreign_tables(draw: st.DrawFn) -> Surface:
    """Corner tables with up to two arrays changed."""
    of = draw(small_surfaces(8))
    vertex, opposite = tuple(map(int, of.vertex)), tuple(map(int, of.opposite))
    for which in draw(st.lists(st.booleans(), max_size=2)):
        if which:
            vertex = draw(_changed(vertex))
        else:
            opposite = draw(_changed(opposite))
    return corners_listed(tuple(map(Vertex, vertex)), tuple(map(Corner, opposite)), of.vertices)


@st.composite
def foreign_compact(draw: st.DrawFn) -> Level3:
    """All four levels with up to two arrays changed."""
    of = compact(draw(small_surfaces(8)))
    for which in draw(st.lists(st.integers(0, 4), max_size=2)):
        of = _changed_level(of, which, draw)
    return of


def _changed_level(of: Level3, which: int, draw: st.DrawFn) -> Level3:
    cells, table, soup = of.cells, of.cells.table, of.cells.table.soup
    match which:
        case 0:
            soup = replace(soup, vertex=draw(_changed(soup.vertex)))
        case 1:
            table = replace(table, opposite=draw(_changed(table.opposite)))
        case 2:
            cells = replace(cells, of_vertex=draw(_changed(cells.of_vertex)))
        case 3:
            cells = replace(cells, edges=draw(_changed(cells.edges)))
        case _:
            of = replace(of, curves=draw(_changed(of.curves)))
    return replace(of, cells=replace(cells, table=replace(table, soup=soup)))


DOMAINS: Final[Mapping[str, st.SearchStrategy[object]]] = {
    "half-edges": half_edges(),
    "foreign-half-edges": foreign_half_edges(),
    "half-edge-flips": flips(),
    "foreign-corner-tables": foreign_tables(),
    "foreign-compact-half-edges": foreign_compact(),
}
"""The domains of this module, by name."""
