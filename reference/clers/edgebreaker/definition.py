"""The definition of decoding: a fold of operators, and of validity: the stream of some surface.

Obvious rather than fast (quadratic): loops are tuples, the operators are found by undoing the word.
"""

from dataclasses import dataclass

from clers.complexes.corner_table import surface as surface_of
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected, and_then
from clers.conventions.where import AtRecord, AtSymbol
from clers.edgebreaker.encode import encode
from clers.edgebreaker.outline import Outline, Part, outline
from clers.edgebreaker.stream import Kind, Stream
from clers.operators.handles import (
    NOTHING,
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

Edges = tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Branch:
    """What is decoded behind one gate: its loop, gate first, and loops cut off and still open."""

    loop: Edges
    others: tuple[tuple[int, Edges], ...]  # the symbol that cut a loop off, and the loop


@dataclass(frozen=True, slots=True)
class Upper:
    """An upper handle whose loop is known by the symbol that pushed it, not yet by its depth."""

    pushed_by: int
    at: int


Step = tuple[Operator, ...]


def steps(stream: Stream) -> Accepted[tuple[Step, ...]] | Rejected:
    """The operators of each face in creation order; first-curve polygons go with the first face.

    Clauses: EB-FOLD-1, EB-FOLD-2. Not every stream with steps is valid: see `decode_by_fold`.
    """
    return and_then(outline(stream), _steps)


def _steps(outlined: Outline) -> Accepted[tuple[Step, ...]] | Rejected:
    result: list[Step] = []
    for part in outlined.parts:
        found = _undo(outlined, part)
        if isinstance(found, Rejected):
            return found
        first, draft = found
        if part.closed:
            result.append((ZeroHandle(),))
        opening: Step = () if part.closed else (ZeroHandlePolygon(len(first)),)
        by_depth = _by_depth(part, draft)
        if isinstance(by_depth, Rejected):
            return by_depth
        for step in by_depth:
            result.append((*opening, *step))
            opening = ()
    return Accepted(tuple(result))


Draft = dict[int, Step | Upper]


def _undo(outlined: Outline, part: Part) -> tuple[Edges, Draft] | Rejected:
    """Read the component backwards: the first loop, and an operator for each symbol."""
    word = outlined.stream.word
    branches: list[Branch] = []
    draft: Draft = {}
    for i in range(part.stop - 1, part.start - 1, -1):
        gate = 3 * outlined.face[i]
        right, left = gate + 1, gate + 2
        if word[i] == "E":
            branches.append(Branch((gate, right, left), ()))
            draft[i] = (TwoHandle(),)
            continue
        here = branches.pop()
        rest, others = here.loop[1:], here.others
        if word[i] == "R":
            branches.append(Branch((gate, right, *rest), others))
            draft[i] = (CompleteAfter(),)
        elif word[i] == "L":
            branches.append(Branch((gate, *rest, left), others))
            draft[i] = (CompleteBefore(),)
        elif word[i] == "C":
            branches.append(Branch((gate, *rest[:-1]), others))
            draft[i] = (Attach(),)
        elif outlined.record_of[i] < 0:
            other = branches.pop()
            loop = (gate, *rest, *other.loop[1:])
            branches.append(Branch(loop, (*others, *other.others)))
            draft[i] = (LowerHandle(len(rest) + 1),)
        else:
            undone = _undo_recorded(outlined, i, here, draft)
            if isinstance(undone, Rejected):
                return undone
            branches.append(undone)
    return branches[0].loop, draft


def _undo_recorded(outlined: Outline, i: int, here: Branch, draft: Draft) -> Branch | Rejected:
    """Undo an S whose left edge is an edge of a loop of the same branch. Clause: EB-FOLD-2."""
    gate, r = 3 * outlined.face[i], outlined.record_of[i]
    left, kind = outlined.glue[r], outlined.stream.records[r].kind
    rest = here.loop[1:]
    if left in rest:
        k = rest.index(left)
        cut = rest[k + 1 :]
        if kind is Kind.BOUNDARY:
            draft[i] = (ZeroHandlePolygon(len(cut)), OneHandle())
            return Branch((gate, *rest[:k]), here.others)
        return Branch((gate, *rest[:k]), (*here.others, (i, cut)))
    for cut_by, loop in here.others:
        if left in loop and kind is Kind.HANDLE:
            k = loop.index(left)
            draft[i] = (LowerHandle(len(rest) + 1),)
            draft[cut_by] = Upper(i, (len(loop) - k) % len(loop))
            others = tuple(o for o in here.others if o[0] != cut_by)
            return Branch((gate, *rest, *loop[k + 1 :], *loop[:k]), others)
    detail = "its closing edge is on no loop of its right branch"
    return Rejected(Reason.RECORD_OUTSIDE_BRANCH, Clause.EB_GRAMMAR_6, AtRecord(r), detail)


def _by_depth(part: Part, draft: Draft) -> list[Step] | Rejected:
    """Say by its depth in the stack which loop an upper handle goes to."""
    pushed: list[int] = []  # the symbols that pushed the loops below the current one
    result: list[Step] = []
    for i in range(part.start, part.stop):
        match draft.get(i):
            case Upper(pushed_by, at) if pushed_by in pushed:
                result.append((UpperHandle(len(pushed) - pushed.index(pushed_by), at),))
                pushed.remove(pushed_by)
            case Upper() | None:
                detail = "the loop that this S cuts off is never closed"
                return Rejected(Reason.LOOP_NOT_CLOSED, Clause.EB_GRAMMAR_8, AtSymbol(i), detail)
            case step:
                result.append(step)
                if isinstance(step[0], LowerHandle):
                    pushed.append(i)
                elif isinstance(step[0], TwoHandle) and pushed:
                    pushed.pop()
    return result


def fold(operators: tuple[Step, ...]) -> Accepted[tuple[Growing, ...]] | Rejected:
    """The growing surface after each face: `scanl apply nothing`.

    Clauses: EB-FOLD-1, EB-FOLD-3, EB-FOLD-4.
    """
    grown, states = NOTHING, list[Growing]()
    for i, step in enumerate(operators):
        for operator in step:
            applied = apply(operator, grown)
            if isinstance(applied, Rejected):
                detail = f"face {i}: {applied.detail}"
                return Rejected(applied.reason, applied.clause, AtSymbol(i), detail)
            grown = applied.value
        states.append(grown)
    return Accepted(tuple(states))


def decode_by_fold(stream: Stream) -> Accepted[Surface] | Rejected:
    """The definition of decoding, valid streams being those whose result has this very stream.

    Quadratic. Clauses: EB-DECODE-1, EB-DECODE-2, EB-FOLD-1.
    """
    return and_then(and_then(steps(stream), fold), lambda states: _same_again(stream, states))


def _same_again(stream: Stream, states: tuple[Growing, ...]) -> Accepted[Surface] | Rejected:
    last = states[-1]
    if last.loops:
        detail = f"{len(last.loops)} loops are left open"
        return Rejected(Reason.LOOP_NOT_CLOSED, Clause.EB_GRAMMAR_8, detail=detail)
    built = surface_of(FaceList(last.faces, last.vertices))
    if isinstance(built, Rejected):
        return Rejected(Reason.DOUBLE_EDGE, Clause.EB_GRAMMAR_9, detail=built.line())
    if encode(built.value).stream != stream:
        detail = "the surface so built has another stream"
        return Rejected(Reason.DOUBLE_EDGE, Clause.EB_GRAMMAR_9, detail=detail)
    return built
