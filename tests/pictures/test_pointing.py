"""Pictures that point at something, and pictures beside each other."""

from dataclasses import replace
from math import isclose

import pytest

from clers.complexes.corner_table import surface
from clers.complexes.face_list import FaceList
from clers.complexes.surface import Surface
from clers.conventions.result import Accepted
from clers.edgebreaker.encode import encode
from clers.pictures.beside import HEADING, beside
from clers.pictures.draw import draw
from clers.pictures.options import Layout, Options, Pointer
from clers.pictures.palette import POINTER
from clers.pictures.picture import Panel, Picture, Point, Shape, Target
from clers.pictures.png import png_of
from clers.pictures.scene import Disc, Item, Line, Polygon, Scene, Words
from clers.pictures.sheet import scene
from clers.pictures.svg import svg_of


def _surface(*faces: tuple[int, int, int]) -> Surface:
    built = surface(FaceList(faces, 1 + max(v for face in faces for v in face)))
    assert isinstance(built, Accepted)
    return built.value


BALL = _surface((0, 1, 2), (3, 2, 1), (0, 3, 1), (2, 3, 0))
SQUARE = _surface((0, 1, 2), (0, 2, 3))


def _picture(of: Surface, pointer: Pointer, layout: Layout = Layout.FLAT) -> Picture:
    options = Options(steps=(1, of.faces), layout=layout, pointer=pointer)
    drawn = draw(of, encode(of), None, options)
    assert isinstance(drawn, Accepted)
    return drawn.value


def _shape(panel: Panel, face: int) -> Shape:
    return next(
        item for item in panel.ground if isinstance(item, Shape) and item.visit.face == face
    )


def test_nothing_is_pointed_at_unless_asked() -> None:
    """Clause: TOOL-PICTURE-14."""
    picture = _picture(SQUARE, Pointer())
    assert [panel.pointed for panel in picture.panels] == [(), ()]
    assert POINTER not in svg_of(scene(picture))


def test_a_face_is_pointed_at_in_every_panel() -> None:
    """Clause: TOOL-PICTURE-14."""
    picture = _picture(SQUARE, Pointer(faces=(1, 1)))
    for panel in picture.panels:
        (one,) = panel.pointed
        assert one.what is Target.FACE
        assert one.ring == 0
        assert set(one.path) == set(_shape(panel, 1).corners)


def test_the_face_that_lies_around_the_others_has_a_ring() -> None:
    """Clauses: TOOL-PICTURE-6, TOOL-PICTURE-14."""
    panel = _picture(BALL, Pointer(faces=(3,))).panels[0]
    (one,) = panel.pointed
    assert one.ring == _shape(panel, 3).ring > 0
    assert one.centre == _shape(panel, 3).centre


def test_a_triangle_that_is_no_face_goes_through_the_nearest_places() -> None:
    """Clause: TOOL-PICTURE-14."""
    panel = _picture(SQUARE, Pointer(faces=(0,), triangle=(1, 2, 3))).panels[0]
    face, triangle = panel.pointed
    assert (face.what, triangle.what) == (Target.FACE, Target.TRIANGLE)
    place = {int(mark.vertex): mark.at for mark in panel.marks}
    assert triangle.path == tuple(place[v] for v in (1, 2, 3))
    (alone,) = _picture(SQUARE, Pointer(triangle=(1, 2, 3))).panels[0].pointed
    assert alone == triangle


TORUS = _surface(
    *(
        face
        for i in range(3)
        for j in range(3)
        for a, b, c, d in [
            (3 * i + j, 3 * ((i + 1) % 3) + j, 3 * ((i + 1) % 3) + (j + 1) % 3, 3 * i + (j + 1) % 3)
        ]
        for face in ((a, b, c), (a, c, d))
    )
)


def test_a_vertex_is_pointed_at_wherever_it_is_drawn() -> None:
    """Clauses: TOOL-PICTURE-6, TOOL-PICTURE-14: the torus is cut open at its first vertex."""
    panel = _picture(TORUS, Pointer(vertices=(0, 0))).panels[0]
    places = {one.path[0] for one in panel.pointed}
    assert {one.what for one in panel.pointed} == {Target.VERTEX}
    assert len(panel.pointed) == len(places) == 4
    assert places == {mark.at for mark in panel.marks if mark.vertex == 0}


def test_of_a_vertex_with_several_places_the_nearest_is_taken() -> None:
    """Clause: TOOL-PICTURE-14: the triangle of a face is that face, even where it is cut."""
    for f in range(TORUS.faces):
        names = TORUS.vertex[3 * f : 3 * f + 3]
        pointer = Pointer(faces=(f,), triangle=(names[0], names[1], names[2]))
        face, triangle = _picture(TORUS, pointer).panels[0].pointed
        if _shape(_picture(TORUS, pointer).panels[0], f).ring == 0:
            assert triangle.path == face.path


