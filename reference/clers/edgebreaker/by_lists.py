"""Unwinding with plain lists: each step of two decoders as their clauses word it.

Obvious rather than fast (quadratic). The fast decoders do the same in linked lists; laws compare.
Edges are corners of the decoded surface: 3f is the gate of face f, 3f + 1 its right edge, 3f + 2
its left edge.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from clers.edgebreaker.outline import Outline, Part
from clers.edgebreaker.stream import Kind

Edge = int
Loop = tuple[Edge, ...]
Pair = tuple[Edge, Edge]

GATE: Final[Edge] = -2
"""The first gate of a component with boundary, as the infinite face has it."""

INFINITE: Final[Edge] = -1
"""All other edges of the infinite face of the first curve, whose number is not known yet."""


@dataclass(frozen=True, slots=True)
class Undone:
    """One step of Spirale Reversi. Clauses: EB-REVERSI-1, EB-REVERSI-2, EB-REVERSI-3.

    `symbol`: its place in the word, -1 for the beginning of a component; `glued`: the pairs of
    edges that become one; `loops`: the stack afterwards, the current loop first, each from its
    gate; `beside`: loops with a waiting edge; `curves`: boundary curves found in this component.
    """

    symbol: int
    glued: tuple[Pair, ...]
    loops: tuple[Loop, ...]
    beside: tuple[Loop, ...]
    curves: tuple[Loop, ...]


@dataclass(slots=True)
class _Region:
    """The loops of one component while its symbols are undone; the current one is the last."""

    stack: list[Loop]
    beside: list[Loop]
    curves: list[Loop]


def undone(outlined: Outline) -> tuple[Undone, ...]:
    """Every step from the last symbol to the first, of a stream that is known to be valid.

    Clauses: EB-REVERSI-1 … EB-REVERSI-3.
    """
    steps: list[Undone] = []
    for part in reversed(outlined.parts):
        region = _Region([], [], [])
        for i in range(part.stop - 1, part.start - 1, -1):
            steps.append(_kept(i, _undo(outlined, i, region), region))
        loop = region.stack.pop()
        if part.closed:
            p = 3 * part.face
            steps.append(_kept(-1, tuple(zip(loop, (p, p + 2, p + 1), strict=True)), region))
        else:
            region.curves.append(loop)
            steps.append(_kept(-1, (), region))
    return tuple(steps)


def _kept(symbol: int, glued: tuple[Pair, ...], region: _Region) -> Undone:
    loops = tuple(reversed(region.stack))
    return Undone(symbol, glued, loops, tuple(region.beside), tuple(region.curves))


def _undo(outlined: Outline, i: int, region: _Region) -> tuple[Pair, ...]:
    """One row of the table of EB-REVERSI-2."""
    gate = 3 * outlined.face[i]
    right, left = gate + 1, gate + 2
    if outlined.stream.word[i] == "E":
        region.stack.append((gate, right, left))
        return ()
    first, *rest = region.stack.pop()
    match outlined.stream.word[i]:
        case "R":
            region.stack.append((gate, right, *rest))
            return ((left, first),)
        case "L":
            region.stack.append((gate, *rest, left))
            return ((right, first),)
        case "C":
            region.stack.append((gate, *rest[:-1]))
            return ((right, first), (left, rest[-1]))
        case _:
            waiting = _unite(outlined, i, gate, rest, region)
            return ((right, first), (left, waiting))


def _unite(outlined: Outline, i: int, gate: Edge, rest: list[Edge], region: _Region) -> Edge:
    """The rows of S; the answer is the edge that the left edge is glued to."""
    r = outlined.record_of[i]
    if r < 0:
        other, *more = region.stack.pop()
        region.stack.append((gate, *rest, *more))
        return other
    waiting = outlined.glue[r]
    if waiting in rest:
        k = rest.index(waiting)
        curve = outlined.stream.records[r].kind is Kind.BOUNDARY
        (region.curves if curve else region.beside).append(tuple(rest[k + 1 :]))
        region.stack.append((gate, *rest[:k]))
        return waiting
    home = region.stack if any(waiting in loop for loop in region.stack) else region.beside
    loop = next(loop for loop in home if waiting in loop)
    k = loop.index(waiting)
    home.remove(loop)
    region.stack.append((gate, *rest, *loop[k + 1 :], *loop[:k]))
    return waiting


@dataclass(frozen=True, slots=True)
class Wrapped:
    """One step of Wrap and Zip. Clauses: EB-WRAP-1, EB-WRAP-2.

    `symbol`: its place in the word, -1 for P; `glued`: what the triangle is glued to, its gate and
    what the handle data say; `zipped`: the pairs that Zip glues; `border`: the loops of the border
    of what is wrapped of this component, run as the faces run them, each begun anywhere.
    """

    symbol: int
    glued: tuple[Pair, ...]
    zipped: tuple[Pair, ...]
    border: tuple[Loop, ...]


def wrapped(outlined: Outline) -> tuple[Wrapped, ...]:
    """Every step, of a stream that is known to be valid. Clauses: EB-WRAP-1, EB-WRAP-2."""
    steps: list[Wrapped] = []
    of_record = {outlined.record_of[i]: 3 * f + 2 for i, f in enumerate(outlined.face)}
    left_of = {edge: of_record[r] for r, edge in enumerate(outlined.glue)}
    for part in outlined.parts:
        steps += _wrapped(outlined, part, left_of)
    return tuple(steps)


def _wrapped(outlined: Outline, part: Part, left_of: dict[Edge, Edge]) -> list[Wrapped]:
    """The steps of one component; `left_of` is the left edge of the S that a record closes."""
    p = 3 * part.face
    border: list[Loop] = [(p, p + 1, p + 2) if part.closed else (GATE, INFINITE)]
    created, free = {p + 1, p + 2} if part.closed else set[Edge](), set[Edge]()
    gates = [p if part.closed else GATE]
    steps = [Wrapped(-1, (), (), tuple(border))] if part.closed else []
    for i in range(part.start, part.stop):
        tip, gate = 3 * outlined.face[i], gates.pop()
        glued: list[Pair] = [] if gate == GATE else [(tip, gate)]
        border = [_replaced(loop, gate, (tip + 1, tip + 2)) for loop in border]
        match outlined.stream.word[i]:
            case "C":
                created.add(tip + 2)
                gates.append(tip + 1)
                closed: Loop = ()
            case "R":
                closed = (tip + 1,)
                gates.append(tip + 2)
            case "L":
                closed = (tip + 2,)
                gates.append(tip + 1)
            case "E":
                closed = (tip + 2, tip + 1)
            case _:
                closed = ()
                gates += (tip + 1,) if outlined.record_of[i] >= 0 else (tip + 2, tip + 1)
        for edge in closed:
            if edge in left_of:
                glued.append((edge, left_of[edge]))
                border = _without(border, edge, left_of[edge])
            else:
                free.add(edge)
        zipped: list[Pair] = []
        while (found := _fitting(border, free, created)) is not None:
            zipped.append(found)
            border = _without(border, *found)
        steps.append(Wrapped(i, tuple(glued), tuple(zipped), tuple(border)))
    return steps


def _replaced(loop: Loop, edge: Edge, by: Loop) -> Loop:
    k = loop.index(edge) if edge in loop else -1
    return loop if k < 0 else (*loop[:k], *by, *loop[k + 1 :])


def _fitting(border: Sequence[Loop], free: set[Edge], created: set[Edge]) -> Pair | None:
    """Neighbours on the border that Zip glues: the first free, the second created. EB-WRAP-2."""
    for loop in border:
        for first, second in zip(loop, (*loop[1:], loop[0]), strict=True):
            if first in free and second in created:
                return first, second
    return None


def _without(border: Sequence[Loop], one: Edge, other: Edge) -> list[Loop]:
    """The border after two of its edges became one: a loop is cut in two, or two become one."""
    first = next(loop for loop in border if one in loop)
    k = first.index(one)
    after = (*first[k + 1 :], *first[:k])
    rest = [loop for loop in border if loop is not first]
    if other in after:
        j = after.index(other)
        parts: tuple[Loop, ...] = (after[:j], after[j + 1 :])
    else:
        second = next(loop for loop in rest if other in loop)
        j = second.index(other)
        rest = [loop for loop in rest if loop is not second]
        parts = ((*after, *second[j + 1 :], *second[:j]),)
    return [*rest, *(part for part in parts if part)]


@dataclass(frozen=True, slots=True)
class Star:
    """One star that Fast Zip closes: the tip's corner, the faces turned through, what is glued.

    Clause: EB-FAST-1.
    """

    tip: Edge
    turned: tuple[int, ...]
    glued: Pair


def stars(outlined: Outline) -> tuple[Star, ...]:
    """The stars in the order in which Fast Zip closes them. Clauses: EB-WRAP-1, EB-FAST-1."""
    across: dict[Edge, Edge] = {}
    tips: list[Edge] = []
    for step in wrapped(outlined):
        for one, other in step.glued:
            across[one], across[other] = other, one
    for part in outlined.parts:
        if part.closed:
            tips += (3 * part.face, 3 * part.face + 2)
        where = range(part.start, part.stop)
        tips += (3 * outlined.face[i] for i in where if outlined.stream.word[i] == "C")
    found: list[Star] = []
    for tip in reversed(tips):
        corner, turned = tip, list[int]()
        while _next(corner) in across:
            corner = _next(across[_next(corner)])
            turned.append(corner // 3)
        last, left = _next(corner), _next(_next(tip))
        across[last], across[left] = left, last
        found.append(Star(tip, tuple(turned), (last, left)))
    return tuple(found)


def _next(corner: int) -> int:
    return corner - 2 if corner % 3 == 2 else corner + 1
