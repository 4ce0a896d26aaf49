"""Operators that join: handles, connected sums, bridges between border sides, new components."""

from collections.abc import Iterator, Mapping, Sequence

from clers.complexes.face_list import FaceList
from clers.operators.effect import Effect
from clers.operators.net import (
    Side,
    Triangle,
    border,
    component_of_faces,
    curves,
    joined,
    sides,
)
from clers.operators.room import rooms
from clers.operators.step import Obstacle, Step, did, idle


def add_tetrahedron(mesh: FaceList) -> Step:
    """Put a tetrahedron beside what there is. Clause: OPER-TUBE-2."""
    return did([*mesh.faces, *tetrahedron(mesh.vertices)], mesh.vertices + 4, Effect(components=1))


def tetrahedron(first: int) -> tuple[Triangle, ...]:
    """The four faces on vertices first … first+3, oriented together."""
    a, b, c, d = range(first, first + 4)
    return (a, b, c), (a, d, b), (a, c, d), (b, d, c)


def add_handle(mesh: FaceList, first: int, second: int) -> Step:
    """Join two faces of one component by a tube. Clause: OPER-TUBE-3."""
    return _tube(mesh, first, second, same_component=True)


def join_components(mesh: FaceList, first: int, second: int) -> Step:
    """Join two faces of two components by a tube. Clause: OPER-TUBE-4."""
    return _tube(mesh, first, second, same_component=False)


def _tube(mesh: FaceList, first: int, second: int, *, same_component: bool) -> Step:
    component = component_of_faces(mesh.faces, mesh.vertices)
    t = first % len(mesh.faces)
    candidates = [
        u
        for u, lowest in enumerate(component)
        if u != t and (lowest == component[t]) == same_component
    ]
    if not candidates:
        return idle(mesh, Obstacle.NO_CANDIDATE)
    u = candidates[second % len(candidates)]
    of = sides(mesh.faces)
    tube, used = next(_tubes(of, mesh.faces[t], mesh.faces[u], mesh.vertices))
    faces = [face for k, face in enumerate(mesh.faces) if k not in (t, u)]
    effect = Effect(genus=1) if same_component else Effect(components=-1)
    return did([*faces, *tube], mesh.vertices + used, effect)


def _tubes(
    of: Mapping[Side, int], first: Triangle, second: Triangle, vertices: int
) -> Iterator[tuple[list[Triangle], int]]:
    """All that can replace two faces to join them, with its number of new vertices, fewest first.

    Never empty: between two faces of three new vertices each, there is nothing in the way.
    """
    for used in range(7):
        for count in range(max(0, used - 3), min(used, 3) + 1):
            for one in rooms(first, vertices, count):
                for two in rooms(second, vertices + count, used - count):
                    rest = [*one.rest, *two.rest]
                    near = sides(rest)
                    for turn in range(3):
                        tube = tube_around(one.inner, two.inner, turn)
                        if _is_free(of, near, one.inner, tube):
                            yield [*rest, *tube], used


def tube_around(a: Triangle, b: Triangle, turn: int) -> list[Triangle]:
    """Six faces between two triangles: they run a as a face did, and b as a face did."""
    c = [b[(turn - i) % 3] for i in range(3)]
    around = ((0, 1), (1, 2), (2, 0))
    return [face for i, j in around for face in ((a[i], a[j], c[j]), (a[i], c[j], c[i]))]


def _is_free(
    of: Mapping[Side, int],
    near: Mapping[Side, int],
    a: Triangle,
    tube: Sequence[Triangle],
) -> bool:
    """Is no edge of the tube there already? A vertex common to both ends would show as one."""
    across = [(u, v) for u, v in sides(tube) if (u in a) != (v in a)]
    return not any(joined(of, u, v) or joined(near, u, v) for u, v in across)


def bridge(mesh: FaceList, first: int, second: int) -> Step:
    """Join two border sides by two faces: the tutorial's 1-handles. Clause: OPER-TUBE-5."""
    of = sides(mesh.faces)
    candidates = border(of)
    if not candidates:
        return idle(mesh, Obstacle.NO_CANDIDATE)
    a, b = candidates[first % len(candidates)]
    c, d = candidates[second % len(candidates)]
    if len({a, b, c, d}) < 4:
        return idle(mesh, Obstacle.SHARED_VERTEX)
    if joined(of, a, d) or joined(of, b, d) or joined(of, b, c):
        return idle(mesh, Obstacle.EDGE_EXISTS)
    component = component_of_faces(mesh.faces, mesh.vertices)
    curve_of = {v: k for k, curve in enumerate(curves(candidates)) for v in curve}
    if component[of[a, b]] != component[of[c, d]]:
        effect = Effect(components=-1, curves=-1)
    elif curve_of[a] == curve_of[c]:
        effect = Effect(curves=1)
    else:
        effect = Effect(genus=1, curves=-1)
    return did([*mesh.faces, (b, a, d), (b, d, c)], mesh.vertices, effect)
