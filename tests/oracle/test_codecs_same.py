"""Meshes that are the same, by which map, and how long that is looked for."""

import math

import pytest
from compared_meshes import CORNERS, SOLID, bare, kinds, only, placed

from clers.conformance import payloads as form
from clers.conformance.judging.comparing.difference import Kind
from clers.conformance.judging.comparing.nets import coloured, mirrored, net
from clers.conformance.judging.comparing.sites import near, sites, within
from clers.conformance.judging.comparing.soup import MOST
from clers.conformance.judging.meshes import (
    EXACT,
    Differs,
    Same,
    Undecided,
    compare,
    error_of,
)
from clers.generate.families import grid_torus
from clers.generate.mesh_pairs import renamed


def test_certificate_is_the_map() -> None:
    """ORCL-CODEC-3, ORCL-CODEC-5: vertex v of the mesh sent has become vertex 3 − v."""
    turned = tuple((3 - b, 3 - c, 3 - a) for a, b, c in reversed(SOLID))
    assert compare(placed(SOLID, *CORNERS), placed(turned, *CORNERS[::-1])) == Same((3, 2, 1, 0))
    assert compare(bare(*SOLID, vertices=4), bare(*SOLID, vertices=4)) == Same((0, 1, 2, 3))
    assert compare(bare(vertices=0), bare(vertices=0)) == Same(())


def test_mirror_image_of_a_chiral_mesh_is_another() -> None:
    """ORCL-CODEC-3: with places, or with a part that tells the sides apart."""
    over = tuple((a, c, b) for a, b, c in SOLID)
    found = compare(placed(SOLID, *CORNERS), placed(over, *CORNERS))
    assert kinds(found) == [("components-mirrored", 1)]
    assert isinstance(compare(bare(*SOLID, vertices=4), bare(*over, vertices=4)), Same)


def test_times_count() -> None:
    """ORCL-CODEC-3: which face is there twice."""
    twice = bare((0, 1, 2), (0, 1, 2), (0, 2, 3), vertices=4)
    other = bare((0, 1, 2), (0, 2, 3), (0, 2, 3), vertices=4)
    assert isinstance(compare(twice, other), Same)
    marked = bare((0, 1, 2), (0, 1, 2), (0, 2, 3), (1, 1, 1), vertices=4)
    elsewhere = bare((0, 1, 2), (0, 2, 3), (0, 2, 3), (1, 1, 1), vertices=4)
    assert not isinstance(compare(marked, elsewhere), Same)


def test_minus_zero_and_precision_are_nothing() -> None:
    """ORCL-CODEC-4."""
    sent = placed(((0, 1, 2),), (0.0, 0.0, 0.0), (1, 0, 0), (0, 1, 0))
    at = form.Places(precision="f64", coordinates=(-0.0, 0.0, -0.0, 1, 0, 0, 0, 1, -0.0))
    came = form.MeshForm(faces=((1, 2, 0),), vertices=3, positions=at)
    assert compare(sent, came) == Same((0, 1, 2))


@pytest.mark.parametrize(
    ("x", "y", "bound", "good"),
    [
        (0.0, -0.0, 0.0, True),
        (1.0, 1.5, 0.5, True),
        (1.5, 1.0, 0.5, True),
        (1.0, 1.5, 0.25, False),
        (math.nan, math.nan, 0.0, True),
        (math.nan, 0.0, 9.0, False),
        (math.inf, math.inf, 0.0, True),
        (math.inf, 0.0, 9.0, False),
        (1e308, -1e308, 1e308, False),
        (1.0, -(2.0**-60), 1.0, False),  # the difference is rounded to the bound
        (1.0, 2.0**-60, 1.0, True),
    ],
)
def test_within(x: float, y: float, bound: float, good: bool) -> None:
    """ORCL-CODEC-4: exactly."""
    assert within(x, y, bound) == good


def test_near_on_each_axis() -> None:
    """ORCL-CODEC-4."""
    assert near((0, 0, 0), (1, 2, 3), (1, 2, 3))
    assert not near((0, 0, 0), (1, 2, 3), (0.5, 2, 3))
    assert not near((0, 0, 0), (1, 2, 3), (1, 1.5, 3))
    assert not near((0, 0, 0), (1, 2, 3), (1, 2, 2.5))


def test_sites() -> None:
    """ORCL-CODEC-4: a chain is one site, across cells and axes; far places are others."""
    chain = [(0.0, 0.0, 0.0), (2.0, 0.0, 0.0), (9.0, 0.0, 0.0)]
    other = [(1.0, 0.0, 0.0), (-1.0, 0.0, 0.0), (9.0, 1.0, 0.0), (3.0, 0.0, 1.0)]
    one, two = sites(chain, other, (1.0, 0.0, 0.0))
    assert one[0] == one[1] == two[0] == two[1]
    assert len({one[0], one[2], two[2], two[3]}) == 4
    one, two = sites(chain, other, (1.0, 1.0, 1.0))
    assert one[0] == one[1] == two[0] == two[1] == two[3]
    assert one[2] == two[2] != one[0]
    one, two = sites([(math.nan, 0.0, 0.0)], [(math.inf, 0.0, 0.0)], (1.0, 1.0, 1.0))
    assert one != two


