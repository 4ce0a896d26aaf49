"""Orientations, tree words and closure: laws, all small spheres, and words worked out by hand."""

from itertools import combinations
from math import comb

import pytest

from clers.codes.closure import sphere_of
from clers.codes.closure_definition import faces_by_rescanning
from clers.codes.half_edges import half_edges
from clers.codes.laws_trees import LAWS
from clers.codes.orientation import orientation
from clers.codes.orientation_definition import (
    inner_edges,
    is_orientation,
    orientations,
    turns_clockwise,
)
from clers.codes.tree_word import tree_word
from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.clause import Clause
from clers.conventions.law import AnyLaw
from clers.conventions.reason import Reason
from clers.conventions.result import Accepted, Rejected
from clers.conventions.where import WHOLE, AtSymbol, Where
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import TETRAHEDRON
from clers.generate.exhaustive import rooted_surfaces, sphere_triangulations
from clers.generate.irregular import irregular_sphere
from laws import run

TUTTE = {4: 1, 5: 3, 6: 13, 7: 68, 8: 399}
"""Rooted simple triangulations of the sphere (Tutte 1962; OEIS A000256)."""


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_law(law: AnyLaw) -> None:
    """Clauses are in the laws."""
    run(law)


def bits(digits: str) -> bytes:
    return bytes(map(int, digits))


def rooted(vertices: int) -> list[Surface]:
    """Each sphere from each of its corners."""
    return [s for faces in sphere_triangulations(vertices) for s in rooted_surfaces(faces)]


def built(faces: tuple[tuple[int, int, int], ...]) -> Surface:
    made = surface(FaceList(faces, 1 + max(map(max, faces))))
    assert isinstance(made, Accepted)
    return made.value


BIPYRAMID = built(((0, 1, 2), (0, 2, 3), (0, 3, 1), (4, 2, 1), (4, 3, 2), (4, 1, 3)))
"""Apexes 0 and 4 about the triangle 1, 2, 3."""


def test_half_edges_of_the_tetrahedron() -> None:
    """CODE-TREE-1: twins run the other way, turns go about a vertex."""
    edges = half_edges(TETRAHEDRON)
    for h, twin in enumerate(edges.twin):
        assert (edges.source[h], edges.target(h)) == (edges.target(twin), edges.source[twin])
        face = TETRAHEDRON.vertex[h - h % 3 : h - h % 3 + 3]
        x, y, z = (*face, *face)[h % 3 : h % 3 + 3]
        assert (edges.source[h], edges.target(h)) == (x, y)
        assert (edges.source[edges.turn[h]], edges.target(edges.turn[h])) == (x, z)
        assert len(edges.around(h)) == 3
        assert edges.around(h)[:2] == [h, edges.turn[h]]


@pytest.mark.parametrize("vertices", [4, 5, 6, 7])
def test_one_orientation_of_all_has_no_clockwise_cycle(vertices: int) -> None:
    """CODE-TREE-2, CODE-TREE-3: by trying all ways to direct the edges."""
    for sphere in rooted(vertices):
        edges = half_edges(sphere)
        assert len(inner_edges(edges)) == 3 * (vertices - 3)
        every_one = list(orientations(edges))
        assert all(is_orientation(edges, out) for out in every_one)
        found = [out for out in every_one if not turns_clockwise(edges, out)]
        assert found == [bytes(orientation(edges))]


def test_what_is_no_orientation_is_seen() -> None:
    """CODE-TREE-2: an edge both ways, one not directed, one out of the root, one turned over."""
    edges = half_edges(BIPYRAMID)
    good = bytes(orientation(edges))
    assert is_orientation(edges, good)
    for h in range(len(good)):
        changed = bytearray(good)
        changed[h] ^= 1
        assert not is_orientation(edges, changed)
        changed[edges.twin[h]] ^= 1
        assert not is_orientation(edges, changed)


def test_the_octahedron_has_two_orientations() -> None:
    """CODE-TREE-2: the inner triangle of an octahedron is a cycle that runs either way."""
    octahedron = built(
        ((0, 1, 2), (0, 2, 4), (2, 1, 3), (1, 0, 5), (2, 3, 4), (1, 5, 3), (0, 4, 5), (3, 5, 4))
    )
    edges = half_edges(octahedron)
    both = list(orientations(edges))
    assert len(both) == 2
    assert sorted(turns_clockwise(edges, out) for out in both) == [False, True]
    kept = orientation(edges)
    # Seen from outside, 3, 5, 4 run as their face does, and the face is on the left.
    inner = {(edges.source[h], edges.target(h)) for h in range(21, 24) if kept[h]}
    assert inner == {(3, 5), (5, 4), (4, 3)}


