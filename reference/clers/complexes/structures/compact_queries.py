"""What compact half-edges are asked at each level, with the entries read, counted one by one."""

from dataclasses import dataclass
from typing import Generic, TypeVar

from clers.complexes.structures.compact import (
    NONE,
    Level0,
    Level1,
    Level2,
    Level3,
    after,
    before,
)

A = TypeVar("A")

Curves = tuple[tuple[int, ...], ...]


@dataclass(frozen=True, slots=True)
class Read(Generic[A]):
    """An answer and how many entries of arrays were read for it. Clause: CPLX-COMPACT-5."""

    answer: A
    entries: int


class Reader:
    """Counts what is read; local to one query."""

    __slots__ = ("count",)

    def __init__(self) -> None:
        self.count = 0

    def at(self, array: tuple[int, ...], index: int) -> int:
        """One entry."""
        self.count += 1
        return array[index]

    def read(self, answer: A) -> Read[A]:
        """The answer with what it took."""
        return Read(answer, self.count)


def star_0(of: Level0, vertex: int) -> Read[frozenset[int]]:
    """The faces at a vertex, by looking at every corner. Clause: CPLX-COMPACT-5."""
    r = Reader()
    found = frozenset(h // 3 for h in range(len(of.vertex)) if r.at(of.vertex, h) == vertex)
    return r.read(found)


def star_1(of: Level1, vertex: int) -> Read[frozenset[int]]:
    """The faces at a vertex, by looking for one and turning both ways. CPLX-COMPACT-5."""
    r = Reader()
    corners = of.soup.vertex
    start = next(h for h in range(len(corners)) if r.at(corners, h) == vertex)
    found = [start]
    while (other := r.at(of.opposite, before(found[-1]))) not in (NONE, start):
        found.append(other)
    if other == NONE:
        h = start
        while (other := r.at(of.opposite, h)) != NONE:
            h = after(other)
            found.append(h)
    return r.read(frozenset(h // 3 for h in found))


def star_2(of: Level2, vertex: int) -> Read[frozenset[int]]:
    """The faces at a vertex, by turning once. Clause: CPLX-COMPACT-5."""
    r = Reader()
    start = r.at(of.of_vertex, vertex)
    found = [start]
    while (other := r.at(of.table.opposite, before(found[-1]))) not in (NONE, start):
        found.append(other)
    return r.read(frozenset(h // 3 for h in found))


def opposite_0(of: Level0, h: int) -> Read[int]:
    """The half-edge that runs the other way, or NONE, by looking at all. CPLX-COMPACT-6."""
    r = Reader()
    tail, head = r.at(of.vertex, h), r.at(of.vertex, after(h))
    for other in range(len(of.vertex)):
        if r.at(of.vertex, other) == head and r.at(of.vertex, after(other)) == tail:
            return r.read(other)
    return r.read(NONE)


def opposite_1(of: Level1, h: int) -> Read[int]:
    """The half-edge that runs the other way, or NONE. Clause: CPLX-COMPACT-6."""
    r = Reader()
    return r.read(r.at(of.opposite, h))


def curves_2(of: Level2) -> Read[Curves]:
    """The boundary curves; their starts are looked for. Clause: CPLX-COMPACT-7."""
    r = Reader()
    opposite = of.table.opposite
    border = [h for h in range(len(opposite)) if r.at(opposite, h) == NONE]
    done: set[int] = set()
    found: list[tuple[int, ...]] = []
    for first in border:
        if first not in done:
            curve = _curve(r, of, first)
            done.update(h for h, _ in curve)
            found.append(tuple(v for _, v in curve))
    return r.read(tuple(found))


def curves_3(of: Level3) -> Read[Curves]:
    """The boundary curves, whose starts are known. Clause: CPLX-COMPACT-7."""
    r = Reader()
    starts = [r.at(of.curves, i) for i in range(len(of.curves))]
    return r.read(tuple(tuple(v for _, v in _curve(r, of.cells, h)) for h in starts))


def _curve(r: Reader, of: Level2, first: int) -> list[tuple[int, int]]:
    """The half-edges of one curve with their origins: two entries for each."""
    corners = of.table.soup.vertex
    found: list[tuple[int, int]] = []
    h = first
    while True:
        head = r.at(corners, after(h))
        following = r.at(of.of_vertex, head)
        found.append((following, head))
        h = following
        if h == first:
            return [found[-1], *found[:-1]]
