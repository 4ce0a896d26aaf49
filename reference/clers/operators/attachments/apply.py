"""What each operator asks of the complex, and what becomes of it. Total."""

from typing import Final, assert_never

from clers.complexes.manifolds.kind import Ball, Sphere
from clers.complexes.simplicial import Complex, boundary, dimension, link, star
from clers.conventions.clause import Clause
from clers.conventions.result import Accepted, Rejected
from clers.operators.attachments.attachment import (
    Attachment,
    attach,
    common,
    detach,
    first,
    in_order,
    refused,
)
from clers.operators.attachments.expansion import expansions
from clers.operators.attachments.operator import (
    Attach,
    BoundaryAttach,
    Constructive,
    EdgeAndVertex,
    EdgeAtInterior,
    EdgeBetweenEnds,
    EulerAttach,
    FirstVertex,
    Handle,
    Operator,
    Script,
    Undo,
    parts,
)
from clers.operators.moves.recognise import recognise

NOTHING: Final = Complex(frozenset())
"""The complex without simplices, from which every script begins. Clause: OPER-ATTACH-7."""


def apply(operator: Operator, k: Complex) -> Accepted[Complex] | Rejected:
    """The complex after an operator. Clauses: OPER-ATTACH-2, OPER-ATTACH-3."""
    if isinstance(operator, Undo):
        return _undone(operator.done, k)
    after = k
    for glued in parts(operator):
        step = attach(after, glued)
        if isinstance(step, Rejected):
            return step
        after = step.value
    return _need(operator, k, after) or Accepted(after)


def _undone(operator: Constructive, k: Complex) -> Accepted[Complex] | Rejected:
    before = k
    for glued in reversed(parts(operator)):
        step = detach(before, glued)
        if isinstance(step, Rejected):
            return step
        before = step.value
    return _need(operator, before, k) or Accepted(before)


def run(script: Script, start: Complex = NOTHING) -> tuple[Accepted[Complex] | Rejected, ...]:
    """What each step of a script comes to, up to the first rejection. Clause: OPER-ATTACH-7."""
    steps: list[Accepted[Complex] | Rejected] = []
    k = start
    for operator in script:
        step = apply(operator, k)
        steps.append(step)
        if isinstance(step, Rejected):
            break
        k = step.value
    return tuple(steps)


def _need(operator: Constructive, before: Complex, after: Complex) -> Rejected | None:
    """What an operator asks for beyond its attachments, judged on the complexes around it."""
    match operator:
        case Attach():
            return None
        case EulerAttach(glued):
            return _euler(glued)
        case BoundaryAttach(glued):
            return _at_boundary(glued, before)
        case Handle():
            return _handle(operator, before, after)
        case FirstVertex() | EdgeAndVertex():
            return _curve(before)
        case EdgeBetweenEnds(one, other):
            return _curve(before) or _bounding(before, one) or _bounding(before, other)
        case EdgeAtInterior(interior):
            return _curve(before) or _interior(before, interior)
        case _:
            assert_never(operator)


def _euler(glued: Attachment) -> Rejected | None:
    """Clause: OPER-SIMPLEX-1."""
    if expansions(glued) is None:
        return refused(Clause.OPER_SIMPLEX_1, glued.simplex, "is no sequence of expansions")
    return None


def _at_boundary(glued: Attachment, before: Complex) -> Rejected | None:
    """Clause: OPER-SIMPLEX-5."""
    clause, simplex = Clause.OPER_SIMPLEX_5, glued.simplex
    m = len(simplex) - 1
    if m != dimension(before):
        return refused(clause, simplex, "has another dimension than the complex")
    if not 1 <= len(glued.along) <= m:
        return refused(clause, simplex, "is glued along none of its facets, or along all")
    for face in glued.along:
        if len(face) < m:
            return refused(clause, face, "is glued, and no facet that has it is")
        if len(star(before, frozenset(face))) != 2:
            return refused(clause, face, "is not at the boundary")
    return None


def _handle(operator: Handle, before: Complex, after: Complex) -> Rejected | None:
    """Clauses: OPER-SOLID-1, OPER-SOLID-2."""
    simplex = operator.first.simplex
    n = len(simplex) - 1
    if dimension(before) not in (-1, n):
        return refused(Clause.OPER_SOLID_1, simplex, "has another dimension than the complex")
    if len(operator.then) > max(0, n - 1):
        return refused(Clause.OPER_SOLID_1, simplex, "is followed by too many attachments")
    inside = common(operator.first).simplices - boundary(before).simplices
    if inside:
        return refused(Clause.OPER_SOLID_1, first(inside), "is not at the boundary")
    for glued in operator.then:
        if len(glued.simplex) != n + 1:
            return refused(Clause.OPER_SOLID_1, glued.simplex, "has another dimension")
        bad = _euler(glued)
        if bad is not None:
            return bad
    for vertex in in_order(v for glued in parts(operator) for v in glued.simplex):
        around = link(after, frozenset([vertex]))
        if not isinstance(recognise(around), Sphere | Ball):
            return refused(Clause.OPER_SOLID_2, (vertex,), "is pinched, or not known not to be")
    return None


def _curve(before: Complex) -> Rejected | None:
    """Clause: OPER-CURVE-1."""
    fat = [s for s in before.simplices if len(s) > 2]
    if fat:
        return refused(Clause.OPER_CURVE_1, first(fat), "is neither a vertex nor an edge")
    return None


def valence(k: Complex, vertex: int) -> int:
    """The number of edges at a vertex of a complex of vertices and edges. OPER-CURVE-1."""
    return sum(vertex in s for s in k.simplices if len(s) == 2)


def _bounding(before: Complex, vertex: int) -> Rejected | None:
    """Clause: OPER-CURVE-4."""
    if valence(before, vertex) > 1:
        return refused(Clause.OPER_CURVE_4, (vertex,), "has two edges already")
    return None


def _interior(before: Complex, vertex: int) -> Rejected | None:
    """Clause: OPER-CURVE-5."""
    if valence(before, vertex) < 2:
        return refused(Clause.OPER_CURVE_5, (vertex,), "is no interior vertex")
    return None
