"""Operators that glue simplices to complexes, as data. What each asks for is said in `apply`.

Every operator that builds consists of attachments, and `Undo` takes them off again in the other
order.
"""

from dataclasses import dataclass
from typing import assert_never

from clers.operators.attachments.attachment import Attachment, in_order


@dataclass(frozen=True, slots=True)
class Attach:
    """Any attachment that leaves a complex. Clause: OPER-ATTACH-2."""

    glued: Attachment


@dataclass(frozen=True, slots=True)
class EulerAttach:
    """One that consists of expansions. Clause: OPER-SIMPLEX-1."""

    glued: Attachment


@dataclass(frozen=True, slots=True)
class BoundaryAttach:
    """One along facets at the boundary, which leaves a manifold as it was. OPER-SIMPLEX-5."""

    glued: Attachment


@dataclass(frozen=True, slots=True)
class Handle:
    """A generic attachment and the Euler attachments that fatten its pinches. OPER-SOLID-1."""

    first: Attachment
    then: tuple[Attachment, ...] = ()


@dataclass(frozen=True, slots=True)
class FirstVertex:
    """A point by itself. Clause: OPER-CURVE-2."""

    vertex: int


@dataclass(frozen=True, slots=True)
class EdgeAndVertex:
    """MEV: an edge from the vertex `at` to a new one. Clause: OPER-CURVE-3."""

    at: int
    new: int


@dataclass(frozen=True, slots=True)
class EdgeBetweenEnds:
    """The 1-handle of curves: an edge between two bounding vertices. Clause: OPER-CURVE-4."""

    one: int
    other: int


@dataclass(frozen=True, slots=True)
class EdgeAtInterior:
    """An edge from an interior vertex to any other. Clause: OPER-CURVE-5."""

    interior: int
    other: int


CurveOperator = FirstVertex | EdgeAndVertex | EdgeBetweenEnds | EdgeAtInterior
Constructive = Attach | EulerAttach | BoundaryAttach | Handle | CurveOperator


@dataclass(frozen=True, slots=True)
class Undo:
    """The inverse of an operator that builds. Clause: OPER-ATTACH-3."""

    done: Constructive


Operator = Constructive | Undo
Script = tuple[Operator, ...]


def inverse(operator: Operator) -> Operator:
    """The operator that leads back. Clause: OPER-ATTACH-3."""
    return operator.done if isinstance(operator, Undo) else Undo(operator)


def parts(operator: Constructive) -> tuple[Attachment, ...]:
    """The attachments that an operator consists of, in order. Clause: OPER-ATTACH-7."""
    match operator:
        case Attach(glued) | EulerAttach(glued) | BoundaryAttach(glued):
            return (glued,)
        case Handle(first, then):
            return (first, *then)
        case FirstVertex(vertex):
            return (Attachment((vertex,)),)
        case EdgeAndVertex(at, new):
            return (_edge(at, new, new_end=True),)
        case EdgeBetweenEnds(one, other) | EdgeAtInterior(one, other):
            return (_edge(one, other, new_end=False),)
        case _:
            assert_never(operator)


def _edge(one: int, other: int, *, new_end: bool) -> Attachment:
    ends = in_order((one, other))
    return Attachment(ends, ((one,),) if new_end else tuple((v,) for v in ends))
