"""A script for every surface: a handle decomposition, breadth first from some triangles."""

from collections import deque
from collections.abc import Iterator

from clers.complexes.surface import (
    BORDER,
    Corner,
    Face,
    Surface,
    next_corner,
    previous_corner,
)
from clers.conventions.result import Rejected
from clers.operators.sheets.apply import apply
from clers.operators.sheets.needs import loop_from
from clers.operators.sheets.operator import (
    Complete,
    Constructive,
    Glue,
    Join,
    Lower,
    Script,
    TwoHandle,
    Upper,
    ZeroHandle,
)
from clers.operators.sheets.sheet import (
    EMPTY,
    Sheet,
    Side,
    component,
    sides_of,
    vertices,
)


def build(surface: Surface, first: int = 1) -> Script:
    """A script of handle operators that makes the sheet of a surface, vertices keeping their names.

    `first`: how many triangles, at most, to begin with, apart from each other. Quadratic.
    Clauses: OPER-BUILD-1, OPER-BUILD-2, OPER-BUILD-3.
    """
    sheet, script, placed = EMPTY, list[Constructive](), set[Face]()
    for face in order(surface, first):
        operator = _operator(surface, sheet, placed, face)
        after = apply(operator, sheet)
        if isinstance(after, Rejected):
            raise AssertionError(f"{operator}: {after.line()}")
        sheet = after.value
        script.append(operator)
        placed.add(face)
    return tuple(script)


def order(surface: Surface, first: int = 1) -> Iterator[Face]:
    """The triangles in the order of the decomposition. Clause: OPER-BUILD-1."""
    queue = deque(_apart(surface, first))
    met = set(queue)
    yield from queue
    for t in range(surface.faces):
        if Face(t) not in met and not queue:
            met.add(Face(t))
            queue.append(Face(t))
            yield Face(t)
        while queue:
            face = queue.popleft()
            for corner in (3 * face + 2, 3 * face, 3 * face + 1):  # across the sides in order
                across = surface.opposite[corner]
                if across != BORDER and Face(across // 3) not in met:
                    met.add(Face(across // 3))
                    queue.append(Face(across // 3))
                    yield Face(across // 3)


def _apart(surface: Surface, first: int) -> Iterator[Face]:
    """The first triangles that have no vertex in common. Clause: OPER-BUILD-1."""
    used: set[int] = set()
    chosen = 0
    for t, triangle in enumerate(surface.triangles()):
        if chosen < first and used.isdisjoint(triangle):
            used.update(triangle)
            chosen += 1
            yield Face(t)


def _operator(surface: Surface, sheet: Sheet, placed: set[Face], face: Face) -> Constructive:
    """The operator that puts a triangle where the surface has it. Clause: OPER-BUILD-1."""
    bounding = {side for loop in sheet.loops for side in sides_of(loop)}
    corners = [Corner(3 * face + i) for i in range(3)]
    turns = [(c, *_from(surface, c)) for c in corners]
    open_at = [(c, x, y, z) for c, x, y, z in turns if (x, y) in bounding]
    match open_at:
        case []:
            return ZeroHandle(*surface.triangle(face))
        case [(corner, a, b, c)]:
            if c not in vertices(sheet):
                return Glue(a, b, c)
            d = _beside(surface, sheet, placed, previous_corner(corner))
            return _one_handle(sheet, (a, b), (c, d))
        case [_, _]:
            a, b, c = next((x, y, z) for _, x, y, z in open_at if (y, z) in bounding)
            return Complete(a, b, c)
        case _:
            return TwoHandle(*surface.triangle(face))


def _from(surface: Surface, corner: Corner) -> tuple[int, int, int]:
    """The vertices of a triangle from a corner on."""
    v = surface.vertex
    return v[corner], v[next_corner(corner)], v[previous_corner(corner)]


def _beside(surface: Surface, sheet: Sheet, placed: set[Face], corner: Corner) -> int:
    """Where the loop goes on from a corner's vertex, at the place into which the triangle falls.

    Turn around the vertex to the nearest triangle that is there, or where a boundary curve comes
    first, to the nearest on the other side.
    """
    c = corner
    while (across := surface.opposite[previous_corner(c)]) != BORDER:
        c = previous_corner(across)
        if Face(c // 3) in placed:
            return surface.vertex[previous_corner(c)]
    c = corner
    while Face(c // 3) not in placed:
        c = next_corner(surface.opposite[next_corner(c)])
    loop = loop_from(sheet, surface.vertex[next_corner(c)], surface.vertex[c])
    assert loop is not None, "a side of a triangle that is there, whose other side is not"
    return loop[2 % len(loop)]


def _one_handle(sheet: Sheet, gate: Side, corner: Side) -> Join | Lower | Upper:
    part = component(sheet)
    if part[gate[0]] != part[corner[0]]:
        return Join(*gate, *corner)
    loop = loop_from(sheet, *gate)
    if loop is not None and corner in set(sides_of(loop)):
        return Lower(*gate, *corner)
    return Upper(*gate, *corner)
