"""What a surface is, its parts and its numbers, by definition: sets and counting, nothing clever.

The oracle's own oracle. `corner_table.surface` and `topology` are linear; these are quadratic or
worse, and share no code with them.
"""

from dataclasses import dataclass
from itertools import product

from clers.complexes.face_list import DEFAULT_LIMITS, FaceList, Limits
from clers.complexes.homology import Field, coherent_chains
from clers.complexes.simplicial import (
    Complex,
    Simplex,
    boundary,
    closure,
    euler,
    is_arc,
    is_circle,
    is_pure,
    link,
    of_dimension,
    pieces,
)
from clers.complexes.surface import Face
from clers.complexes.topology import Component
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Rejected
from clers.conventions.where import AtEdge, AtFace, AtVertex, Whole


@dataclass(frozen=True, slots=True)
class Side:
    """The side of a face opposite to its corner number 0, 1 or 2: the edge tail → head."""

    face: int
    tail: int
    head: int


def sides(given: FaceList) -> tuple[Side, ...]:
    """The sides of all faces, by the corners opposite to them. Clause: CPLX-CORNER-1."""
    return tuple(
        Side(t, face[(i + 1) % 3], face[(i + 2) % 3])
        for (t, face), i in product(enumerate(given.faces), range(3))
    )


def is_surface(k: Complex) -> bool:
    """Pure, of dimension 2, and the link of each vertex a circle or an arc. CPLX-SURFACE-1."""
    links = [link(k, vertex) for vertex in of_dimension(k, 0)]
    return is_pure(k) and all(is_circle(around) or is_arc(around) for around in links)


def is_coherent_surface(given: FaceList) -> bool:
    """May the face list be called an oriented surface? Clauses: CPLX-INPUT-4, CPLX-SURFACE-2."""
    k = closure(given.faces)
    runs = [(side.tail, side.head) for side in sides(given)]
    return (
        len(of_dimension(k, 2)) == len(given.faces) > 0
        and of_dimension(k, 0) == points(given.vertices)
        and is_surface(k)
        and len(set(runs)) == len(runs)
    )


def points(count: int) -> tuple[Simplex, ...]:
    """The vertices 0 … count−1 as simplices."""
    return tuple(frozenset([v]) for v in range(count))


def first_fault(given: FaceList, limits: Limits = DEFAULT_LIMITS) -> Rejected | None:
    """The rejection of a face list by CPLX-REJECT-1 … CPLX-REJECT-9, each read aloud."""
    return _counts(given, limits) or _faces(given) or _edges(given) or _stars(given)


def _counts(given: FaceList, limits: Limits) -> Rejected | None:
    if len(given.faces) == 0:
        return Rejected(Reason.EMPTY_MESH, Clause.CPLX_REJECT_1, Whole())
    if len(given.faces) > limits.faces:
        return Rejected(Reason.TOO_MANY_FACES, Clause.CPLX_REJECT_2, Whole())
    if given.vertices > limits.vertices:
        return Rejected(Reason.TOO_MANY_VERTICES, Clause.CPLX_REJECT_2, Whole())
    return None


def _faces(given: FaceList) -> Rejected | None:
    faces = list(enumerate(given.faces))
    for t, face in faces:
        if not set(face) <= set(range(given.vertices)):
            return Rejected(Reason.INDEX_OUT_OF_RANGE, Clause.CPLX_REJECT_3, AtFace(t))
    for t, face in faces:
        if len(set(face)) < 3:
            return Rejected(Reason.REPEATED_INDEX, Clause.CPLX_REJECT_4, AtFace(t))
    for t, face in faces:
        if any(set(face) == set(earlier) for earlier in given.faces[:t]):
            return Rejected(Reason.DUPLICATE_FACE, Clause.CPLX_REJECT_5, AtFace(t))
    return None


def _edges(given: FaceList) -> Rejected | None:
    every = sides(given)
    for c, side in enumerate(every):
        if sum({s.tail, s.head} == {side.tail, side.head} for s in every[:c]) == 2:
            where = AtEdge(side.tail, side.head, side.face)
            return Rejected(Reason.EDGE_WITH_THREE_FACES, Clause.CPLX_REJECT_6, where)
    for c, side in enumerate(every):
        if any((s.tail, s.head) == (side.tail, side.head) for s in every[:c]):
            where = AtEdge(side.tail, side.head, side.face)
            return Rejected(Reason.EDGE_TWICE_IN_ONE_DIRECTION, Clause.CPLX_REJECT_7, where)
    return None


def _stars(given: FaceList) -> Rejected | None:
    k = closure(given.faces)
    for v in range(given.vertices):
        if len(pieces(link(k, frozenset([v])))) > 1:
            return Rejected(Reason.PINCHED_VERTEX, Clause.CPLX_REJECT_8, AtVertex(v))
    for v in range(given.vertices):
        if frozenset([v]) not in k.simplices:
            return Rejected(Reason.ISOLATED_VERTEX, Clause.CPLX_REJECT_9, AtVertex(v))
    return None


def is_orientable(given: FaceList) -> bool:
    """Can faces be turned over so that neighbours agree? Clauses: CPLX-ORIENT-1, CPLX-ORIENT-2.

    For face lists to which none of CPLX-REJECT-1 … CPLX-REJECT-6 applies.
    """
    k = closure(given.faces)
    return coherent_chains(k, Field.Q) == coherent_chains(k, Field.GF2)


def curves_by_definition(given: FaceList) -> tuple[tuple[int, ...], ...]:
    """The boundary curves of a surface as cycles of vertices. CPLX-CURVE-1 … CPLX-CURVE-3."""
    runs = [(side.tail, side.head) for side in sides(given)]
    border = [(tail, head) for tail, head in runs if (head, tail) not in runs]
    after = dict(border)
    found: list[tuple[int, ...]] = []
    for tail, _ in border:
        if not any(tail in curve for curve in found):
            curve = [tail]
            while after[curve[-1]] != tail:
                curve.append(after[curve[-1]])
            found.append(tuple(curve))
    return tuple(found)


def components_by_definition(given: FaceList) -> tuple[Component, ...]:
    """The components of a surface, counted in its complex. CPLX-COMPONENT-1 … -3, CPLX-COMPLEX-6.

    The curves are counted as the connected components of the boundary.
    """
    found: list[Component] = []
    for piece in pieces(closure(given.faces)):
        lowest = min(t for t, face in enumerate(given.faces) if frozenset(face) in piece.simplices)
        ends, lines, triangles = (len(of_dimension(piece, m)) for m in range(3))
        rim = boundary(piece)
        chi, loops = euler(piece), len(pieces(rim))
        border = len(of_dimension(rim, 1))
        genus = (2 - loops - chi) // 2
        found.append(Component(Face(lowest), triangles, ends, lines, border, loops, genus, chi))
    return tuple(sorted(found, key=lambda component: component.lowest))
