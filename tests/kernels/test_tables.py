"""The kernels of corner tables beside what they should say, over all small tables.

Where a kernel refuses too much, the clauses are asked one after another, and the answer is right,
but late: so these are asked alone.
"""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from itertools import permutations, product
from random import Random

import pytest
from librt.vecs import vec
from mypy_extensions import i64

from clers.complexes.corner_table import by_clauses
from clers.complexes.face_list import FaceList
from clers.conventions.result import Accepted
from clers.kernels import table

Face = tuple[int, int, int]


def judged(faces: Sequence[Face], vertices: int) -> list[int] | None:
    """The opposite corners by the kernels, or None if one of them refuses."""
    vertex = vec[i64](v for face in faces for v in face)
    if not table.fit(vertex, vertices):
        return None
    opposite = table.opposites(vertex, vertices)
    if len(opposite) == 0 or not table.one_fan_each(vertex, opposite, vertices):
        return None
    return list(opposite)


def by_definition(faces: Sequence[Face], vertices: int) -> list[int] | None:
    """The same by the clauses."""
    found = by_clauses(FaceList(tuple(faces), vertices))
    return list(found.value.opposite) if isinstance(found, Accepted) else None


ENTRIES = (-1, 0, 1, 2, 3)
FACES = list(permutations(range(4), 3))


@pytest.mark.parametrize("before", [(), (2, 1, 0)])
@pytest.mark.parametrize("vertices", [2, 3])
def test_faces_of_three_vertices_that_are_there(before: tuple[int, ...], vertices: int) -> None:
    """Clauses: CPLX-REJECT-3, CPLX-REJECT-4."""
    for face in product(ENTRIES, repeat=3):
        there = all(0 <= v < vertices for v in (*before, *face))
        assert table.fit(vec[i64]((*before, *face)), vertices) == (there and len({*face}) == 3)


@pytest.mark.parametrize("count", [1, 2, 3])
@pytest.mark.parametrize("vertices", [3, 4])
def test_all_tables_of_few_faces(count: int, vertices: int) -> None:
    """TOOL-BUILD-6: faces on four vertices, as many times and as turned as one likes."""
    for faces in product(FACES, repeat=count):
        if count < 3 or faces[0] == (0, 1, 2):  # else the same by another name
            assert judged(faces, vertices) == by_definition(faces, vertices), faces


OCTAHEDRON: Sequence[Face] = (
    (0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 1), (5, 2, 1), (5, 3, 2), (5, 4, 3), (5, 1, 4),
)  # fmt: skip
TORUS: Sequence[Face] = tuple(
    face
    for v in range(7)
    for face in ((v, (v + 1) % 7, (v + 3) % 7), (v, (v + 3) % 7, (v + 2) % 7))
)
"""Möbius's, on seven vertices."""


def parts(whole: Sequence[Face], number: int, random: Random) -> Iterator[Sequence[Face]]:
    """Some of the faces, in any order, from any corner, sometimes one of them turned over."""
    for _ in range(number):
        chosen = random.sample(whole, random.randint(1, len(whole)))
        faces = [random.choice(((a, b, c), (b, c, a), (c, a, b))) for a, b, c in chosen]
        if random.random() < 0.2:
            a, b, c = faces[0]
            faces[0] = (a, c, b)
        yield faces


@pytest.mark.parametrize("whole", [OCTAHEDRON, TORUS])
def test_parts_of_closed_surfaces(whole: Sequence[Face]) -> None:
    """TOOL-BUILD-6: borders, pinched vertices, faces turned over, vertices that are not used."""
    random = Random(1)
    seen: set[bool] = set()
    for faces in (whole, *parts(whole, 400, random)):
        name = {v: i for i, v in enumerate(sorted({v for face in faces for v in face}))}
        here = [(name[a], name[b], name[c]) for a, b, c in faces]
        for vertices in (len(name), len(name) + 1):
            expected = by_definition(here, vertices)
            assert judged(here, vertices) == expected, here
            seen.add(expected is None)
    assert seen == {False, True}


Glued = Mapping[int, int]


def gluings(free: Sequence[int]) -> Iterator[Glued]:
    """All ways to glue edges of triangles, each to none or one other, of another triangle."""
    waiting: list[tuple[Glued, Sequence[int]]] = [({}, free)]
    while waiting:
        glued, rest = waiting.pop()
        if not rest:
            yield glued
            continue
        first, others = rest[0], rest[1:]
        waiting.append((glued, others))
        for other in others:
            if other // 3 != first // 3:
                there = {**glued, first: other, other: first}
                waiting.append((there, [c for c in others if c != other]))


