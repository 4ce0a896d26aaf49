"""A mesh as a message has it, taken apart: triples, places, nothing believed of it."""

from dataclasses import dataclass
from typing import Final

from clers.conformance import payloads as form
from clers.conformance.numbers import from_wire

Face = tuple[int, int, int]
Place = tuple[float, float, float]

MOST: Final = 1 << 22
"""More vertices than these are not held: a message can name any number. Clause: ORCL-CODEC-8."""


@dataclass(frozen=True, slots=True)
class Soup:
    """Any triples of integers, a number of vertices, places if there are, of so many coordinates.

    Clause: ORCL-CODEC-3.
    """

    faces: tuple[Face, ...]
    vertices: int
    places: tuple[Place, ...] | None
    coordinates: int

    @property
    def isolated(self) -> tuple[bool, ...]:
        """Of each vertex, whether no face names it."""
        lonely = [True] * self.vertices
        for face in self.faces:
            for v in face:
                lonely[v] = False
        return tuple(lonely)


def soup(given: form.MeshForm) -> Soup:
    """The mesh of a message; coordinates are grouped by three as far as they go."""
    faces = tuple((from_wire(a), from_wire(b), from_wire(c)) for a, b, c in given.faces)
    vertices = from_wire(given.vertices)
    if not isinstance(given.positions, form.Places):
        return Soup(faces, vertices, None, 0)
    at = given.positions.coordinates
    places = tuple(zip(at[0::3], at[1::3], at[2::3], strict=False))
    return Soup(faces, vertices, places, len(at))


def begun_at_least(face: tuple[int, ...]) -> tuple[int, ...]:
    """The same oriented face, turned so that it is the least of its turns."""
    return min(face[i:] + face[:i] for i in range(len(face)))
