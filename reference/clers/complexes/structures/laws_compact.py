"""Laws of corner tables from elsewhere and of compact half-edges."""

from typing import Final

from clers.complexes import corner_table as tables
from clers.complexes.definition import is_coherent_surface, sides
from clers.complexes.face_list import FaceList
from clers.complexes.given import SMALL_SURFACES, SURFACES
from clers.complexes.polytopes.polygons import PolygonList
from clers.complexes.structures.compact import (
    NONE,
    Level0,
    Level1,
    Level2,
    Level3,
    after,
    compact,
    face_list,
    integers,
)
from clers.complexes.structures.compact_invariant import level_0, level_1, level_2, level_3
from clers.complexes.structures.compact_queries import (
    curves_2,
    curves_3,
    opposite_0,
    opposite_1,
    star_0,
    star_1,
    star_2,
)
from clers.complexes.structures.corner_invariant import corner_table
from clers.complexes.structures.given import FOREIGN_COMPACT, FOREIGN_TABLES
from clers.complexes.structures.half_edge_polygons import from_polygons
from clers.complexes.surface import BORDER, Surface
from clers.complexes.topology import components, curves
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Verdict
from clers.conventions.where import AtVertex


def _table(of: Surface) -> Verdict:
    return same(_is_corner_table(of), corner_table(of) == Accepted(of))


def _is_corner_table(of: Surface) -> bool:
    if len(of.vertex) % 3 or len(of.opposite) != len(of.vertex):
        return False
    mesh = FaceList(tuple(of.triangles()), of.vertices)
    if not is_coherent_surface(mesh):
        return False
    corner = {(side.tail, side.head): c for c, side in enumerate(sides(mesh))}
    return all(
        of.opposite[c] == corner.get((side.head, side.tail), BORDER)
        for c, side in enumerate(sides(mesh))
    )


def _built(of: Surface) -> Verdict:
    made = compact(of)
    table = made.cells.table
    return every(
        same(tables.face_list(of), face_list(table.soup)),
        same(Accepted(table.soup), level_0(table.soup)),
        same(Accepted(table), level_1(table)),
        same(Accepted(made.cells), level_2(made.cells)),
        same(Accepted(made), level_3(made)),
    )


def _ends(of: Level0, h: int) -> tuple[int, int]:
    return of.vertex[h], of.vertex[after(h)]


def _arrays(of: Surface) -> Verdict:
    made = compact(of)
    cells, table, soup = made.cells, made.cells.table, made.cells.table.soup
    every_end = {_ends(soup, h): h for h in range(len(soup.vertex))}
    border = {h for h in range(len(soup.vertex)) if _ends(soup, h)[::-1] not in every_end}
    leaving = [
        [h for h in range(len(soup.vertex)) if soup.vertex[h] == v] for v in range(soup.vertices)
    ]
    edges = [h for (a, b), h in every_end.items() if h <= every_end.get((b, a), h)]
    return every(
        same(tuple(every_end.get(ends[::-1], NONE) for ends in every_end), table.opposite),
        same(
            tuple(min((h for h in at if h in border), default=at[0]) for at in leaving),
            cells.of_vertex,
        ),
        same(tuple(sorted(edges)), cells.edges),
        same(True, set(made.curves) <= border),
        same(len(curves(of)), len(made.curves)),
        same(tuple(sorted(made.curves)), made.curves),
    )


def _judged(of: Level3) -> Verdict:
    """By definition: the soup is a surface, and each array says of it what it should."""
    table, soup = of.cells.table, of.cells.table.soup
    good = [len(soup.vertex) % 3 == 0 and is_coherent_surface(face_list(soup))]
    good.append(good[0] and _is_adjacency(table))
    good.append(good[1] and _are_cells(of.cells))
    good.append(good[2] and _are_curves(of))
    found: list[object] = [level_0(soup), level_1(table), level_2(of.cells), level_3(of)]
    return same(good, [isinstance(answer, Accepted) for answer in found])


def _is_adjacency(of: Level1) -> bool:
    ends = {_ends(of.soup, h): h for h in range(len(of.soup.vertex))}
    return of.opposite == tuple(ends.get(pair[::-1], NONE) for pair in ends)


def _are_cells(of: Level2) -> bool:
    soup, opposite = of.table.soup, of.table.opposite
    half_edges = set(range(len(opposite)))
    if not {*of.of_vertex, *of.edges} <= half_edges or len(of.of_vertex) != soup.vertices:
        return False
    border = {v for h in half_edges if opposite[h] == NONE for v in _ends(soup, h)}
    leave = all(soup.vertex[h] == v for v, h in enumerate(of.of_vertex))
    at_border = all((opposite[h] == NONE) == (v in border) for v, h in enumerate(of.of_vertex))
    named = [frozenset(_ends(soup, h)) for h in of.edges]
    every_edge = {frozenset(_ends(soup, h)) for h in half_edges}
    return leave and at_border and len(set(named)) == len(named) and set(named) == every_edge


def _are_curves(of: Level3) -> bool:
    soup, opposite = of.cells.table.soup, of.cells.table.opposite
    answer = tables.surface(face_list(soup))
    if isinstance(answer, Rejected):
        return False
    loops = [set(curve.vertices) for curve in curves(answer.value)]
    if not set(of.curves) <= {h for h, other in enumerate(opposite) if other == NONE}:
        return False
    hit = sorted(i for h in of.curves for i, loop in enumerate(loops) if soup.vertex[h] in loop)
    return hit == list(range(len(loops)))


