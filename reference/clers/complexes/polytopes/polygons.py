"""Polygon lists: what a mesh file with polygons says, and when it is an oriented surface."""

from collections.abc import Iterator
from dataclasses import dataclass

from clers.complexes.parity import Parity
from clers.complexes.polytopes.cells import CellList, Polytope
from clers.complexes.polytopes.construct import polytope
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtCell, AtEdge, AtFace, AtVertex

Polygon = tuple[int, ...]


@dataclass(frozen=True, slots=True)
class PolygonList:
    """Polygons as sequences of vertices 0 … vertices−1. Clause: CPLX-POLYGON-1.

    Nothing is checked yet.
    """

    faces: tuple[Polygon, ...]
    vertices: int


@dataclass(frozen=True, slots=True)
class Side:
    """The side tail → head of a polygon."""

    tail: int
    head: int
    face: int


def sides(of: PolygonList) -> Iterator[Side]:
    """The sides of all polygons, in order, the last of each back to its first vertex."""
    return (
        Side(face[i], face[(i + 1) % len(face)], t)
        for t, face in enumerate(of.faces)
        for i in range(len(face))
    )


def cell_list(of: PolygonList) -> CellList:
    """The polygons as cells, edges by their first appearance. Clause: CPLX-POLYGON-1."""
    number: dict[frozenset[int], int] = {}
    around: list[set[int]] = [set() for _ in of.faces]
    for side in sides(of):
        ends = frozenset([side.tail, side.head])
        around[side.face].add(number.setdefault(ends, len(number)))
    return CellList(of.vertices, (tuple(number), tuple(map(frozenset, around))))


def polygon_surface(of: PolygonList) -> Accepted[Polytope] | Rejected:
    """The polytope of an oriented polygonal surface, or the first fault.

    Clause: CPLX-POLYGON-2; by the cells instead: CPLX-POLYGON-3.
    """
    fault = _bad_faces(of) or _bad_edges(of) or _bad_vertices(of)
    if fault is not None:
        return fault
    answer = polytope(cell_list(of))
    if isinstance(answer, Rejected):
        where = answer.where
        face = AtFace(where.number) if isinstance(where, AtCell) else where
        return Rejected(answer.reason, Clause.CPLX_POLYGON_2, face, answer.detail)
    return answer


def _bad_faces(of: PolygonList) -> Rejected | None:
    if not of.faces:
        return Rejected(Reason.EMPTY_MESH, Clause.CPLX_POLYGON_2)
    for t, face in enumerate(of.faces):
        if not all(0 <= v < of.vertices for v in face):
            return Rejected(Reason.INDEX_OUT_OF_RANGE, Clause.CPLX_POLYGON_2, AtFace(t))
    for t, face in enumerate(of.faces):
        if len(face) < 3 or len(set(face)) < len(face):
            return Rejected(Reason.REPEATED_INDEX, Clause.CPLX_POLYGON_2, AtFace(t))
    seen: set[frozenset[int]] = set()
    for t, face in enumerate(of.faces):
        if frozenset(face) in seen:
            return Rejected(Reason.DUPLICATE_FACE, Clause.CPLX_POLYGON_2, AtFace(t))
        seen.add(frozenset(face))
    return None


def _bad_edges(of: PolygonList) -> Rejected | None:
    count: dict[frozenset[int], int] = {}
    for side in sides(of):
        ends = frozenset([side.tail, side.head])
        count[ends] = count.get(ends, 0) + 1
        if count[ends] == 3:
            where = AtEdge(side.tail, side.head, side.face)
            return Rejected(Reason.EDGE_WITH_THREE_FACES, Clause.CPLX_POLYGON_2, where)
    run: set[tuple[int, int]] = set()
    for side in sides(of):
        if (side.tail, side.head) in run:
            where = AtEdge(side.tail, side.head, side.face)
            return Rejected(Reason.EDGE_TWICE_IN_ONE_DIRECTION, Clause.CPLX_POLYGON_2, where)
        run.add((side.tail, side.head))
    return None


def _bad_vertices(of: PolygonList) -> Rejected | None:
    """Each vertex has exactly one fan of polygons. Clause: CPLX-POLYGON-2."""
    count = [0] * of.vertices
    for v in fan_tails(of):
        count[v] += 1
    for v, fans in enumerate(count):
        if fans > 1:
            detail = f"its star is {fans} fans"
            return Rejected(Reason.PINCHED_VERTEX, Clause.CPLX_POLYGON_2, AtVertex(v), detail)
    if 0 in count:
        where = AtVertex(count.index(0))
        return Rejected(Reason.ISOLATED_VERTEX, Clause.CPLX_POLYGON_2, where)
    return None


def fan_tails(of: PolygonList) -> list[int]:
    """For each fan of polygons its vertex.

    The polygon of the side a → b meets at a the one that runs b → a, and in that one the side that
    follows begins at a as well.
    """
    every = tuple(sides(of))
    number = {(side.tail, side.head): h for h, side in enumerate(every)}
    after = following(of)
    sets = Parity(len(every))
    for h, side in enumerate(every):
        other = number.get((side.head, side.tail))
        if other is not None:
            sets.unite(h, after[other], differ=False)
    return [side.tail for h, side in enumerate(every) if sets.find(h)[0] == h]


def following(of: PolygonList) -> tuple[int, ...]:
    """For each side, as `sides` lists them, the number of the next one of its polygon."""
    numbers: list[int] = []
    for face in of.faces:
        first = len(numbers)
        numbers += [*range(first + 1, first + len(face)), first]
    return tuple(numbers)
