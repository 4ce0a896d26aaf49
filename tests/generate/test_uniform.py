"""Spheres at random: exactly even over all choices, and evenly drawn as far as one can count."""

from collections import Counter
from itertools import combinations, product
from math import comb, dist, isclose
from random import Random

import pytest
from hypothesis import HealthCheck, find, settings

from clers.codes.tree_word import tree_word
from clers.complexes.corner_table import face_list, surface
from clers.complexes.surface import Surface
from clers.complexes.topology import components
from clers.conventions.result import Accepted
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import TETRAHEDRON
from clers.edgebreaker.grammar import rooted_triangulations, sphere_words
from clers.generate.spiral import breadth_first, spiral
from clers.generate.uniform import (
    chosen,
    openings,
    shuffled,
    starts,
    uniform_sphere,
    uniform_spheres,
)


def word(sphere: Surface) -> str:
    return encode(sphere).stream.word


@pytest.mark.parametrize(("vertices", "each"), [(4, 24), (5, 60), (6, 112), (7, 180)])
def test_each_sphere_comes_from_as_many_choices(vertices: int, each: int) -> None:
    """CODE-UNIFORM-1, CODE-UNIFORM-2: all bits and all turns; none left out, none favoured."""
    n = vertices - 2
    found: Counter[str] = Counter()
    for ones in combinations(range(4 * n - 2), n - 1):
        bits = bytes(i in ones for i in range(4 * n - 2))
        for turn, gap in product((0, 1), repeat=2):
            found[word(chosen(bits, turn, gap))] += 1
    assert found == Counter(dict.fromkeys(sphere_words(vertices), each))
    assert each * rooted_triangulations(vertices) == 4 * comb(4 * n - 2, n - 1)


@pytest.mark.parametrize(("vertices", "draws", "most"), [(6, 2600, 32.9), (7, 3400, 107.3)])
def test_chi_square_of_what_is_drawn(vertices: int, draws: int, most: float) -> None:
    """CODE-UNIFORM-3: below the 99.9 % point for 12 and for 67 degrees of freedom."""
    found = Counter(word(uniform_sphere(vertices, seed)) for seed in range(draws))
    kinds = rooted_triangulations(vertices)
    expected = draws / kinds
    counts = [*found.values(), *[0] * (kinds - len(found))]
    assert len(counts) == kinds
    square = sum((count - expected) ** 2 / expected for count in counts)
    assert square < most
    assert square > kinds / 4  # and not evener than chance


def test_turns_by_hand() -> None:
    """CODE-UNIFORM-1: walks of two steps down net, and of two steps up net."""
    # 3 −1 −1 −1 −1 −1: levels 0 3 2 1 0 −1 −2. From the start it ends at −2; from place 5 it goes
    # −1 2 1 0 −1 −2.
    assert starts([3, -1, -1, -1, -1, -1]) == (0, 5)
    # −1 3 −1 −1 −1 −1: levels 0 −1 2 1 0 −1 −2.
    assert starts([-1, 3, -1, -1, -1, -1]) == (0, 1)
    # −1 −1 −1 3 −1 −1: levels 0 −1 −2 −3 0 −1 −2: from places 3 and 2.
    assert starts([-1, -1, -1, 3, -1, -1]) == (3, 2)
    # up, up, down, up: levels 0 1 2 1 2: place 0, or place 3: up up up down.
    assert openings([1, 1, -1, 1]) == (0, 3)
    # down, up, up, up, up, down: levels 0 −1 0 1 2 3 2: places 1 and 2.
    assert openings([-1, 1, 1, 1, 1, -1]) == (1, 2)


def test_bits_are_drawn_from_an_urn() -> None:
    """CODE-UNIFORM-3: a one if x·r < o, by hand."""
    draws = iter([0.5, 0.4, 0.0, 0.9])
    # 4 left, 2 ones: 2.0 no; 3 left: 1.2 yes; 2 left, 1 one: 0.0 yes; 1 left, none: no.
    assert shuffled(4, 2, lambda: next(draws)) == bytes([0, 1, 1, 0])
    assert Counter(shuffled(6, 6, Random(0).random)) == {1: 6}


@pytest.mark.parametrize("vertices", [4, 5, 17, 400])
def test_spheres_of_so_many_vertices(vertices: int) -> None:
    """CODE-UNIFORM-1: connected, closed, of genus 0; the same for the same seed."""
    drawn = uniform_sphere(vertices, 3)
    (part,) = components(drawn)
    assert (drawn.vertices, part.genus, part.curves) == (vertices, 0, 0)
    assert surface(face_list(drawn)) == Accepted(drawn)
    assert uniform_sphere(vertices, 3) == drawn
    assert (uniform_sphere(vertices, 4) == drawn) == (vertices == 4)


def test_fewer_than_four_vertices_are_four() -> None:
    assert uniform_sphere(0, 0) == uniform_sphere(4, 9)
    assert tree_word(uniform_sphere(0, 0)) == tree_word(TETRAHEDRON)


def test_the_strategy_shrinks_to_few_vertices() -> None:
    """CODE-UNIFORM-1."""
    settled = settings(
        max_examples=500, database=None, deadline=None, suppress_health_check=list(HealthCheck)
    )
    least = find(uniform_spheres(), lambda _: True, settings=settled, random=Random(0))
    assert least.vertices == 4
    forked = find(uniform_spheres(), lambda s: "S" in word(s), settings=settled, random=Random(0))
    assert 6 <= forked.vertices <= 9
    assert [any("S" in w for w in sphere_words(v)) for v in (4, 5, 6)] == [False, False, True]


def test_points_on_a_spiral() -> None:
    """TOOL-GENERATE-1: breadth first from v0; the heights go down evenly, on the unit sphere."""
    assert breadth_first(TETRAHEDRON)[:3] == [
        TETRAHEDRON.vertex[0], TETRAHEDRON.vertex[1], TETRAHEDRON.vertex[2],
    ]  # fmt: skip
    drawn = uniform_sphere(50, 2)
    order, placed = breadth_first(drawn), spiral(drawn)
    assert sorted(order) == list(range(50))
    points = [placed.point(v) for v in order]
    assert all(isclose(dist(p, (0, 0, 0)), 1) for p in points)
    assert [p[2] for p in points] == pytest.approx([0.98 - 0.04 * k for k in range(50)])
    assert points[0][1] == 0
    neighbours = {
        y for a, b, c in drawn.triangles() for x, y in ((a, b), (b, c), (c, a)) if x == order[0]
    }
    assert set(order[1 : 1 + len(neighbours)]) == neighbours
    # the golden angle, 137.5 degrees, lies between points one and the next
    (x0, y0, _), (x1, y1, _) = points[0], points[1]
    cosine = (x0 * x1 + y0 * y1) / (dist((x0, y0), (0, 0)) * dist((x1, y1), (0, 0)))
    assert cosine == pytest.approx(-0.737368878)
