"""Views, ribbons, and which layout is taken."""

from itertools import pairwise
from math import cos, dist, isclose, radians, sin

import pytest
from pictured import built, globe, picture, placed

from clers.complexes.surface import Surface
from clers.edgebreaker.encode import encode
from clers.edgebreaker.examples import CUBE, TORUS
from clers.geometry.positions import Positions
from clers.pictures.draw import draw
from clers.pictures.options import Layout, Options
from clers.pictures.picture import Edge, Picture, Role, Shape
from clers.pictures.room import roomiest
from clers.pictures.shown import edges_of, shapes_of

Vector = tuple[float, float, float]

BOX: list[Vector] = [
    (0, 0, 0), (0, 2, 0), (0, 0, 3), (0, 2, 3), (1, 2, 3), (1, 2, 0), (1, 0, 0), (1, 0, 3),
]  # fmt: skip
"""Places for the vertices of CUBE: a box of 1 × 2 × 3."""


def grid(size: int) -> Surface:
    """A disc of 2 · size² faces."""
    side = size + 1
    faces: list[tuple[int, int, int]] = []
    for i in range(size):
        for j in range(size):
            a, b, c, d = i * side + j, (i + 1) * side + j, (i + 1) * side + j + 1, i * side + j + 1
            faces += [(a, b, c), (a, c, d)]
    return built(faces, side * side)


def dot(a: Vector, b: Vector) -> float:
    return sum(x * y for x, y in zip(a, b, strict=True))


def seen_from(shown: Picture, at: list[Vector], right: Vector, up: Vector) -> None:
    """Every corner is where its vertex is seen, up to one scale for all."""
    flat = [(dot(point, right), dot(point, up)) for point in at]
    spans = [max(p[k] for p in flat) - min(p[k] for p in flat) for k in range(2)]
    low = [min(p[k] for p in flat) for k in range(2)]
    for shape in shapes_of(shown.panels[0]):
        for vertex, place in zip(shape.visit.triangle, shape.corners, strict=True):
            for k in range(2):
                expected = (flat[vertex][k] - low[k]) / max(spans)
                assert isclose(place[k], expected, abs_tol=1e-9)


def test_view_from_a_direction() -> None:
    """Along the third axis the first is to the right and the second up. Clause: TOOL-PICTURE-8."""
    shown = picture(CUBE, Options(view=(0, 0, 5), steps=(12,)), placed(CUBE, BOX))
    seen_from(shown, BOX, (1, 0, 0), (0, 1, 0))
    from_above = picture(CUBE, Options(view=(0, 1, 0), steps=(12,)), placed(CUBE, BOX))
    seen_from(from_above, BOX, (-1, 0, 0), (0, 0, 1))


def test_view_shows_the_greatest_spread_and_some_depth() -> None:
    """The box is thinnest along the first axis: seen from there, 25° to the right, 15° up.

    Right is then −z, for up is y. Clause: TOOL-PICTURE-8.
    """
    turn, rise = radians(25), radians(15)
    right = (-sin(turn), 0.0, -cos(turn))
    up = (-sin(rise) * cos(turn), cos(rise), sin(rise) * sin(turn))
    shown = picture(CUBE, Options(layout=Layout.VIEW, steps=(12,)), placed(CUBE, BOX))
    seen_from(shown, BOX, right, up)


