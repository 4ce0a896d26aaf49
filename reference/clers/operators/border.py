"""Operators at boundary curves: ears, filled corners, caps, openings, peeled faces, cuts."""

from collections.abc import Mapping, Sequence

from clers.complexes.face_list import FaceList
from clers.operators.effect import NO_EFFECT, Effect
from clers.operators.net import (
    Side,
    Triangle,
    apex,
    border,
    component_of_faces,
    curves,
    inner_edges,
    joined,
    sides,
)
from clers.operators.room import rooms
from clers.operators.step import Obstacle, Step, did, idle, renumbered

CURVE_OPENED = Effect(curves=1)
CURVE_CLOSED = Effect(curves=-1)


def add_ear(mesh: FaceList, choice: int) -> Step:
    """Glue a triangle with a new vertex on a border side. Clause: OPER-BORDER-1."""
    candidates = border(sides(mesh.faces))
    if not candidates:
        return idle(mesh, Obstacle.NO_CANDIDATE)
    u, v = candidates[choice % len(candidates)]
    return did([*mesh.faces, (v, u, mesh.vertices)], mesh.vertices + 1)


def fill_corner(mesh: FaceList, choice: int) -> Step:
    """Complete two consecutive border sides with a triangle. Clause: OPER-BORDER-2."""
    of = sides(mesh.faces)
    candidates = border(of)
    if not candidates:
        return idle(mesh, Obstacle.NO_CANDIDATE)
    after = dict(candidates)
    a, b = candidates[choice % len(candidates)]
    c = after[b]
    if after[c] != a:
        if joined(of, a, c):
            return idle(mesh, Obstacle.EDGE_EXISTS)
        effect = NO_EFFECT
    elif of[a, b] == of[b, c]:
        return idle(mesh, Obstacle.FACE_EXISTS)
    else:
        effect = CURVE_CLOSED
    return did([*mesh.faces, (c, b, a)], mesh.vertices, effect)


def close_curve(mesh: FaceList, choice: int) -> Step:
    """Cap a boundary curve with a cone over it. Clause: OPER-BORDER-3."""
    candidates = curves(border(sides(mesh.faces)))
    if not candidates:
        return idle(mesh, Obstacle.NO_CANDIDATE)
    curve = candidates[choice % len(candidates)]
    apex_of_cone = mesh.vertices
    cone = [(v, u, apex_of_cone) for u, v in zip(curve, curve[1:] + curve[:1], strict=True)]
    return did([*mesh.faces, *cone], mesh.vertices + 1, CURVE_CLOSED)


def open_curve(mesh: FaceList, choice: int) -> Step:
    """Remove a face away from every curve, making room for it where needed.

    Clause: OPER-BORDER-4.
    """
    t = choice % len(mesh.faces)
    on_border = {u for u, _ in border(sides(mesh.faces))}
    rest, used = next(
        (room.rest, used)
        for used in range(4)  # at the latest a face of three new vertices has none on a curve
        for room in rooms(mesh.faces[t], mesh.vertices, used)
        if not on_border.intersection(room.inner)
    )
    faces = [*mesh.faces[:t], *mesh.faces[t + 1 :], *rest]
    return did(faces, mesh.vertices + used, CURVE_OPENED)


def remove_face(mesh: FaceList, choice: int) -> Step:
    """Remove a face where that pinches nothing. Clause: OPER-BORDER-5."""
    of = sides(mesh.faces)
    t = choice % len(mesh.faces)
    on_border = {u for u, _ in border(of)}
    a, b, c = mesh.faces[t]
    free = [(u, v) for u, v in ((a, b), (b, c), (c, a)) if (v, u) not in of]
    faces = [*mesh.faces[:t], *mesh.faces[t + 1 :]]
    if len(free) == 3:
        if len(mesh.faces) == 1:
            return idle(mesh, Obstacle.LAST_FACE)
        effect, gone = Effect(components=-1, curves=-1), {a, b, c}
    elif len(free) == 2:
        effect, gone = NO_EFFECT, {u for u, _ in free} & {v for _, v in free}
    else:
        kept = {a, b, c}.difference(*free)
        if kept & on_border:
            return idle(mesh, Obstacle.WOULD_PINCH)
        effect, gone = NO_EFFECT if free else CURVE_OPENED, set()
    return did(renumbered(faces, gone, mesh.vertices), mesh.vertices - len(gone), effect)


def remove_star(mesh: FaceList, choice: int) -> Step:
    """Remove a vertex and its faces, where all its neighbours are inside. Clause: OPER-BORDER-6."""
    on_border = {u for u, _ in border(sides(mesh.faces))}
    candidates = [v for v in range(mesh.vertices) if v not in on_border]
    if not candidates:
        return idle(mesh, Obstacle.NO_CANDIDATE)
    gone = candidates[choice % len(candidates)]
    star = [face for face in mesh.faces if gone in face]
    if any(on_border.intersection(face) for face in star):
        return idle(mesh, Obstacle.WOULD_PINCH)
    faces = [face for face in mesh.faces if gone not in face]
    return did(renumbered(faces, {gone}, mesh.vertices), mesh.vertices - 1, CURVE_OPENED)


def cut_edge(mesh: FaceList, choice: int) -> Step:
    """Cut along an edge that begins at a boundary curve. Clause: OPER-BORDER-7.

    A slit where the other end is inside; the inverse of gluing two sides where it is not.
    """
    of = sides(mesh.faces)
    candidates = inner_edges(of)
    if not candidates:
        return idle(mesh, Obstacle.NO_CANDIDATE)
    side = candidates[choice % len(candidates)]
    found = curves(border(of))
    curve_of = {v: k for k, curve in enumerate(found) for v in curve}
    ends = [v for v in side if v in curve_of]
    if not ends:
        return idle(mesh, Obstacle.INNER_EDGE)
    faces = list(mesh.faces)
    vertices = mesh.vertices
    for end in ends:
        for t in _fan(mesh.faces, of, side, end):
            a, b, c = (vertices if v == end else v for v in faces[t])
            faces[t] = (a, b, c)
        vertices += 1
    if len(ends) == 1:
        return did(faces, vertices)
    if curve_of[ends[0]] != curve_of[ends[1]]:
        return did(faces, vertices, CURVE_CLOSED)
    component = component_of_faces(faces, vertices)
    apart = component[of[side]] != component[of[side[1], side[0]]]
    return did(
        faces, vertices, Effect(components=1, curves=1) if apart else Effect(genus=-1, curves=1)
    )


def _fan(faces: Sequence[Triangle], of: Mapping[Side, int], side: Side, end: int) -> list[int]:
    """The faces at one end of a side, from the face that runs it round to the border."""
    gate = side
    fan: list[int] = []
    while gate in of and of[gate] not in fan:  # so that no mesh, however wrong, makes it endless
        fan.append(of[gate])
        other = apex(faces, of, gate)
        # The face's other side at `end`, as the face across runs it.
        gate = (end, other) if end == side[0] else (other, end)
    return fan