@pytest.mark.parametrize("vertices", [4, 5, 6, 7, 8])
def test_rooted_spheres_and_accepted_words_are_one_to_one(vertices: int) -> None:
    """CODE-TREE-4 … CODE-TREE-8: all spheres, and all words of 4m bits with m ones."""
    m = vertices - 3
    words = {tree_word(sphere): encode(sphere).stream.word for sphere in rooted(vertices)}
    assert len(words) == len(set(words.values())) == TUTTE[vertices]
    accepted: dict[bytes, str] = {}
    for ones in combinations(range(4 * m), m):
        word = bytes(i in ones for i in range(4 * m))
        sphere = sphere_of(word)
        if isinstance(sphere, Accepted):
            accepted[word] = encode(sphere.value).stream.word
    assert accepted == words
    assert comb(4 * m, m) >= len(words)


def test_the_words_of_five_vertices() -> None:
    """CODE-TREE-5, CODE-TREE-8, by hand: trees of a root and two more vertices.

    Both below the root: 1000 1000. The second below the first, before, between its leaves, or
    behind them: 11000000 has the root's leaf before two edges, which closes it, and is refused.
    """
    accepted = {
        word
        for word in ("10001000", "11000000", "10100000", "10010000")
        if isinstance(sphere_of(bits(word)), Accepted)
    }
    assert accepted == {"10001000", "10100000", "10010000"}


def test_closing_one_triangle_by_hand() -> None:
    """CODE-TREE-8, CODE-TREE-9: 10100000 is 0*, 01, 1*, 12, 2*, 2*, 21, 1*, 10, 0*.

    (x* is a leaf.) 2*, 21 is followed by a leaf: nothing. 1*, 12 by a leaf: nothing. So all stay:
    2 has two leaves. v1 is 3 and v2 is 4. To v2: 0*, 1*, the first of 2; to v1: the others.
    """
    sphere = sphere_of(bits("10100000"))
    assert isinstance(sphere, Accepted)
    assert list(sphere.value.triangles()) == [
        (0, 3, 4), (0, 4, 1), (1, 4, 2), (2, 4, 3), (2, 3, 1), (1, 3, 0),
    ]  # fmt: skip
    assert sphere.value.vertices == 5


def test_closing_another_by_hand() -> None:
    """CODE-TREE-8: 10001000 is 0*, 01, 1*, 1*, 10, 02, 2*, 2*, 20, 0*.

    The second leaf of 1 is followed by 10 and 02: face (1, 2, 0), and 12 in their place. Then 1 has
    0*, 01, 1*, 12, 2*, 2*, 20, 0*: two leaves at 2.
    """
    sphere = sphere_of(bits("10001000"))
    assert isinstance(sphere, Accepted)
    assert list(sphere.value.triangles()) == [
        (0, 3, 4), (1, 2, 0), (0, 4, 1), (1, 4, 2), (2, 4, 3), (2, 3, 0),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("word", "where", "detail"),
    [
        ("", WHOLE, "the tree has 1 vertices, 0 of them not finished"),
        ("0100", AtSymbol(0), "the root has its two leaves already"),
        ("10000", AtSymbol(4), "the root has its two leaves already"),
        ("100", WHOLE, "the tree has 2 vertices, 1 of them not finished"),
        ("11000", WHOLE, "the tree has 3 vertices, 1 of them not finished"),
        ("11000000", WHOLE, "the first leaf of the root is closed"),
    ],
)
def test_words_that_are_refused(word: str, where: Where, detail: str) -> None:
    """CODE-TREE-6."""
    expected = Rejected(Reason.NOT_CANONICAL, Clause.CODE_TREE_6, where, detail)
    assert sphere_of(bits(word)) == expected
    by_definition = faces_by_rescanning(bits(word))
    assert isinstance(by_definition, Rejected)
    assert (by_definition.reason, by_definition.clause) == (expected.reason, expected.clause)


def test_a_bipyramid_from_its_apex_and_from_its_middle() -> None:
    """CODE-TREE-3, CODE-TREE-4, by hand.

    Rooted at (0, 1, 2) with 3 and 4 inside. Shelling 2, 0, 1: 0 has the neighbour 3 between, which
    takes its place. 3 meets 2, 4 and 1: it goes out to 2 and 1, and 4 comes in. Then 4 goes out to
    2 and 1. So 3 goes out to 0, 1, 2, and 4 to 1, 2, 3. The walk: 1 to 3; 3→2 cut 0; 1 to 4; 4→2
    cut 0; 4→1 cut 0; back to 3 0; 3→1 cut 0; back 0.
    """
    assert tree_word(BIPYRAMID) == bits("10100000")


def test_large_spheres_come_back() -> None:
    """CODE-TREE-3, CODE-TREE-8: no recursion that depends on the input."""
    made = surface(irregular_sphere(20000, 1))
    assert isinstance(made, Accepted)
    edges = half_edges(made.value)
    out = orientation(edges)
    assert is_orientation(edges, out)
    assert not turns_clockwise(edges, out)
    back = sphere_of(tree_word(made.value))
    assert isinstance(back, Accepted)
    assert encode(back.value).stream == encode(made.value).stream
