"""Handle operators and Euler attachments on a surface that grows: section 6(b) of the tutorial.

The surface is seen through its boundary. Each loop is a cyclic list of vertices, run with the part
still missing on its left, and begins with the gate: the edge from its first vertex to its second.
Every operator acts at the gate of the current loop, which is the last one on the stack. What it
does to loops is `sheets.surgery`, for it is an operator on sheets (OPER-SHEET-7).
"""

from dataclasses import dataclass, replace
from typing import Final, assert_never

from clers.complexes.surface import Triangle, Vertex
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.operators.sheets.surgery import beyond, cut, joined, past_next, past_previous

Loop = tuple[Vertex, ...]

SHORTEST_LOOP: Final = 3
"""No loop in a simplicial complex has fewer edges."""


@dataclass(frozen=True, slots=True)
class ZeroHandle:
    """χ+1: a new component, one triangle; the gate is across its first edge. OPER-HANDLE-1."""


@dataclass(frozen=True, slots=True)
class ZeroHandlePolygon:
    """χ+1: a new component, one polygon of `edges` edges (an infinite face). OPER-HANDLE-2."""

    edges: int


@dataclass(frozen=True, slots=True)
class Attach:
    """χ+0: a triangle on the gate with a new vertex: MEV and MTE. OPER-HANDLE-3."""


@dataclass(frozen=True, slots=True)
class CompleteAfter:
    """χ+0: a triangle on the gate and the edge after it: MTE. OPER-HANDLE-4."""


@dataclass(frozen=True, slots=True)
class CompleteBefore:
    """χ+0: a triangle on the edge before the gate and the gate: MTE. OPER-HANDLE-4."""


@dataclass(frozen=True, slots=True)
class LowerHandle:
    """χ-1, b+1: a triangle from the gate to vertex `at` of the same loop. OPER-HANDLE-5."""

    at: int


@dataclass(frozen=True, slots=True)
class UpperHandle:
    """χ-1, b-1, g+1: a triangle from the gate to vertex `at` of the loop `below` levels down.

    Clause: OPER-HANDLE-6.
    """

    below: int
    at: int


@dataclass(frozen=True, slots=True)
class OneHandle:
    """χ-1, a component less: a triangle from the gate to a new polygon's first vertex.

    Clause: OPER-HANDLE-7.
    """


@dataclass(frozen=True, slots=True)
class TwoHandle:
    """χ+1, b-1: a triangle closes a loop of three edges. OPER-HANDLE-8."""


Operator = (
    ZeroHandle
    | ZeroHandlePolygon
    | Attach
    | CompleteAfter
    | CompleteBefore
    | LowerHandle
    | UpperHandle
    | OneHandle
    | TwoHandle
)


@dataclass(frozen=True, slots=True)
class Growing:
    """A surface under construction. Clause: OPER-GROW-1.

    `faces` in order of creation, each (apex, left end, right end); `polygons` the infinite faces;
    `loops` the boundary of the component being built, current one last; χ and genus are kept by
    the operators' effects and never recounted here. `waiting`: the last loop is a polygon just made
    over another loop, of another component until the 1-handle joins them; nothing else may act.
    """

    faces: tuple[Triangle, ...] = ()
    polygons: tuple[Loop, ...] = ()
    vertices: int = 0
    loops: tuple[Loop, ...] = ()
    components: int = 0
    euler: int = 0
    genus: int = 0
    waiting: bool = False


NOTHING: Final = Growing()


def apply(operator: Operator, grown: Growing) -> Accepted[Growing] | Rejected:
    """One operator on a growing surface. Total. Clauses: OPER-HANDLE-1 … OPER-HANDLE-9."""
    if grown.waiting and not isinstance(operator, OneHandle):
        return _refused(Clause.OPER_HANDLE_7, "a new polygon over another loop waits")
    match operator:
        case ZeroHandle():
            return _zero_handle(grown)
        case ZeroHandlePolygon(edges):
            return _zero_handle_polygon(grown, edges)
        case OneHandle():
            return _one_handle(grown)
        case UpperHandle(below, at):
            return _upper_handle(grown, below, at)
        case Attach() | CompleteAfter() | CompleteBefore() | LowerHandle() | TwoHandle():
            return _on_current_loop(operator, grown)
        case _:
            assert_never(operator)


def _refused(clause: Clause, detail: str) -> Rejected:
    return Rejected(Reason.OPERATOR_NOT_APPLICABLE, clause, detail=detail)