def some_gluings(faces: int, number: int, random: Random) -> Iterator[Glued]:
    """Some of them, most edges glued."""
    for _ in range(number):
        glued: dict[int, int] = {}
        free = random.sample(range(3 * faces), 3 * faces)
        while len(free) > random.randint(0, 5):
            first = free.pop()
            other = next((c for c in free if c // 3 != first // 3), None)
            if other is not None:
                free.remove(other)
                glued |= {first: other, other: first}
        yield glued


def following(corner: int) -> int:
    """The next corner of the same face."""
    return corner - 2 if corner % 3 == 2 else corner + 1


def named(faces: int, glued: Glued) -> list[int]:
    """A vertex for each corner, the same for those that gluing brings together: each has a fan."""
    name = list(range(3 * faces))
    for here, other in glued.items():
        for one, same in (
            (following(here), following(following(other))),
            (following(following(here)), following(other)),
        ):
            low, high = sorted((name[one], name[same]))
            name = [low if v == high else v for v in name]
    order = sorted(set(name))
    return [order.index(v) for v in name]


def double(vertex: Sequence[int], glued: Glued) -> bool:
    """Have two edges the same ends, or two faces the same vertices?"""
    ends: dict[tuple[int, ...], int] = defaultdict(int)
    for corner in range(len(vertex)):
        if glued.get(corner, -1) < corner:
            one = following(corner)
            ends[tuple(sorted((vertex[one], vertex[following(one)])))] += 1
    faces = [frozenset(vertex[c : c + 3]) for c in range(0, len(vertex), 3)]
    return any(count > 1 for count in ends.values()) or len(set(faces)) < len(faces)


@pytest.mark.parametrize("faces", [1, 2, 3, 4, 6])
def test_edges_and_faces_that_are_there_twice(faces: int) -> None:
    """Clauses: CPLX-REJECT-5, CPLX-REJECT-6, CPLX-REJECT-7; all gluings of up to three faces."""
    few = faces < 4
    found = gluings(range(3 * faces)) if few else some_gluings(faces, 1500, Random(faces))
    seen: set[bool] = set()
    for glued in found:
        vertex = named(faces, glued)
        flat, vertices = vec[i64](vertex), max(vertex) + 1
        if table.fit(flat, vertices):
            opposite = vec[i64](glued.get(c, -1) for c in range(3 * faces))
            twice = double(vertex, glued)
            assert table.simple(flat, opposite, vertices) != twice, (vertex, glued)
            seen.add(twice)
    assert seen == ({False} if faces == 1 else {False, True})


def band() -> tuple[list[tuple[str, str, str]], Glued]:
    """A ring of ten faces on which v and w have two edges, both inside, at the middle of each fan.

    Faces 0 to 2 are about v, from w to w; 3 to 5 about w, from v to v. The others are outside.
    """
    faces = [
        ("v", "w", "a"), ("v", "a", "b"), ("v", "b", "w"),
        ("w", "v", "c"), ("w", "c", "d"), ("w", "d", "v"),
        ("e", "d", "v"), ("f", "v", "c"), ("g", "b", "w"), ("h", "w", "a"),
    ]  # fmt: skip
    pairs = [
        (1, 5),
        (4, 8),
        (10, 14),
        (13, 17),
        (2, 11),
        (7, 16),
        (15, 18),
        (9, 21),
        (6, 24),
        (0, 27),
    ]
    turned = [(face[0], face[2], face[1]) if i >= 6 else face for i, face in enumerate(faces)]
    return turned, dict([*pairs, *((b, a) for a, b in pairs)])


def renumbered(places: Sequence[int], odd: bool) -> tuple[list[int], list[int]]:
    """The vertices and opposite corners of the band, its faces at other places, and turned.

    Where it can be, v and w stand at odd corners, or at even ones.
    """
    faces, glued = band()
    names = sorted({name for face in faces for name in face})
    to: dict[int, int] = {}
    for i, face in enumerate(faces):
        turns = [[3 * places[i] + (k + turn) % 3 for k in range(3)] for turn in range(3)]
        wrong = [
            sum(name in "vw" and corner % 2 != odd for name, corner in zip(face, turn, strict=True))
            for turn in turns
        ]
        to |= zip(range(3 * i, 3 * i + 3), turns[wrong.index(min(wrong))], strict=True)
    vertex, opposite = [0] * 30, [-1] * 30
    for corner, place in to.items():
        vertex[place] = names.index(faces[corner // 3][corner % 3])
        if corner in glued:
            opposite[place] = to[glued[corner]]
    return vertex, opposite


@pytest.mark.parametrize("odd", [False, True])
@pytest.mark.parametrize("outside", list(permutations((0, 2, 4, 6))))
def test_an_edge_that_is_there_twice_far_from_the_first_corner(
    outside: tuple[int, ...], odd: bool
) -> None:
    """CPLX-REJECT-6: it is seen whichever face comes first, at whichever corner."""
    for inside in ((1, 8, 3, 5, 9, 7), (7, 9, 5, 3, 8, 1)):
        vertex, opposite = renumbered((*inside, *outside), odd)
        flat = vec[i64](vertex)
        assert table.fit(flat, 10)
        assert double(vertex, {c: d for c, d in enumerate(opposite) if d >= 0})
        assert not table.simple(flat, vec[i64](opposite), 10)


def test_the_band_is_glued_as_it_is_named() -> None:
    """The vertices are those that the gluing makes."""
    faces, glued = band()
    vertex = named(len(faces), glued)
    names = [name for face in faces for name in face]
    assert len(set(zip(names, vertex, strict=True))) == len(set(names)) == len(set(vertex)) == 10
    assert double(vertex, glued)
