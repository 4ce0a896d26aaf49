"""Operators that a sheet suggests: their operands are sides of its loops, or its triangles."""

from collections.abc import Iterator
from typing import Final

from clers.operators.sheets.operator import Operator
from clers.operators.sheets.sheet import Sheet, followers, sides_of, vertices
from clers.operators.sheets.text import NAME, UNDONE, WITH_FOUR, named

Choice = tuple[str, int, int]
"""The name of an operator, and two numbers that choose sides of loops or triangles."""

MOST_SIDES: Final = 8


def in_reach(
    sheet: Sheet, names: tuple[str, ...] = (*NAME.values(), *UNDONE)
) -> Iterator[Operator]:
    """The operators of some names, at several sides of the loops, to a few other sides."""
    sides = sum(len(loop) for loop in sheet.loops)
    tried = range(0, sides or 1, 1 + sides // MOST_SIDES)
    for i in tried:
        for name in names:
            others = (i + 2, i + sides // 2 + 1) if name in WITH_FOUR else (i,)
            yield from (proposed((name, i, j), sheet) for j in others)


def proposed(choice: Choice, sheet: Sheet) -> Operator:
    """The operator of a choice, with operands that a sheet suggests, whether it applies or not."""
    name, i, j = choice
    operator = named(name, _suggested(name, i, j, sheet))
    assert operator is not None, name
    return operator


def _suggested(name: str, i: int, j: int, sheet: Sheet) -> tuple[int, ...]:
    new = max(vertices(sheet), default=-1) + 1
    then = followers(sheet)
    ring = sorted(side for loop in sheet.loops for side in sides_of(loop)) or [(0, 1), (2, 3)]
    (a, b), (c, d) = ring[i % len(ring)], ring[j % len(ring)]
    after = then.get((a, b), (b, c))[1]
    if name in UNDONE:
        return _suggested_undone(UNDONE[name], i, j, sheet)
    match name:
        case "make-stv" | "zero-handle":
            return new, new + 1, new + 2
        case "zero-handle-polygon":
            return tuple(range(new, new + 3 + j % 3))
        case "make-ev" | "glue":
            return a, b, new
        case "make-te" | "complete" | "make-sg" | "two-handle":
            return a, b, after
        case _:
            return a, b, c, d


def _suggested_undone(name: str, i: int, j: int, sheet: Sheet) -> tuple[int, ...]:
    """What may be undone at the side a → c of a loop, or at a triangle."""
    then = followers(sheet)
    ring = sorted(side for loop in sheet.loops for side in sides_of(loop)) or [(0, 2)]
    triangles = sorted(sheet.triangles) or [(0, 1, 2)]
    polygons = sorted(sheet.polygons) or [(0, 1, 2)]
    a, c = ring[i % len(ring)]
    d = then.get((a, c), (c, 3))[1]
    b = then.get((c, a), (a, 1))[1]  # the third vertex across, or where the loop goes on
    match name:
        case "make-stv" | "zero-handle" | "make-sg" | "two-handle":
            return triangles[j % len(triangles)]
        case "zero-handle-polygon":
            return polygons[j % len(polygons)]
        case "make-ev":
            return a, then.get((c, d), (d, b))[1], c
        case "glue":
            return a, d, c
        case "make-te" | "complete":
            return a, b, c
        case "join-strip" | "lower-strip" | "upper-strip":
            return a, then.get((b, a), (a, d))[1], b, c
        case _:
            return a, b, c, d