def _zero_handle(grown: Growing) -> Accepted[Growing] | Rejected:
    """A component is begun only when the one before it is finished, for gates do not wait."""
    if grown.loops:
        return _refused(Clause.OPER_HANDLE_1, "the component before is not finished")
    n = grown.vertices
    p, q, r = Vertex(n), Vertex(n + 1), Vertex(n + 2)
    return Accepted(
        replace(
            grown,
            faces=(*grown.faces, (p, q, r)),
            vertices=n + 3,
            loops=((r, q, p),),
            components=grown.components + 1,
            euler=grown.euler + 1,
        )
    )


def _zero_handle_polygon(grown: Growing, edges: int) -> Accepted[Growing] | Rejected:
    if edges < SHORTEST_LOOP:
        return _refused(Clause.OPER_HANDLE_2, f"a polygon of {edges} edges")
    polygon = tuple(Vertex(v) for v in range(grown.vertices, grown.vertices + edges))
    return Accepted(
        replace(
            grown,
            polygons=(*grown.polygons, polygon),
            vertices=grown.vertices + edges,
            loops=(*grown.loops, polygon),
            components=grown.components + 1,
            euler=grown.euler + 1,
            waiting=bool(grown.loops),
        )
    )


def _one_handle(grown: Growing) -> Accepted[Growing] | Rejected:
    if not grown.waiting:
        return _refused(
            Clause.OPER_HANDLE_7, "the last loop is not a new polygon over another loop"
        )
    *below, loop, polygon = grown.loops
    return Accepted(
        replace(
            grown,
            faces=(*grown.faces, (polygon[0], loop[0], loop[1])),
            loops=(*below, joined(loop, polygon)),
            components=grown.components - 1,
            euler=grown.euler - 1,
            waiting=False,
        )
    )


def _upper_handle(grown: Growing, below: int, at: int) -> Accepted[Growing] | Rejected:
    if not 1 <= below < len(grown.loops):
        return _refused(
            Clause.OPER_HANDLE_6, f"loop {below} below, {len(grown.loops)} on the stack"
        )
    k = len(grown.loops) - 1 - below
    other, loop = grown.loops[k], grown.loops[-1]
    if not 0 <= at < len(other):
        return _refused(Clause.OPER_HANDLE_6, f"vertex {at} of a loop of {len(other)}")
    turned = (*other[at:], *other[:at])
    return Accepted(
        replace(
            grown,
            faces=(*grown.faces, (turned[0], loop[0], loop[1])),
            loops=(*grown.loops[:k], *grown.loops[k + 1 : -1], joined(loop, turned)),
            euler=grown.euler - 1,
            genus=grown.genus + 1,
        )
    )


def _on_current_loop(
    operator: Attach | CompleteAfter | CompleteBefore | LowerHandle | TwoHandle, grown: Growing
) -> Accepted[Growing] | Rejected:
    """The operators that need the current loop only."""
    if not grown.loops:
        return _refused(Clause.OPER_HANDLE_9, "there is no gate")
    *below, loop = grown.loops
    match operator:
        case Attach():
            v = Vertex(grown.vertices)
            grown = replace(grown, vertices=grown.vertices + 1)
            return _glued(grown, v, loop, (*below, beyond(loop, v)))
        case CompleteAfter():
            if len(loop) <= SHORTEST_LOOP:
                return _refused(
                    Clause.OPER_HANDLE_4, "a loop of three edges is closed by a 2-handle"
                )
            return _glued(grown, loop[2], loop, (*below, past_next(loop)))
        case CompleteBefore():
            if len(loop) <= SHORTEST_LOOP:
                return _refused(
                    Clause.OPER_HANDLE_4, "a loop of three edges is closed by a 2-handle"
                )
            return _glued(grown, loop[-1], loop, (*below, past_previous(loop)))
        case LowerHandle(at):
            if not SHORTEST_LOOP <= at <= len(loop) + 1 - SHORTEST_LOOP:
                return _refused(Clause.OPER_HANDLE_5, f"vertex {at} of a loop of {len(loop)}")
            grown = replace(grown, euler=grown.euler - 1)
            return _glued(grown, loop[at], loop, (*below, *cut(loop, at)))
        case TwoHandle():
            if len(loop) != SHORTEST_LOOP:
                return _refused(Clause.OPER_HANDLE_8, f"the loop has {len(loop)} edges")
            return _glued(replace(grown, euler=grown.euler + 1), loop[2], loop, tuple(below))
        case _:
            assert_never(operator)


def _glued(grown: Growing, apex: Vertex, loop: Loop, loops: tuple[Loop, ...]) -> Accepted[Growing]:
    """Put the triangle from the gate of `loop` to the apex; the loops are then `loops`."""
    face = (apex, loop[0], loop[1])
    return Accepted(replace(grown, faces=(*grown.faces, face), loops=loops))
