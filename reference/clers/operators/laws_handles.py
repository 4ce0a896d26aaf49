"""The laws of handle operators: what each makes, what it needs, and what a recount finds."""

from collections import Counter
from typing import Final, assert_never

from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw, Law, every, same
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.verdict import Fails, Holds, Verdict
from clers.conventions.where import WHOLE
from clers.operators.given_handles import GROWING, HANDLE_STEPS, HandleStep, in_reach
from clers.operators.handle_table import change, row
from clers.operators.handles import (
    Attach,
    CompleteAfter,
    CompleteBefore,
    Growing,
    LowerHandle,
    OneHandle,
    Operator,
    TwoHandle,
    UpperHandle,
    ZeroHandle,
    ZeroHandlePolygon,
    apply,
)
from clers.operators.laws_handle_shapes import LAWS as SHAPES


def _effect(step: HandleStep) -> Verdict:
    """Faces, vertices, χ, genus, loops and components change as the table says."""
    return every(
        *(
            same(row(operator), change(step.before, after.value))
            for operator in in_reach(step)
            for after in (apply(operator, step.before),)
            if isinstance(after, Accepted)
        )
    )


def broken(before: Growing, operator: Operator) -> frozenset[Clause]:
    """The clauses whose needs are not met; none where the operator applies."""
    loops = before.loops
    if before.waiting and not isinstance(operator, OneHandle):
        return frozenset({Clause.OPER_HANDLE_7})
    current = len(loops[-1]) if loops else 0
    needs: dict[Clause, bool]
    match operator:
        case ZeroHandle():
            needs = {Clause.OPER_HANDLE_1: not loops}
        case ZeroHandlePolygon(edges):
            needs = {Clause.OPER_HANDLE_2: edges >= 3}
        case Attach():
            needs = {Clause.OPER_HANDLE_9: current > 0}
        case CompleteAfter() | CompleteBefore():
            needs = {Clause.OPER_HANDLE_9: current > 0, Clause.OPER_HANDLE_4: current >= 4}
        case LowerHandle(at):
            fits = 3 <= at <= current - 2
            needs = {Clause.OPER_HANDLE_9: current > 0, Clause.OPER_HANDLE_5: fits}
        case UpperHandle(below, at):
            there = 0 < below < len(loops) and 0 <= at < len(loops[-1 - below])
            needs = {Clause.OPER_HANDLE_6: there}
        case OneHandle():
            needs = {Clause.OPER_HANDLE_7: before.waiting}
        case TwoHandle():
            needs = {Clause.OPER_HANDLE_9: current > 0, Clause.OPER_HANDLE_8: current == 3}
        case _:
            assert_never(operator)
    return frozenset(clause for clause, met in needs.items() if not met)


def _refused(before: Growing, operator: Operator) -> Verdict:
    faults = broken(before, operator)
    match apply(operator, before):
        case Accepted():
            return same(frozenset(), faults)
        case Rejected(Reason.OPERATOR_NOT_APPLICABLE, clause):
            return Holds() if clause in faults else Fails(repr(sorted(faults)), clause, WHOLE)
        case Rejected() as other:
            return Fails(Reason.OPERATOR_NOT_APPLICABLE, other.line(), WHOLE)


def _refusal(step: HandleStep) -> Verdict:
    """An operator applies exactly if its needs are met, and the clause of one is named if not.

    Judged again with a new polygon on the stack, where nothing but the 1-handle may follow.
    """
    pushed = apply(ZeroHandlePolygon(3), step.before)
    steps = (
        (step, HandleStep(pushed.value, step.operator)) if isinstance(pushed, Accepted) else (step,)
    )
    return every(*(_refused(s.before, operator) for s in steps for operator in in_reach(s)))


def recounted_euler(grown: Growing) -> int:
    """χ, counted from faces, infinite faces and loops alone. Clause: OPER-GROW-1.

    Each side of an edge belongs to a face, to an infinite face, or to a loop.
    """
    drawn = (*grown.faces, *grown.polygons)
    seen = {v for cell in (*drawn, *grown.loops) for v in cell}
    sides = sum(len(cell) for cell in (*drawn, *grown.loops))
    return len(seen) - sides // 2 + len(drawn)


def recounted_components(grown: Growing) -> int:
    """The parts of faces and infinite faces that no vertex joins. Clause: OPER-GROW-1."""
    parts: list[set[int]] = []
    for cell in (*grown.faces, *grown.polygons):
        joined = {int(v) for v in cell}
        for part in [part for part in parts if not part.isdisjoint(cell)]:
            joined |= part
            parts.remove(part)
        parts.append(joined)
    return len(parts)


def _recounted(grown: Growing) -> Verdict:
    """χ and components are those of a recount, and the genus is what the loops leave over."""
    euler, components = recounted_euler(grown), recounted_components(grown)
    return every(
        same(euler, grown.euler),
        same(components, grown.components),
        same(2 * components - euler - len(grown.loops), 2 * grown.genus),
        same(set(range(grown.vertices)), {v for cell in _cells(grown) for v in cell}),
    )


def _cells(grown: Growing) -> tuple[tuple[int, ...], ...]:
    return (*grown.faces, *grown.polygons)


def _bounded(grown: Growing) -> Verdict:
    """Faces, infinite faces turned over and loops have no boundary together, as chains of edges."""
    chain: Counter[tuple[int, int]] = Counter()
    turned = [tuple(reversed(polygon)) for polygon in grown.polygons]
    for cycle in (*grown.faces, *turned, *grown.loops):
        for tail, head in zip(cycle, (*cycle[1:], cycle[0]), strict=True):
            chain[tail, head] += 1
            chain[head, tail] -= 1
    return same({}, {edge: times for edge, times in chain.items() if times > 0})


def _long_enough(grown: Growing) -> Verdict:
    """No loop and no infinite face has fewer than three edges."""
    return same((), tuple(c for c in (*grown.loops, *grown.polygons) if len(c) < 3))


LAWS: Final[tuple[AnyLaw, ...]] = (
    Law(
        "handle-effect-in-table",
        Clause.OPER_EFFECT_1,
        "An operator that applies changes the numbers of the growing surface as the table says.",
        HANDLE_STEPS,
        _effect,
    ),
    Law(
        "handle-refusal-by-need",
        Clause.OPER_HANDLE_9,
        "An operator applies exactly if its needs are met, and is rejected by one that is not.",
        HANDLE_STEPS,
        _refusal,
    ),
    Law(
        "growing-numbers-recounted",
        Clause.OPER_GROW_1,
        "χ and components are those counted from faces and loops, and χ = 2c − 2g − #loops.",
        GROWING,
        _recounted,
    ),
    Law(
        "growing-loops-bound",
        Clause.OPER_GROW_1,
        "The loops are the boundary of what is built, run with the missing part on the left.",
        GROWING,
        _bounded,
    ),
    Law(
        "growing-loops-long-enough",
        Clause.OPER_GROW_1,
        "Every loop has three edges at least.",
        GROWING,
        _long_enough,
    ),
    *SHAPES,
)