def _sizes(of: Surface) -> Verdict:
    made = compact(of)
    parts = components(of)
    t, v = of.faces, of.vertices
    e, b = sum(part.edges for part in parts), sum(part.curves for part in parts)
    faces = tables.face_list(of).faces
    full = from_polygons(PolygonList(faces, of.vertices))
    if isinstance(full, Rejected):
        return same("half-edges", full)
    he = full.value
    arrays = (he.next, he.previous, he.twin, he.origin, he.face, he.of_vertex, he.of_face)
    handles = sum(part.genus for part in parts)
    closed = (2 * integers(made.cells), 2 * sum(map(len, arrays)))
    twice = 4 * len(parts) - 4 * handles
    return every(
        same(3 * t, integers(made.cells.table.soup)),
        same(6 * t, integers(made.cells.table)),
        same(len(of.vertex) + len(of.opposite), integers(made.cells.table)),
        same(6 * t + v + e, integers(made.cells)),
        same(6 * t + v + e + b, integers(made)),
        same(10 * e + v + t, sum(map(len, arrays))),
        same((16 * t + twice, 33 * t + twice), closed) if b == 0 else every(),
    )


def _stars(of: Surface) -> Verdict:
    made = compact(of)
    table, soup = made.cells.table, made.cells.table.soup
    verdicts: list[Verdict] = []
    for v in range(of.vertices):
        expected = frozenset(t for t, face in enumerate(of.triangles()) if v in face)
        scanned, turned, direct = star_0(soup, v), star_1(table, v), star_2(made.cells, v)
        d, n = len(expected), 3 * of.faces
        answers = (scanned.answer, turned.answer, direct.answer)
        verdicts.append(
            every(
                same((expected,) * 3, answers, AtVertex(v)),
                same((n, 1 + d), (scanned.entries, direct.entries), AtVertex(v)),
                same(True, d < turned.entries <= n + d + 1, AtVertex(v)),
            )
        )
    return every(*verdicts)


def _opposites(of: Surface) -> Verdict:
    made = compact(of).cells.table
    verdicts: list[Verdict] = []
    for h in range(len(of.vertex)):
        scanned, direct = opposite_0(made.soup, h), opposite_1(made, h)
        verdicts.append(
            every(
                same(scanned.answer, direct.answer),
                same(1, direct.entries),
                same(True, 2 < scanned.entries <= 2 + 6 * of.faces),
            )
        )
    return every(*verdicts)


def _curves(of: Surface) -> Verdict:
    made = compact(of)
    expected = [_from_lowest(curve.vertices) for curve in curves(of)]
    looked, known = curves_2(made.cells), curves_3(made)
    length = sum(map(len, expected))
    return every(
        same(sorted(expected), sorted(map(_from_lowest, looked.answer))),
        same(looked.answer, known.answer),
        same(3 * of.faces + 2 * length, looked.entries),
        same(len(expected) + 2 * length, known.entries),
        same([of.vertex[h] for h in made.curves], [curve[0] for curve in known.answer]),
    )


def _from_lowest(cycle: tuple[int, ...]) -> tuple[int, ...]:
    at = cycle.index(min(cycle))
    return cycle[at:] + cycle[:at]


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "foreign-corner-tables-are-judged-as-defined",
        Clause.CPLX_REFINE_2,
        "A corner table is accepted exactly if its faces are a surface by definition, and each "
        "opposite is the corner of the edge run the other way.",
        FOREIGN_TABLES,
        _table,
    ),
    Law(
        "compact-half-edges-refine-surfaces",
        Clause.CPLX_REFINE_1,
        "Each level of a surface satisfies its invariant, and its face list is the surface's.",
        SURFACES,
        _built,
    ),
    Law(
        "compact-arrays-say-what-they-should",
        Clause.CPLX_COMPACT_2,
        "Opposites run the other way, vertices and edges have their lowest half-edges, vertices on "
        "the boundary a border one, and curves one each.",
        SMALL_SURFACES,
        _arrays,
    ),
    Law(
        "foreign-compact-half-edges-are-judged-as-defined",
        Clause.CPLX_COMPACT_3,
        "Each level is accepted exactly if its arrays say of the face list what they should.",
        FOREIGN_COMPACT,
        _judged,
    ),
    Law(
        "structures-take-the-integers-stated",
        Clause.CPLX_COMPACT_4,
        "The arrays hold 3T, 6T, 6T + V + E, 6T + V + E + b and 10E + V + T integers.",
        SURFACES,
        _sizes,
    ),
    Law(
        "stars-are-the-same-at-every-level",
        Clause.CPLX_COMPACT_5,
        "The star of a vertex reads 3T entries, at most 3T + d + 1, and 1 + d.",
        SMALL_SURFACES,
        _stars,
    ),
    Law(
        "opposites-are-the-same-at-every-level",
        Clause.CPLX_COMPACT_6,
        "The opposite half-edge is found by looking at all, or read.",
        SMALL_SURFACES,
        _opposites,
    ),
    Law(
        "curves-are-the-same-at-every-level",
        Clause.CPLX_COMPACT_7,
        "The boundary curves read 3T + 2L entries, or b + 2L, and are those of the corner table.",
        SURFACES,
        _curves,
    ),
)