def test_plane_mesh_is_seen_straight_on() -> None:
    """Clause: TOOL-PICTURE-8."""
    of = grid(3)
    points = [(float(v // 4), float(v % 4) * 0.5, 7.0) for v in range(16)]
    shown = picture(of, Options(layout=Layout.VIEW, steps=(18,)), placed(of, points))
    seen_from(shown, points, (1, 0, 0), (0, 1, 0))


@pytest.fixture(scope="module")
def world() -> tuple[Surface, Positions]:
    return globe(9, 14)


def test_far_faces_are_painted_first(world: tuple[Surface, Positions]) -> None:
    """Middles come nearer; faces seen from behind run clockwise. Clause: TOOL-PICTURE-8."""
    of, at = world
    direction = (1.0, 2.0, 3.0)
    panel = picture(of, Options(view=direction), at).panels[0]
    shapes = shapes_of(panel)
    depth = [sum(dot(at.point(v), direction) for v in s.visit.triangle) for s in shapes]
    assert all(a <= b + 1e-9 for a, b in pairwise(depth))
    assert sum(shape.far for shape in shapes) == pytest.approx(of.faces / 2, rel=0.1)
    for shape in shapes:
        (ax, ay), (bx, by), (cx, cy) = shape.corners
        assert shape.far == ((bx - ax) * (cy - ay) < (by - ay) * (cx - ax))


def test_edges_of_far_faces_can_be_hidden() -> None:
    """In a view an edge is painted right after its face, in the flat layout after all faces."""
    of = grid(3)
    points = [(float(v // 4), float(v % 4), float(v % 3)) for v in range(16)]
    view = picture(of, Options(view=(1, 1, 1), steps=(18,)), placed(of, points)).panels[0]
    flat = picture(of, Options(steps=(18,))).panels[0]
    kinds = [isinstance(item, Shape) for item in flat.ground]
    assert kinds == sorted(kinds, reverse=True)
    owner: Shape | None = None
    for item in view.ground:
        if isinstance(item, Edge):
            assert owner is not None
            assert set(item.ends) < set(owner.visit.triangle)
        else:
            owner = item
    assert len(edges_of(view, Role.REACHED)) == len(edges_of(flat, Role.REACHED)) == 12


def test_ribbon_is_a_strip_of_equal_triangles() -> None:
    """Neighbours in the walk share a side, but where a line breaks. Clause: TOOL-PICTURE-9."""
    panel = picture(TORUS, Options(layout=Layout.RIBBON, tree=True, steps=(18,))).panels[0]
    shapes = shapes_of(panel)
    assert [shape.visit.step for shape in shapes] == list(range(1, 19))
    sides = [dist(s.corners[i], s.corners[i - 1]) for s in shapes for i in range(3)]
    assert max(sides) - min(sides) < 1e-9
    common = [len(set(a.corners) & set(b.corners)) for a, b in pairwise(shapes)]
    assert set(common) == {0, 2}
    assert common.count(0) < 5
    assert (panel.gates, panel.marks, panel.notes) == ((), (), ())
    assert len(panel.ground) == len(shapes)


def layout_of(shown: Picture) -> Layout:
    """Only ribbons have equal triangles, only views have far faces."""
    shapes = shapes_of(shown.panels[-1])
    if any(shape.far for shape in shapes):
        return Layout.VIEW
    sides = {round(dist(shape.corners[0], shape.corners[1]), 9) for shape in shapes}
    return Layout.RIBBON if len(sides) == 1 else Layout.FLAT


def test_layout_taken_by_default(world: tuple[Surface, Positions]) -> None:
    """Clause: TOOL-PICTURE-5."""
    box = placed(CUBE, BOX)
    assert layout_of(picture(CUBE)) is Layout.FLAT
    assert layout_of(picture(CUBE, at=box)) is Layout.FLAT
    assert layout_of(picture(CUBE, Options(view=(1, 1, 1)), box)) is Layout.VIEW
    assert layout_of(picture(*world[:1])) is Layout.FLAT
    assert layout_of(picture(world[0], at=world[1])) is Layout.VIEW
    large, _ = globe(52, 100)
    assert large.faces == 10_200
    assert layout_of(picture(large)) is Layout.RIBBON


def test_letters_keep_clear_of_vertices() -> None:
    """In a slender triangle the roomiest place is not at the blunt corner."""
    corners = ((0.0, 0.0), (1.0, 0.0), (0.1, 0.1))
    at, room = roomiest(corners)
    assert room > 0.02
    assert min(dist(at, corner) for corner in corners) > 0.05


def test_nothing_is_drawn_twice_or_lost(world: tuple[Surface, Positions]) -> None:
    """Of a view too each face is drawn once. Clause: TOOL-PICTURE-1."""
    of, at = world
    drawn = draw(of, encode(of), at, Options(steps=(0, 100)))
    for panel in picture(of, Options(steps=(0, 100)), at).panels:
        assert sorted(s.visit.face for s in shapes_of(panel)) == list(range(of.faces))
    assert drawn == draw(of, encode(of), at, Options(steps=(100, 0, 0)))


def test_components_fill_a_square() -> None:
    """Nine spheres are drawn in three rows. Clause: TOOL-PICTURE-6."""
    faces = [
        (4 * k + a, 4 * k + b, 4 * k + c)
        for k in range(9)
        for a, b, c in ((0, 1, 2), (0, 3, 1), (1, 3, 2), (0, 2, 3))
    ]
    shown = picture(built(faces, 36), Options(steps=(36,)))
    assert isclose(shown.width, shown.height)
    rings = {shape.centre for shape in shapes_of(shown.panels[0]) if shape.ring}
    assert len(rings) == 9
    assert len({round(y, 6) for _, y in rings}) == 3