def test_the_first_face_says_where_the_triangle_is() -> None:
    """Clause: TOOL-PICTURE-14: without a face the first place of the first vertex does."""
    panel = _picture(TORUS, Pointer()).panels[0]
    drawn = [f for f in range(TORUS.faces) if _shape(panel, f).ring == 0]
    for f, g in zip(drawn, reversed(drawn), strict=True):
        a, b, c = TORUS.vertex[3 * f : 3 * f + 3]
        pointer = Pointer(faces=(f, g), triangle=(a, b, c))
        pointed = _picture(TORUS, pointer).panels[0].pointed
        assert pointed[-1].path == pointed[0].path
        (alone,) = _picture(TORUS, Pointer(triangle=(a, b, c))).panels[0].pointed
        first = _picture(TORUS, Pointer(vertices=(a,))).panels[0].pointed[0]
        assert alone.path[0] == first.path[0]


@pytest.mark.parametrize(
    "pointer",
    [
        Pointer(faces=(2, -1)),
        Pointer(vertices=(4, -1)),
        Pointer(triangle=(0, 1, 4)),
        Pointer(triangle=(0, 1, -1)),
    ],
)
def test_what_is_not_there_is_not_pointed_at(pointer: Pointer) -> None:
    """Clause: TOOL-PICTURE-14."""
    assert _picture(SQUARE, pointer).panels[0].pointed == ()


def test_a_ribbon_points_at_faces_only() -> None:
    """Clause: TOOL-PICTURE-14."""
    everything = Pointer(faces=(0,), vertices=(0,), triangle=(0, 1, 2))
    panel = _picture(SQUARE, everything, Layout.RIBBON).panels[0]
    assert [one.what for one in panel.pointed] == [Target.FACE]


def test_pointers_have_a_colour_of_their_own_and_names_in_the_legend() -> None:
    """Clauses: TOOL-PICTURE-12, TOOL-PICTURE-14."""
    image = scene(_picture(SQUARE, Pointer(faces=(0,), vertices=(1,), triangle=(1, 2, 3))))
    kinds: dict[str, list[str]] = {}
    for group in image.groups:
        for item in group.items:
            if not isinstance(item, Words) and item.style.stroke == POINTER:
                kinds.setdefault(group.name, []).append(item.kind)
                assert bool(item.style.dash) == (item.kind == "pointed-triangle")
    every = ["pointed-face", *["pointed-triangle"] * 3, "pointed-vertex"]
    assert kinds["step-1"] == kinds["step-2"] == every
    assert sorted(kinds["legend"]) == every
    (legend,) = (group for group in image.groups if group.name == "legend")
    words = {item.text for item in legend.items if isinstance(item, Words)}
    assert {f"the {what} pointed at" for what in ("face", "vertex", "triangle")} <= words
    ring = _picture(BALL, Pointer(faces=(3,)))
    around = [
        item
        for item in scene(ring).groups[0].items
        if isinstance(item, Disc) and item.style.stroke == POINTER
    ]
    assert len(around) == 1


def test_images_stand_beside_each_other() -> None:
    """Clause: TOOL-PICTURE-15."""
    one, other = (scene(_picture(of, Pointer(faces=(0,)))) for of in (SQUARE, BALL))
    both = beside("two", (("left", one), ("right", other)))
    assert both.title == "two"
    assert both.width == one.width + other.width
    assert isclose(both.height, 2.4 * HEADING + max(one.height, other.height))
    heads = [item for group in both.groups for item in group.items if isinstance(item, Words)]
    headings = [word for word in heads if word.size == HEADING]
    assert {word.at[1] for word in headings} == {1.4 * HEADING}
    assert [(word.text, word.at[0]) for word in headings] == [
        ("left", one.width / 2),
        ("right", one.width + other.width / 2),
    ]
    assert _undone(both, 1, one.width, 2.4 * HEADING) == _items(other)
    assert _undone(both, 0, 0.0, 2.4 * HEADING) == _items(one)
    assert len({group.name for group in both.groups}) == len(both.groups)
    assert png_of(both).startswith(b"\x89PNG")
    assert svg_of(both).count("<text") == len(heads)


def _undone(both: Scene, k: int, right: float, down: float) -> tuple[str, ...]:
    """What the k-th image was before it was moved."""
    return tuple(
        _told(item, right, down, 2)
        for group in both.groups
        if group.name.startswith(f"{k}-")
        for item in group.items
    )


def _told(item: Item, right: float = 0.0, down: float = 0.0, prefix: int = 0) -> str:
    """An item in words, moved back by so much, its style's name without a prefix."""

    def at(*points: Point) -> str:
        return " ".join(f"{x - right:.6f},{y - down:.6f}" for x, y in points).replace("-0.0", "0.0")

    match item:
        case Polygon(points, style, kind, title):
            rest = replace(style, name=style.name[prefix:]), kind, title
            return f"{at(*points)} {rest}"
        case Disc(centre, radius, style, kind, title):
            rest = replace(style, name=style.name[prefix:]), kind, title
            return f"{at(centre)} {radius} {rest}"
        case Line(path, style, kind):
            return f"{at(*path)} {replace(style, name=style.name[prefix:])} {kind}"
        case Words(where, text, size, colour, centred, bold):
            return f"{at(where)} {(text, size, colour, centred, bold)}"


def _items(of: Scene) -> tuple[str, ...]:
    return tuple(_told(item) for group in of.groups for item in group.items)
