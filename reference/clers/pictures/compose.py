"""From a walk and a drawing to panels: what is where, at each moment."""

from collections.abc import Iterator, Mapping
from math import dist
from typing import Final

from clers.complexes.surface import (
    BORDER,
    Corner,
    Face,
    Surface,
    Vertex,
    face_of,
    next_corner,
    previous_corner,
)
from clers.pictures.caption import caption
from clers.pictures.drawing import Drawing, Point, Ring
from clers.pictures.picture import Edge, Gate, Mark, Note, Panel, Role, Shape, State
from clers.pictures.room import Corners, roomiest
from clers.pictures.story import Moment, Story

ABOVE: Final = tuple(Role)
"""Roles in the order of painting, where no edge hides behind a face."""


def panel(told: Story, drawing: Drawing, now: Moment, tree: bool, labels: bool) -> Panel:
    """One state of the walk. Clauses: TOOL-PICTURE-1, TOOL-PICTURE-2, TOOL-PICTURE-4."""
    shapes = tuple(_shapes(told, drawing, now, labels))
    nodes = {shape.visit.face: shape.node for shape in shapes} if tree else {}
    ground: list[Shape | Edge] = []
    above: list[Edge] = []
    for shape in shapes:
        ground.append(shape)
        if not drawing.ribbon:
            edges = _edges(told, drawing, shape, now, nodes)
            (ground if drawing.deep else above).extend(edges)
    above.sort(key=lambda edge: ABOVE.index(edge.role))
    waiting = [c for c in (now.gate, *reversed(now.waiting)) if c is not None]
    first = 0 if now.gate is not None else 1
    gates = [
        _gate(told.surface, drawing, c, i)
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


def corners_of(drawing: Drawing, tip: Corner) -> Corners:
    """The places of a triangle's corners, from the tip on."""
    at = drawing.corners
    return at[tip], at[next_corner(tip)], at[previous_corner(tip)]


def _shapes(told: Story, drawing: Drawing, now: Moment, labels: bool) -> Iterator[Shape]:
    """The faces in the order of painting."""
    visit_of = {visit.face: visit for visit in told.visits}
    ring_of = {ring.face: ring for ring in drawing.rings}
    for face in drawing.order:
        visit = visit_of[face]
        ring = ring_of.get(face)
        corners = corners_of(drawing, visit.tip)
        node, room = _node(ring, corners, labels)
        last, blank = visit.step == now.step, visit.step > now.step
        yield Shape(
            visit=visit,
            state=State.BLANK if blank else State.LAST if last else State.VISITED,
            corners=corners,
            far=drawing.far[face],
            light=drawing.light[face],
            ring=ring.radius if ring else 0.0,
            centre=ring.centre if ring else middle(*corners),
            node=node,
            room=room,
        )


def _edges(
    told: Story, drawing: Drawing, shape: Shape, now: Moment, nodes: Mapping[Face, Point]
) -> Iterator[Edge]:
    """What the three edges of a face show. An edge between two faces may show it on both sides.

    `nodes` are where links of the dual tree meet, none if it is not wanted.
    """
    opposite, vertex, at = told.surface.opposite, told.surface.vertex, drawing.corners
    tip, far = shape.visit.tip, shape.far
    for c in (tip, next_corner(tip), previous_corner(tip)):
        tail, head, across = next_corner(c), previous_corner(c), opposite[c]
        ends, path = (vertex[tail], vertex[head]), (at[tail], at[head])
        if across == BORDER:
            yield Edge(Role.REACHED if ends[0] in now.known else Role.CURVE, ends, path, far)
        if c in drawing.cuts:
            yield Edge(Role.CUT, ends, path, far)
        if c in now.morse:
            yield Edge(Role.MORSE, ends, path, far)
        elif nodes and shape.state is not State.BLANK:
            if c not in told.crossed:
                yield Edge(Role.REMAINDER, ends, path, far)
            elif told.step_of[across // 3] <= now.step:
                link = shape.node, nodes[face_of(across)]
                through = middle(*path) if c in drawing.cuts else crossing(path, link)
                yield Edge(Role.TREE, ends, (shape.node, through), far)


def crossing(edge: tuple[Point, Point], link: tuple[Point, Point]) -> Point:
    """Where a link goes through an edge: on the straight way, but not near the edge's ends."""
    (ax, ay), (bx, by) = edge
    (px, py), (qx, qy) = link
    from_a, from_b = ((qx - px) * (y - py) - (qy - py) * (x - px) for x, y in ((ax, ay), (bx, by)))
    share = from_a / (from_a - from_b) if from_a != from_b else 0.5
    share = min(max(share, 0.2), 0.8)
    return ax + share * (bx - ax), ay + share * (by - ay)


def _node(ring: Ring | None, corners: Corners, labels: bool) -> tuple[Point, float]:
    """A place inside a face, and the radius of what fits there; in a ring below its triangle.

    The gate into a ring is the lowest side of its triangle, since a disc's border begins with it.
    """
    if ring is not None:
        low = min(y for _, y in corners)
        foot = ring.centre[1] - ring.radius
        return (ring.centre[0], (low + foot) / 2), (low - foot) / 2
    return roomiest(corners) if labels else (middle(*corners), 0.0)


def _gate(surface: Surface, drawing: Drawing, tip: Corner, waiting: int) -> Gate:
    """The gate of a tip, drawn at the face it leads into. Clause: EB-GATE-1."""
    apex, a, b = corners_of(drawing, tip)
    into = middle(apex, a, b)
    if any(ring.face == face_of(tip) for ring in drawing.rings):
        half = middle(a, b)
        into = 2 * half[0] - into[0], 2 * half[1] - into[1]
    tail, head = surface.vertex[next_corner(tip)], surface.vertex[previous_corner(tip)]
    return Gate(waiting, tail, head, (a, b), into)


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
