"""Attachments before names: the tutorial's identification of faces with simplices of a complex.

The tutorial's condition alone is not enough for a complex to come out; what is missing is said
here, and `quotient_is_complex` is the definition to hold it against.
"""

from dataclasses import dataclass
from itertools import combinations

from clers.complexes.simplicial import Complex, Simplex, closure
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSimplex
from clers.operators.attachments.attachment import (
    Attachment,
    Vertices,
    first,
    in_order,
    maximal,
    refused,
)


@dataclass(frozen=True, slots=True)
class Gluing:
    """An m-simplex on the corners 0 … m, and what becomes of its frontier. OPER-ATTACH-4.

    `place[i]` is the vertex of the complex with which corner i is identified, −1 if none;
    `identified` are the faces identified with simplices, each by its corners, with all their faces.
    """

    place: Vertices
    identified: frozenset[Simplex]


def fits(k: Complex, gluing: Gluing) -> Rejected | None:
    """The tutorial's condition: faces to simplices, their faces one to one. OPER-ATTACH-4."""
    corners = frozenset(range(len(gluing.place)))
    for face in sorted(gluing.identified, key=in_order):
        image = [gluing.place[i] for i in sorted(face) if i in corners]
        smaller = closure([face]).simplices
        if (
            not face < corners
            or not smaller <= gluing.identified
            or len(set(image)) < len(image)
            or frozenset(image) not in k.simplices
        ):
            detail = "is not identified with a simplex, face by face"
            return Rejected(
                Reason.BAD_OPERAND, Clause.OPER_ATTACH_4, AtSimplex(in_order(face)), detail
            )
    for i, vertex in enumerate(gluing.place):
        if (vertex >= 0) != (frozenset([i]) in gluing.identified):
            detail = "has a place and is not identified, or the other way round"
            return Rejected(Reason.BAD_OPERAND, Clause.OPER_ATTACH_4, AtSimplex((i,)), detail)
    return None


def named(k: Complex, gluing: Gluing) -> Accepted[Attachment] | Rejected:
    """The attachment that a gluing is, new vertices named by the next numbers. OPER-ATTACH-9."""
    bad = fits(k, gluing)
    if bad is not None:
        return bad
    names = _names(k, gluing)
    corners = range(len(names))
    for i, j in combinations(corners, 2):
        if names[i] == names[j]:
            return refused(Clause.OPER_ATTACH_9, (i, j), "would have one vertex twice")
    new = closure([corners]).simplices - gluing.identified
    double = [face for face in new if frozenset(names[i] for i in face) in k.simplices]
    if double:
        return refused(Clause.OPER_ATTACH_9, first(double), "is new, but its vertices span one")
    along = Complex(frozenset(frozenset(names[i] for i in face) for face in gluing.identified))
    return Accepted(Attachment(in_order(names), maximal(along)))


def _names(k: Complex, gluing: Gluing) -> Vertices:
    names: list[int] = []
    free = 1 + max((v for s in k.simplices for v in s), default=-1)
    for vertex in gluing.place:
        names.append(vertex if vertex >= 0 else free)
        free += vertex < 0
    return tuple(names)


def quotient_is_complex(k: Complex, gluing: Gluing) -> bool:
    """Is what comes of the gluing a complex, told from its cells alone? Clause: OPER-ATTACH-9.

    Its cells are the simplices of the complex and the faces that were not identified. It is a
    complex if each cell has as many vertices as its dimension says, and no two cells the same.
    """
    names = _names(k, gluing)
    faces = closure([range(len(names))]).simplices - gluing.identified
    cells = [(frozenset(names[i] for i in face), len(face)) for face in faces]
    cells += [(simplex, len(simplex)) for simplex in k.simplices]
    spans = {vertices for vertices, _ in cells}
    return len(spans) == len(cells) and all(len(vertices) == size for vertices, size in cells)
