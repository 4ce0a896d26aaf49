"""The walk as pictures tell it: who is visited when, and which gates wait at each moment."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Final

from clers.complexes.surface import (
    BORDER,
    Corner,
    Face,
    Surface,
    Triangle,
    Vertex,
    previous_corner,
)
from clers.edgebreaker.outline import Outline
from clers.edgebreaker.stream import Encoding, Kind, Record
from clers.edgebreaker.trace import Entry, trace
from clers.pictures.palette import Letter


@dataclass(frozen=True, slots=True)
class Visit:
    """One face of the walk: the `step`-th to be visited, counted from 1.

    `tip` is the corner opposite to the gate; `triangle` starts there; `names` has the same vertices
    in the mesh's own order. `entry` is the trace's word on it.
    """

    step: int
    letter: Letter
    face: Face
    tip: Corner
    triangle: Triangle
    names: Triangle
    entry: Entry


@dataclass(frozen=True, slots=True)
class Moment:
    """The walk after `step` faces. Clause: TOOL-PICTURE-1.

    `gate` is the gate to be entered next, as its tip; `waiting` are those on the stack whose
    triangles are not visited, the top last; `known` are the vertices marked or reached; `morse` has
    both corners opposite to the left edge of each S with a record that was met from behind.
    """

    step: int
    gate: Corner | None
    waiting: tuple[Corner, ...]
    known: frozenset[Vertex]
    morse: frozenset[Corner]


@dataclass(frozen=True, slots=True)
class Story:
    """The whole walk. `closed_at` has for each S with a record the step that visits the closing
    triangle, by the S's tip; `crossed` has both corners of each edge of the dual trees; `step_of`
    is by face.
    """

    surface: Surface
    visits: tuple[Visit, ...]
    components: tuple[tuple[Corner, ...], ...]
    closed_at: dict[Corner, int]
    records: tuple[Record, ...]
    crossed: frozenset[Corner]
    step_of: tuple[int, ...]


def story(surface: Surface, encoding: Encoding, outlined: Outline) -> Story:
    """Read the walk. Linear. Clauses: EB-TRACE-1, EB-REMAINDER-1."""
    tips = encoding.tip_order
    entries = trace(surface, encoding, outlined)
    visits = tuple(
        Visit(
            step=made + 1,
            letter=_letter(entry, outlined),
            face=Face(entry.face),
            tip=tips[made],
            triangle=entry.triangle,
            names=surface.triangle(Face(entry.face)),
            entry=entry,
        )
        for made, entry in enumerate(entries)
    )
    splits = (i for i, record in enumerate(outlined.record_of) if record >= 0)
    closed_at = {
        tips[outlined.face[i]]: outlined.glue[outlined.record_of[i]] // 3 + 1 for i in splits
    }
    parts = tuple(tips[part.face : part.first + part.stop - part.start] for part in outlined.parts)
    gates = [visit.tip for visit in visits if visit.letter is not Letter.P]
    inner = [tip for tip in gates if surface.opposite[tip] != BORDER]
    crossed = frozenset(inner) | {surface.opposite[tip] for tip in inner}
    step_of = [0] * surface.faces
    for visit in visits:
        step_of[visit.face] = visit.step
    records = outlined.stream.records
    return Story(surface, visits, parts, closed_at, records, crossed, tuple(step_of))


def moments(told: Story, steps: Iterable[int]) -> tuple[Moment, ...]:
    """The walk at some steps, each from 0 to the number of faces. Linear, plus what is answered."""
    wanted: Final = set(steps)
    opposite = told.surface.opposite
    stack: list[Corner] = []
    known: set[Vertex] = set()
    found: dict[int, Moment] = {}
    for step in range(len(told.visits) + 1):
        if step > 0:
            visit = told.visits[step - 1]
            known.update(visit.entry.new)
            if visit.entry.symbol == "S":
                stack.append(opposite[previous_corner(visit.tip)])
            elif visit.entry.symbol == "E":
                while stack and told.step_of[stack.pop() // 3] <= step:
                    pass
        if step in wanted:
            met = [previous_corner(tip) for tip, at in told.closed_at.items() if at <= step]
            found[step] = Moment(
                step=step,
                gate=_gate(told, step),
                waiting=tuple(c for c in stack if told.step_of[c // 3] > step),
                known=frozenset(known),
                morse=frozenset(met) | {opposite[c] for c in met},
            )
    return tuple(found[step] for step in sorted(wanted))


def _gate(told: Story, step: int) -> Corner | None:
    """The next visit's gate; P has none, and after the last face there is none."""
    if step == len(told.visits) or told.visits[step].letter is Letter.P:
        return None
    return told.visits[step].tip


def _letter(entry: Entry, outlined: Outline) -> Letter:
    """The two kinds of S with a record are told apart. Clause: EB-HANDLE-2."""
    if entry.opens < 0:
        return Letter(entry.symbol)
    boundary = outlined.stream.records[entry.opens].kind is Kind.BOUNDARY
    return Letter.SB if boundary else Letter.SH
