"""From a walk and a drawing to panels: what is where, at each moment."""

from collections.abc import Iterator
from math import dist
from typing import Final

from clers.complexes.surface import (
    BORDER,
    Corner,
    Surface,
    Vertex,
    face_of,
    next_corner,
    previous_corner,
)
from clers.pictures.caption import caption
from clers.pictures.drawing import Drawing, Point, Ring
from clers.pictures.picture import Edge, Gate, Mark, Note, Panel, Role, Shape, State
from clers.pictures.story import Moment, Story, Visit

ABOVE: Final = tuple(Role)
"""Roles in the order of painting, where no edge hides behind a face."""


def panel(told: Story, drawing: Drawing, now: Moment, tree: bool, labels: bool) -> Panel:
    """One state of the walk. Clauses: TOOL-PICTURE-1, TOOL-PICTURE-2, TOOL-PICTURE-4."""
    visit_of = {visit.face: visit for visit in told.visits}
    shapes = _shapes(told, drawing, now)
    ground: list[Shape | Edge] = []
    above: list[Edge] = []
    for shape in shapes:
        ground.append(shape)
        if not drawing.ribbon:
            edges = _edges(told, drawing, shape, now, tree)
            (ground if drawing.deep else above).extend(edges)
    above.sort(key=lambda edge: ABOVE.index(edge.role))
    waiting = [c for c in (now.gate, *reversed(now.waiting)) if c is not None]
    first = 0 if now.gate is not None else 1
    gates = [
        _gate(told.surface, drawing, visit_of[face_of(c)], i)
        for i, c in enumerate(waiting, first)
        if not drawing.ribbon
    ]
    return Panel(
        step=now.step,
        caption=caption(told, now.step),
        ground=(*ground, *above),
        gates=tuple(reversed(gates)),
        marks=tuple(_marks(told.surface, drawing, now)) if labels and not drawing.ribbon else (),
        notes=tuple(Note(at, text) for at, text in drawing.notes) if labels else (),
    )


def middle(*points: Point) -> Point:
    """The mean of some points."""
    return sum(x for x, _ in points) / len(points), sum(y for _, y in points) / len(points)


def corners_of(drawing: Drawing, tip: Corner) -> tuple[Point, Point, Point]:
    """The places of a triangle's corners, from the tip on."""
    at = drawing.corners
    return at[tip], at[next_corner(tip)], at[previous_corner(tip)]


def _shapes(told: Story, drawing: Drawing, now: Moment) -> Iterator[Shape]:
    """The faces in the order of painting."""
    visit_of = {visit.face: visit for visit in told.visits}
    ring_of = {ring.face: ring for ring in drawing.rings}
    for face in drawing.order:
        visit = visit_of[face]
        ring = ring_of.get(face)
        corners = corners_of(drawing, visit.tip)
        last, blank = visit.step == now.step, visit.step > now.step
        yield Shape(
            visit=visit,
            state=State.BLANK if blank else State.LAST if last else State.VISITED,
            corners=corners,
            far=drawing.far[face],
            light=drawing.light[face],
            ring=ring.radius if ring else 0.0,
            centre=ring.centre if ring else middle(*corners),
            node=_below(ring, corners) if ring else middle(*corners),
        )


def _edges(told: Story, drawing: Drawing, shape: Shape, now: Moment, tree: bool) -> Iterator[Edge]:
    """What the three edges of a face show. An edge between two faces may show it on both sides."""
    opposite, vertex = told.surface.opposite, told.surface.vertex
    morse = {*now.morse, *(opposite[c] for c in now.morse)}
    tip = shape.visit.tip
    for c in (tip, next_corner(tip), previous_corner(tip)):
        across = opposite[c]
        path = drawing.corners[next_corner(c)], drawing.corners[previous_corner(c)]
        if across == BORDER:
            reached = vertex[next_corner(c)] in now.known
            yield Edge(Role.REACHED if reached else Role.CURVE, path, shape.far)
        if c in drawing.cuts:
            yield Edge(Role.CUT, path, shape.far)
        if c in morse:
            yield Edge(Role.MORSE, path, shape.far)
        elif tree and shape.state is not State.BLANK:
            if c not in told.crossed:
                yield Edge(Role.REMAINDER, path, shape.far)
            elif told.step_of[across // 3] <= now.step:
                yield Edge(Role.TREE, (shape.node, middle(*path)), shape.far)


def _below(ring: Ring, corners: tuple[Point, Point, Point]) -> Point:
    """A place inside a ring, between its triangle and its lowest point."""
    low = min(y for _, y in corners)
    return ring.centre[0], (low + ring.centre[1] - ring.radius) / 2


def _gate(surface: Surface, drawing: Drawing, visit: Visit, waiting: int) -> Gate:
    """The gate into a face, on the face's side of the edge. Clause: EB-GATE-1."""
    _, a, b = corners_of(drawing, visit.tip)
    into = middle(*corners_of(drawing, visit.tip))
    if any(ring.face == visit.face for ring in drawing.rings):
        half = middle(a, b)
        into = 2 * half[0] - into[0], 2 * half[1] - into[1]
    tail, head = next_corner(visit.tip), previous_corner(visit.tip)
    return Gate(waiting, surface.vertex[tail], surface.vertex[head], (a, b), into)


def _marks(surface: Surface, drawing: Drawing, now: Moment) -> Iterator[Mark]:
    """Each vertex at each of its places, the far ones first."""
    room: dict[tuple[Vertex, Point], float] = {}
    near: set[tuple[Vertex, Point]] = set()
    for c, v in enumerate(surface.vertex):
        at = drawing.corners[c]
        ends = next_corner(Corner(c)), previous_corner(Corner(c))
        shortest = min(dist(at, drawing.corners[end]) for end in ends)
        room[v, at] = min(room.get((v, at), shortest), shortest)
        if not drawing.far[c // 3]:
            near.add((v, at))
    for key in sorted(room, key=lambda key: (key in near, key)):
        v, at = key
        yield Mark(v, at, v in now.known, key not in near, room[key])
