"""Room for an operator: a face with fresh vertices, made by putting vertices into a given face."""

from dataclasses import dataclass

from clers.operators.net import Triangle


@dataclass(frozen=True, slots=True)
class Room:
    """A face with vertices put into it: the inner face, and the others. Clause: OPER-TUBE-1."""

    inner: Triangle
    rest: tuple[Triangle, ...]


def rooms(face: Triangle, fresh: int, count: int) -> tuple[Room, ...]:
    """The rooms that `count` new vertices (0 … 3), numbered from `fresh`, make in a face.

    The inner face keeps 3 − count of the face's vertices; each room keeps others of them.
    Clause: OPER-TUBE-1.
    """
    a, b, c = face
    if count in (0, 3):  # all of them are kept, or none
        return (_room(face, fresh, count),)
    return tuple(_room(turn, fresh, count) for turn in ((a, b, c), (b, c, a), (c, a, b)))


def _room(face: Triangle, fresh: int, count: int) -> Room:
    """Put the vertices in one after another, each into the face that keeps the newest ones."""
    rest: list[Triangle] = []
    inner = face
    for p in range(fresh, fresh + count):
        a, b, c = inner
        rest += [(a, b, p), (c, a, p)]
        inner = (b, c, p)
    return Room(inner, tuple(rest))