def test_negative_neighbour_cells() -> None:
    """ORCL-CODEC-4: each direction of neighbouring cells is looked at."""
    for dx in (-1, 0, 1):
        for dy in (-1, 0, 1):
            for dz in (-1, 0, 1):
                far = (0.5 + dx, 0.5 + dy, 0.5 + dz)
                one, two = sites([(0.5, 0.5, 0.5)], [far], (1.0, 1.0, 1.0))
                assert one == two, (dx, dy, dz)


def test_error_of_a_request() -> None:
    """ORCL-CODEC-1."""
    plain = bare(vertices=1)
    assert error_of(plain) == EXACT == (0.0, 0.0, 0.0)
    assert error_of(form.ThroughForm.of(plain)) == EXACT
    through = form.ThroughForm.of(placed((), (0, 0, 0)), (0.5, 0.25, 1.0))
    assert error_of(through) == (0.5, 0.25, 1.0)
    assert isinstance(through.positions, form.Places)


def test_only_one_of_the_errors_is_needed() -> None:
    """ORCL-CODEC-3: along each axis its own."""
    sent, came = placed((), (0, 0, 0)), placed((), (0, 0, 0.5))
    assert compare(sent, came, (0, 0, 0.5)) == Same((0,))
    assert only(compare(sent, came, (9, 9, 0.25))).kind is Kind.MOVED


def test_matching_of_vertices_that_are_near_to_several() -> None:
    """ORCL-CODEC-5: 0 and 1 may become the first, 1 alone the second, so 0 must take the first."""
    sent = placed((), (0, 0, 0), (1, 0, 0), (2, 0, 0))
    came = placed((), (1, 0, 0), (2, 0, 0), (0.5, 0, 0))
    found = compare(sent, came, (1.0, 0.0, 0.0))
    assert isinstance(found, Same)
    assert sorted(found.vertices) == [0, 1, 2]
    for v, w in enumerate(found.vertices):
        assert abs(v - (1.0, 2.0, 0.5)[w]) <= 1
    crowd = [(0.0, 0, 0), (1.0, 0, 0), (2.0, 0, 0), (3.0, 0, 0)]
    moved = [(1.0, 0, 0), (2.0, 0, 0), (3.0, 0, 0), (4.0, 0, 0)]
    assert compare(placed((), *crowd), placed((), *moved), (1.0, 0, 0)) == Same((0, 1, 2, 3))
    apart = compare(placed((), *crowd), placed((), *moved[:3], (5.0, 0, 0)), (1.0, 0, 0))
    assert isinstance(apart, Differs)


def test_too_many_vertices() -> None:
    """ORCL-CODEC-8: a message can name any number of them."""
    many = form.MeshForm(faces=(), vertices="1" + "0" * 30)
    assert compare(bare(vertices=1), many) == Undecided(f"more than {MOST} vertices")
    assert compare(many, bare(vertices=1)) == Undecided(f"more than {MOST} vertices")


def test_search_is_given_up() -> None:
    """ORCL-CODEC-8: after so many steps; with one more there is an answer."""
    torus = bare(*grid_torus(3, 3).faces, vertices=9)
    other = renamed(grid_torus(3, 3).faces, None, 9, 1)
    assert compare(torus, other, EXACT, 17) == Undecided(
        "no isomorphism was found or excluded in 17 steps"
    )
    assert isinstance(compare(torus, other, EXACT, 200), Same)


def test_places_need_no_search() -> None:
    """ORCL-CODEC-5: where each site has one vertex of either mesh, no step is taken."""
    sent, came = placed(SOLID, *CORNERS), placed(SOLID[::-1], *CORNERS)
    assert isinstance(compare(sent, came, EXACT, 0), Same)


def test_walks_are_linear() -> None:
    """ORCL-CODEC-5: with one face unlike all others, few steps for each face."""
    faces = (*grid_torus(8, 9).faces, (0, 0, 1))
    sent, came = bare(*faces, vertices=72), renamed(faces, None, 72, 3)
    assert isinstance(compare(sent, came, EXACT, 12 * len(faces)), Same)


def test_colours_and_mirror() -> None:
    """ORCL-CODEC-5: a vertex takes up what is around it; turned over, faces run the other way."""
    one = net(((0, 1, 2),), 4)
    assert one.units == ((0, 1, 2), (3,))
    assert one.parts == ((0,), (1,))
    (colours,) = coloured([one], [[0, 0, 0, 0]])
    assert colours[0] == colours[1] == colours[2] != colours[3]
    (marked,) = coloured([one], [[7, 0, 0, 0]])
    assert len(set(marked)) == 4
    assert mirrored(one).units == ((0, 2, 1), (3,))
    assert net(((0, 1, 2), (1, 2, 0), (0, 2, 1)), 3).times == (2, 1)
