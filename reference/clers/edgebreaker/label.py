"""From glued triangles to a surface: name the vertices in the order of their creation, then check.

All decoders but the definition end here; they differ in how they find which edges are one.
"""

from collections.abc import Iterator, Sequence
from typing import Final

from clers.complexes.border import border_from
from clers.complexes.corner_table import surface as surface_of
from clers.complexes.face_list import FaceList, Limits
from clers.complexes.surface import BORDER, Corner, Surface, Vertex, next_corner, previous_corner
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtEdge, AtFace, AtSymbol, Where
from clers.edgebreaker.outline import Outline
from clers.edgebreaker.stream import Kind

UNNAMED: Final = Vertex(-1)


def label(outlined: Outline, glued: Sequence[int]) -> Accepted[Surface] | Rejected:
    """The surface of glued triangles, or the symbol whose triangle makes it no simplicial complex.

    `glued[c]` is the corner opposite to c, or BORDER. Vertices are numbered by EB-ORDER-1. Linear.
    Clauses: EB-ORDER-1, EB-GRAMMAR-9.
    """
    opposite = tuple(Corner(c) for c in glued)
    vertex = [UNNAMED] * len(opposite)
    count = 0
    for corner in _creation_order(outlined, opposite):
        if vertex[corner] == UNNAMED:
            _name_star(vertex, opposite, corner, Vertex(count))
            count += 1
    return _simplicial(outlined, Surface(tuple(vertex), opposite, count))


def _creation_order(outlined: Outline, opposite: Sequence[Corner]) -> Iterator[Corner]:
    """A corner of each vertex, in the order in which the encoder met them. Clause: EB-ORDER-1."""
    word, records = outlined.stream.word, outlined.stream.records
    for part in outlined.parts:
        if part.closed:
            yield from (Corner(3 * part.face + i) for i in range(3))
        else:
            yield from border_from(opposite, Corner(3 * part.first + 1))
        for i in range(part.start, part.stop):
            tip = Corner(3 * outlined.face[i])
            r = outlined.record_of[i]
            if word[i] == "C":
                yield tip
            elif r >= 0 and records[r].kind is Kind.BOUNDARY:
                yield from border_from(opposite, tip)


def _name_star(
    vertex: list[Vertex], opposite: Sequence[Corner], corner: Corner, name: Vertex
) -> None:
    """Give all corners around one vertex its name."""
    c = corner
    while vertex[c] == UNNAMED:
        vertex[c] = name
        d = opposite[next_corner(c)]
        if d == BORDER:
            break
        c = next_corner(d)
    d = opposite[previous_corner(corner)]
    while d != BORDER and vertex[c := previous_corner(d)] == UNNAMED:
        vertex[c] = name
        d = opposite[previous_corner(c)]


def _simplicial(outlined: Outline, glued: Surface) -> Accepted[Surface] | Rejected:
    """Triangles that share two vertices share the edge, and no more. Clause: EB-GRAMMAR-9.

    A face list that reads as a surface reads as this one. Two edges on the same two vertices that
    are both inside, or one of them, make an edge with three faces; both on curves, they are run one
    after the other (a vertex is on one curve, once), and a curve of two edges was refused before.
    """
    no_limit = Limits(glued.faces, glued.vertices)
    match surface_of(FaceList(tuple(glued.triangles()), glued.vertices), no_limit):
        case Accepted(value):
            return Accepted(value)
        case Rejected(reason, _, where, detail):
            repeated = reason is Reason.REPEATED_INDEX
            why = Reason.REPEATED_VERTEX if repeated else Reason.DOUBLE_EDGE
            here = _symbol_of(outlined, _face_in(where))
            return Rejected(why, Clause.EB_GRAMMAR_9, here, f"{reason}: {detail}")


def _face_in(where: Where) -> int:
    match where:
        case AtFace(face) | AtEdge(_, _, face):
            return face
        case _:
            return 0


def _symbol_of(outlined: Outline, face: int) -> AtSymbol:
    """The symbol that made a face; P is told by the first symbol after it."""
    part = max((p for p in outlined.parts if p.face <= face), key=lambda p: p.face)
    return AtSymbol(part.start + max(0, face - part.first))
