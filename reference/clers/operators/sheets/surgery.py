"""What gluing a triangle does to loops: five functions that sheets and gates share.

A loop is given from the gate on, (a, b, x₂, …, x_{p−1}), run with the missing part on its left.
"""

from collections.abc import Sequence
from typing import TypeVar

V = TypeVar("V", bound=int)


def beyond(loop: Sequence[V], new: V) -> tuple[V, ...]:
    """The loop after a triangle from the gate to a new vertex. Clause: OPER-SURFACE-3."""
    a, b, *rest = loop
    return (new, b, *rest, a)


def past_next(loop: Sequence[V]) -> tuple[V, ...]:
    """The loop after a triangle on the gate and the edge after it. Clause: OPER-EULER-3."""
    a, _, *rest = loop
    return (a, *rest)


def past_previous(loop: Sequence[V]) -> tuple[V, ...]:
    """The loop after a triangle on the edge before the gate and the gate. Clause: OPER-EULER-3."""
    _, b, *rest, last = loop
    return (last, b, *rest)


def cut(loop: Sequence[V], at: int) -> tuple[tuple[V, ...], tuple[V, ...]]:
    """The loops after a triangle from the gate to vertex `at` of the same loop.

    First the one with the first vertex of the gate. Clause: OPER-SURFACE-5.
    """
    return (loop[0], *loop[at:]), (loop[at], *loop[1:at])


def joined(loop: Sequence[V], other: Sequence[V]) -> tuple[V, ...]:
    """The loop after a triangle from a gate to the first vertex of another loop.

    Clauses: OPER-SURFACE-4, OPER-SURFACE-6.
    """
    a, b, *rest = loop
    return (other[0], b, *rest, a, *other)
