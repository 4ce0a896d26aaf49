"""Attachments: a simplex glued to a complex along a part of its frontier, and taken off again.

The complex has names for its vertices, so that identifying faces of the simplex with simplices of
the complex is giving them the same names. What is glued is data; `gluing` is the same before names.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

from clers.complexes.simplicial import Complex, Simplex, closure
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import AtSimplex

Vertices = tuple[int, ...]
"""A simplex as data: its vertices in increasing order."""

MOST_VERTICES: Final = 10
"""A simplex has fewer than 2^10 faces, so that no script makes a reader work without end."""


@dataclass(frozen=True, slots=True)
class Attachment:
    """A simplex, and the maximal simplices of its frontier that are there. Clause: OPER-ATTACH-1.

    `simplex` has increasing vertices; `along` is in lexicographic order, each increasing.
    """

    simplex: Vertices
    along: tuple[Vertices, ...] = ()


def in_order(simplex: Iterable[int]) -> Vertices:
    """The vertices of a simplex in increasing order, each once."""
    return tuple(sorted(set(simplex)))


def maximal(k: Complex) -> tuple[Vertices, ...]:
    """The simplices of a complex that lie in no other, in lexicographic order. OPER-ATTACH-1."""
    return tuple(
        sorted(in_order(s) for s in k.simplices if not any(s < other for other in k.simplices))
    )


def common(glued: Attachment) -> Complex:
    """The part of the frontier along which the simplex is glued. Clause: OPER-ATTACH-1."""
    return closure(glued.along)


def added(glued: Attachment) -> frozenset[Simplex]:
    """The simplex and those of its faces that are new. Clause: OPER-ATTACH-2."""
    return closure([glued.simplex]).simplices - common(glued).simplices


def attachment(k: Complex, simplex: Iterable[int]) -> Attachment:
    """The only attachment of a simplex that can fit a complex. Clause: OPER-ATTACH-2."""
    vertices = in_order(simplex)
    return Attachment(
        vertices,
        maximal(Complex(closure([vertices]).simplices & k.simplices - {Simplex(vertices)})),
    )


def malformed(glued: Attachment) -> Rejected | None:
    """What is wrong with the value itself, whatever the complex. Clause: OPER-ATTACH-1."""
    simplex = glued.simplex
    if len(simplex) > MOST_VERTICES:
        where = AtSimplex(in_order(simplex))
        return Rejected(Reason.TOO_MANY_VERTICES, Clause.OPER_ATTACH_1, where)
    if not _is_simplex(simplex):
        return _bad(simplex, "no simplex in increasing order")
    for face in glued.along:
        if not _is_simplex(face) or not set(face) < set(simplex):
            return _bad(face, "no proper face in increasing order")
    if glued.along != maximal(common(glued)):
        return _bad(simplex, "the faces along which it is glued are not maximal and in order")
    return None


def _is_simplex(vertices: Vertices) -> bool:
    return len(vertices) > 0 and vertices == in_order(vertices) and vertices[0] >= 0


def _bad(simplex: Vertices, detail: str) -> Rejected:
    where = AtSimplex(in_order(simplex))
    return Rejected(Reason.BAD_OPERAND, Clause.OPER_ATTACH_1, where, detail)


def refused(
    clause: Clause,
    simplex: Iterable[int],
    detail: str,
    reason: Reason = Reason.OPERATOR_NOT_APPLICABLE,
) -> Rejected:
    """The rejection of an attachment that does not fit, at a simplex."""
    return Rejected(reason, clause, AtSimplex(in_order(simplex)), detail)


def first(simplices: Iterable[Simplex]) -> Vertices:
    """The simplex that a rejection blames: of the lowest dimension, then by its vertices."""
    return min(map(in_order, simplices), key=lambda s: (len(s), s))


def attach(k: Complex, glued: Attachment) -> Accepted[Complex] | Rejected:
    """Add the simplex with its new faces. Clauses: OPER-ATTACH-2, OPER-SIMPLEX-4."""
    bad = malformed(glued)
    if bad is not None:
        return bad
    missing = common(glued).simplices - k.simplices
    if missing:
        return _lacks(Clause.OPER_ATTACH_2, missing)
    new = added(glued)
    there = new & k.simplices
    if there:
        blamed, why = first(there), "is to be new"
        return refused(Clause.OPER_ATTACH_2, blamed, why, Reason.PRESENT_SIMPLEX)
    return Accepted(Complex(k.simplices | new))


def detach(k: Complex, glued: Attachment) -> Accepted[Complex] | Rejected:
    """Remove the simplex with the faces that were new: the inverse. Clause: OPER-ATTACH-3."""
    bad = malformed(glued)
    if bad is not None:
        return bad
    missing = closure([glued.simplex]).simplices - k.simplices
    if missing:
        return _lacks(Clause.OPER_ATTACH_3, missing)
    gone = added(glued)
    held = {s for s in k.simplices - gone if any(face < s for face in gone)}
    if held:
        return refused(Clause.OPER_ATTACH_3, first(held), "has a face that is to go")
    return Accepted(Complex(k.simplices - gone))


def _lacks(clause: Clause, missing: Iterable[Simplex]) -> Rejected:
    return refused(clause, first(missing), "is to be there", Reason.MISSING_SIMPLEX)
