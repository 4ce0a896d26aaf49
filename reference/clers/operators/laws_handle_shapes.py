"""The laws of the face that each handle operator makes and the loops that it leaves.

Each law tries its operator with every choice that the growing surface offers, so that none of them
holds for want of the right operator.
"""

from typing import Final

from clers.complexes.surface import Triangle, Vertex
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Holds, Verdict
from clers.operators.given_handles import GROWING
from clers.operators.handles import (
    Attach,
    CompleteAfter,
    CompleteBefore,
    Growing,
    Loop,
    LowerHandle,
    OneHandle,
    Operator,
    TwoHandle,
    UpperHandle,
    ZeroHandle,
    ZeroHandlePolygon,
    apply,
)


def _leaves(
    grown: Growing, operator: Operator, faces: tuple[Triangle, ...], loops: tuple[Loop, ...]
) -> Verdict:
    """Where it applies, the operator adds these faces, and the loops are these."""
    match apply(operator, grown):
        case Accepted(after):
            return every(same((*grown.faces, *faces), after.faces), same(loops, after.loops))
        case Rejected():
            return Holds()


def _new(grown: Growing, count: int) -> tuple[Vertex, ...]:
    return tuple(Vertex(grown.vertices + i) for i in range(count))


def _zero_handle(grown: Growing) -> Verdict:
    p, q, r = _new(grown, 3)
    return _leaves(grown, ZeroHandle(), ((p, q, r),), ((r, q, p),))


def _polygon(grown: Growing) -> Verdict:
    rings = [_new(grown, edges) for edges in range(3, 7)]
    return every(
        *(_leaves(grown, ZeroHandlePolygon(len(r)), (), (*grown.loops, r)) for r in rings),
        *(
            same((*grown.polygons, r), after.value.polygons)
            for r in rings
            for after in (apply(ZeroHandlePolygon(len(r)), grown),)
            if isinstance(after, Accepted)
        ),
    )


def _attachment(grown: Growing) -> Verdict:
    if not grown.loops:
        return Holds()
    *below, (a, b, *x) = grown.loops
    (v,) = _new(grown, 1)
    return _leaves(grown, Attach(), ((v, a, b),), (*below, (v, b, *x, a)))


def _completing(grown: Growing) -> Verdict:
    if not grown.loops:
        return Holds()
    *below, (a, b, *x) = grown.loops
    first, last = x[0], x[-1]
    return every(
        _leaves(grown, CompleteAfter(), ((first, a, b),), (*below, (a, *x))),
        _leaves(grown, CompleteBefore(), ((last, a, b),), (*below, (last, b, *x[:-1]))),
    )


def _lower(grown: Growing) -> Verdict:
    if not grown.loops:
        return Holds()
    *below, loop = grown.loops
    a, b = loop[:2]
    return every(
        *(
            _leaves(
                grown,
                LowerHandle(j),
                ((loop[j], a, b),),
                (*below, (a, *loop[j:]), (loop[j], b, *loop[2:j])),
            )
            for j in range(2, len(loop))
        )
    )


def _spliced(loop: Loop, other: Loop, j: int) -> Loop:
    """The one loop that a triangle from the gate of the first to vertex j of the other leaves."""
    a, b, *x = loop
    around = tuple(other[(j + i) % len(other)] for i in range(len(other)))
    return (other[j], b, *x, a, *around)


def _upper(grown: Growing) -> Verdict:
    if not grown.loops:
        return Holds()
    *others, loop = grown.loops
    a, b = loop[:2]
    return every(
        *(
            _leaves(
                grown,
                UpperHandle(len(others) - k, j),
                ((other[j], a, b),),
                (*others[:k], *others[k + 1 :], _spliced(loop, other, j)),
            )
            for k, other in enumerate(others)
            for j in range(len(other))
        )
    )


def _one_handle(grown: Growing) -> Verdict:
    """To a polygon that is pushed for the purpose, over the current loop."""
    pushed = apply(ZeroHandlePolygon(4), grown)
    if not grown.loops or isinstance(pushed, Rejected):
        return Holds()
    *below, loop, polygon = pushed.value.loops
    face = (polygon[0], loop[0], loop[1])
    return _leaves(pushed.value, OneHandle(), (face,), (*below, _spliced(loop, polygon, 0)))


def _two_handle(grown: Growing) -> Verdict:
    if not grown.loops:
        return Holds()
    *below, (a, b, *x) = grown.loops
    return _leaves(grown, TwoHandle(), ((x[0], a, b),), tuple(below))


LAWS: Final[tuple[AnyLaw, ...]] = tuple(
    Law(name, clause, statement, GROWING, holds)
    for name, clause, statement, holds in (
        (
            "zero-handle-begins",
            Clause.OPER_HANDLE_1,
            "The 0-handle makes (p, q, r) of new vertices and the loop [r, q, p].",
            _zero_handle,
        ),
        (
            "zero-handle-polygon",
            Clause.OPER_HANDLE_2,
            "The 0-handle with a polygon makes and pushes an infinite face of new vertices.",
            _polygon,
        ),
        (
            "attachment-at-gate",
            Clause.OPER_HANDLE_3,
            "Attachment makes (v, a, b) and the loop [v, b, x₂, …, a].",
            _attachment,
        ),
        (
            "completing-at-gate",
            Clause.OPER_HANDLE_4,
            "Completing makes the face of the gate and the edge after it, or before it.",
            _completing,
        ),
        (
            "lower-handle-cuts",
            Clause.OPER_HANDLE_5,
            "The lower 1-handle at j cuts the loop at its vertex j.",
            _lower,
        ),
        (
            "upper-handle-joins",
            Clause.OPER_HANDLE_6,
            "The upper 1-handle makes one loop of two.",
            _upper,
        ),
        (
            "one-handle-joins-polygon",
            Clause.OPER_HANDLE_7,
            "The 1-handle between components goes to the first vertex of a new polygon.",
            _one_handle,
        ),
        (
            "two-handle-closes",
            Clause.OPER_HANDLE_8,
            "The 2-handle closes the loop of three edges and takes it from the stack.",
            _two_handle,
        ),
    )
)
