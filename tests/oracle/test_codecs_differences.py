"""Meshes compared by hand: each difference with its number, its element and its words."""

from compared_meshes import CORNERS, SOLID, Face, bare, kinds, only, placed

from clers.conformance import payloads as form
from clers.conformance.judging.comparing.difference import Difference, Kind, Of
from clers.conformance.judging.laws_meshes import LAWS, MeshPair, Planted
from clers.conformance.judging.meshes import (
    EXACT,
    Differs,
    Same,
    compare,
)
from clers.conventions.verdict import Holds
from clers.conventions.where import WHOLE, AtFace, AtVertex
from clers.generate.families import grid_torus
from clers.generate.mesh_pairs import PLANTS, mesh, renamed


def test_every_plant_by_itself() -> None:
    """ORCL-CODEC-6: on one torus, whatever strategies draw."""
    torus = grid_torus(3, 3)
    at = tuple((float(v), float(v * v % 7), -0.5 * (v % 3)) for v in range(9))
    for name, plant in PLANTS.items():
        for i in (0, 5):
            sent, came, known = plant((torus.faces, at), i)
            back = renamed(*came, len(came[1]), 1 + i)
            pair = MeshPair(mesh(*sent, len(sent[1])), back, EXACT)
            assert LAWS[-1].check(Planted(pair, known)) == Holds(), name


def test_elements_and_words() -> None:
    """ORCL-CODEC-7."""
    sent = placed((*SOLID, (1, 1, 3)), *CORNERS)
    came = placed(SOLID, *CORNERS)
    found = only(compare(sent, came))
    assert found == Difference(Kind.DEGENERATE_DROPPED, 1, Of.SENT, AtFace(4), "face (1, 1, 3)")
    assert found.line() == (
        "dropped-degenerate-faces, 1, first at face 4 of the mesh sent: face (1, 1, 3)"
    )
    assert only(compare(came, sent)) == Difference(
        Kind.FACES_ADDED, 1, Of.CAME, AtFace(4), "face (1, 1, 3)"
    )
    more = placed(SOLID, *CORNERS, (5, 5, 5), (6, 6, 6))
    assert only(compare(more, came)) == Difference(Kind.ISOLATED_LOST, 2, Of.SENT, AtVertex(4))
    added = only(compare(came, more))
    assert added == Difference(Kind.VERTICES_ADDED, 2, Of.CAME, AtVertex(4))
    assert added.line() == "vertices-added, 2, first at vertex 4 of the mesh given back"


def test_greatest_move_and_its_axis() -> None:
    """ORCL-CODEC-7."""
    away = (CORNERS[0], (1.0, -0.5, 0.25), (0.0, 1.0, 2.0), CORNERS[3])
    found = only(compare(placed(SOLID, *CORNERS), placed(SOLID, *away)))
    assert found == Difference(
        Kind.MOVED, 2, Of.SENT, AtVertex(1),
        "vertex 2 has become vertex 2: (0.0, 1.0, 0.0) to (0.0, 1.0, 2.0)", 2.0, "z",
    )  # fmt: skip


def test_moves_within_a_site() -> None:
    """ORCL-CODEC-6: all are in one chain, but no map keeps within the error."""
    faces = ((0, 1, 2), (0, 0, 1))
    sent = placed(faces, (0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (2.0, 0.0, 0.0))
    came = placed(faces, (2.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    found = only(compare(sent, came, (1, 0, 0)))
    assert (found.kind, found.count, found.by, found.axis) == (Kind.MOVED, 2, 2.0, "x")
    assert isinstance(compare(sent, came, (2, 0, 0)), Same)


def test_turned_faces_of_one_component() -> None:
    """ORCL-CODEC-6: some faces, or all of them; degenerate ones have no sides."""
    two = (*SOLID, (4, 5, 6), (4, 4, 5))
    at = (*CORNERS, (7, 0, 0), (8, 0, 0), (9, 1, 0))
    some = ((2, 1, 0), *SOLID[1:], *two[4:])
    found = only(compare(placed(two, *at), placed(some, *at)))
    assert found == Difference(Kind.ORIENTATION, 1, Of.SENT, AtFace(0), "face (0, 1, 2)")
    whole = (*SOLID, (4, 6, 5), (4, 4, 5))
    found = only(compare(placed(two, *at), placed(whole, *at)))
    assert found == Difference(Kind.COMPONENTS_MIRRORED, 1, Of.SENT, AtFace(4), "face (4, 5, 6)")


def test_turned_twins() -> None:
    """ORCL-CODEC-6: of a face that is there in both orientations one is turned over."""
    sent = placed((*SOLID, (0, 2, 1)), *CORNERS)
    came = placed((*SOLID, (0, 1, 2)), *CORNERS)
    assert only(compare(sent, came)) == Difference(
        Kind.ORIENTATION, 1, Of.SENT, AtFace(4), "face (0, 2, 1)"
    )


def test_component_with_its_degenerate_faces() -> None:
    """ORCL-CODEC-6: it is lost when its proper faces are; the others are named beside."""
    sent = placed((*SOLID, (4, 5, 6), (4, 4, 5)), *CORNERS, (7, 0, 0), (8, 0, 0), (9, 1, 0))
    assert kinds(compare(sent, placed(SOLID, *CORNERS))) == [
        ("components-lost", 1),
        ("dropped-degenerate-faces", 1),
        ("vertices-lost", 3),
    ]


def test_twins_lost_together() -> None:
    """ORCL-CODEC-6: of duplicates none is left, so they are lost, not dropped."""
    sent = placed((*SOLID, (0, 1, 2)), *CORNERS)
    found = only(compare(sent, placed(SOLID[1:], *CORNERS)))
    assert (found.kind, found.count, found.at) == (Kind.FACES_LOST, 2, AtFace(0))


def test_duplicate_with_the_other_side_left() -> None:
    """ORCL-CODEC-6: a face on its sites is left."""
    sent = placed((*SOLID, (0, 2, 1)), *CORNERS)
    found = only(compare(sent, placed(SOLID, *CORNERS)))
    assert (found.kind, found.count, found.at) == (Kind.DUPLICATES_DROPPED, 1, AtFace(4))


def test_isolated_vertices_are_missed_first() -> None:
    """ORCL-CODEC-6: at one place three vertices, one of them isolated; one came back."""
    sent = placed(((0, 1, 2), (3, 4, 5)), *CORNERS[:3], CORNERS[0], (5, 0, 0), (0, 5, 0), (0, 0, 0))
    came = placed(((0, 1, 2), (0, 3, 4)), *CORNERS[:3], (5, 0, 0), (0, 5, 0))
    assert kinds(compare(sent, came)) == [("vertices-merged", 1), ("lost-isolated-vertices", 1)]
    found = compare(sent, came)
    assert isinstance(found, Differs)
    assert [d.at for d in found.differences] == [AtVertex(3), AtVertex(6)]
    assert kinds(compare(came, sent)) == [("vertices-split", 1), ("vertices-added", 1)]


def test_what_cannot_be_compared() -> None:
    """ORCL-CODEC-6: nothing else is named."""
    good, stray = bare(*SOLID, vertices=4), bare(*SOLID, (0, 1, 4), (-1, 0, 1), vertices=4)
    assert only(compare(good, stray)) == Difference(
        Kind.STRAY_INDEX, 2, Of.CAME, AtFace(4), "face (0, 1, 4) with 4 vertices"
    )
    assert only(compare(stray, good)).of is Of.SENT
    few = form.MeshForm(
        faces=(), vertices=2, positions=form.Places(precision="f32", coordinates=(0.0,) * 7)
    )
    counted = only(compare(good, few))
    assert counted == Difference(
        Kind.COORDINATE_COUNT, 1, Of.CAME, WHOLE, "7 coordinates for 2 vertices"
    )
    assert kinds(compare(stray, few)) == [("index-out-of-range", 2), ("coordinate-count", 1)]


def test_positions_lost_and_added() -> None:
    """ORCL-CODEC-6: and the connectivity is compared all the same."""
    with_places, without = placed(SOLID, *CORNERS), bare(*SOLID, vertices=4)
    assert only(compare(with_places, without)) == Difference(Kind.POSITIONS_LOST, 4)
    assert only(compare(without, with_places)) == Difference(Kind.POSITIONS_ADDED, 4, Of.CAME)
    more = placed((*SOLID, (0, 0, 1)), *CORNERS)
    assert kinds(compare(more, without)) == [
        ("positions-lost", 4),
        ("dropped-degenerate-faces", 1),
    ]


def test_without_places() -> None:
    """ORCL-CODEC-6: components are known by their connectivity, the rest is paired."""
    solid = bare(*SOLID, vertices=4)
    assert kinds(compare(bare(*SOLID, vertices=6), solid)) == [("lost-isolated-vertices", 2)]
    assert kinds(compare(bare(*SOLID, (0, 0, 1), vertices=4), solid)) == [
        ("dropped-degenerate-faces", 1)
    ]
    assert kinds(compare(bare(*SOLID, (2, 0, 1), vertices=4), solid)) == [
        ("dropped-duplicate-faces", 1)
    ]
    apart = bare(*SOLID, (4, 5, 6), vertices=7)
    assert kinds(compare(apart, bare((0, 1, 2), vertices=3))) == [
        ("components-lost", 1),
        ("vertices-lost", 4),
    ]
    assert kinds(compare(apart, bare(*SOLID, vertices=7))) == [("components-lost", 1)]
    assert kinds(compare(bare((0, 1, 2), vertices=3), bare(vertices=0))) == [
        ("components-lost", 1),
        ("vertices-lost", 3),
    ]


def test_vertices_left_are_paired_by_number() -> None:
    """ORCL-CODEC-6: without places, whatever their names are."""
    sent = bare(*SOLID, (4, 5, 6), vertices=7)
    came = bare(*((a + 3, b + 3, c + 3) for a, b, c in SOLID), vertices=7)
    assert only(compare(sent, came)) == Difference(
        Kind.COMPONENTS_LOST, 1, Of.SENT, AtFace(4), "face (4, 5, 6)"
    )


def test_with_places_no_mesh_is_a_stranger() -> None:
    """ORCL-CODEC-6: what is nowhere near is lost, and something else was added."""
    far = ((50.0, 0.0, 0.0), (51.0, 0.0, 0.0), (50.0, 1.0, 0.0))
    found = compare(placed(SOLID, *CORNERS), placed(((0, 1, 2),), *far))
    assert kinds(found) == [
        ("components-lost", 1),
        ("faces-added", 1),
        ("vertices-lost", 4),
        ("vertices-added", 3),
    ]


def test_one_vertex_for_two() -> None:
    """ORCL-CODEC-6: of two vertices with faces on one edge, one has become the only one left."""
    edge = ((0.0, 0.0, 0.0), (1.0, 0.0, 0.0))
    sent = placed(((0, 1, 2), (0, 1, 3)), *edge, (0.0, 5.0, 0.0), (0.0, 6.0, 0.0))
    came = placed(((0, 1, 2),), *edge, (0.0, 7.0, 0.0))
    assert kinds(compare(sent, came)) == [
        ("faces-lost", 1),
        ("vertices-lost", 1),
        ("position-moved", 1),
    ]
    found = compare(came, sent)
    assert kinds(found) == [
        ("faces-added", 1),
        ("vertices-added", 1),
        ("position-moved", 1),
    ]


def test_move_across_zero() -> None:
    """ORCL-CODEC-7: by the difference, whatever the signs."""
    sent = placed(SOLID, (-1.0, 4.0, 0.0), *CORNERS[1:])
    came = placed(SOLID, (2.0, 3.0, 0.0), *CORNERS[1:])
    found = only(compare(sent, came))
    assert (found.kind, found.by, found.axis) == (Kind.MOVED, 3.0, "x")


def test_strangers_are_counted() -> None:
    """ORCL-CODEC-6: no component of one is like one of the other."""
    solid = bare(*SOLID, vertices=4)
    open_one = bare(*SOLID[:3], vertices=4)
    assert only(compare(solid, open_one)) == Difference(
        Kind.FACES_LOST, 1, detail="by number alone"
    )
    assert kinds(compare(open_one, solid)) == [("faces-added", 1)]
    strip = bare((0, 1, 2), (1, 3, 2), (2, 3, 4), (3, 5, 4), vertices=6)
    assert kinds(compare(solid, strip)) == [("vertices-added", 2), ("connectivity-changed", 4)]
    assert kinds(compare(strip, solid)) == [("vertices-lost", 2), ("connectivity-changed", 4)]
    fan = bare((0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5), vertices=6)
    assert only(compare(strip, fan)) == Difference(
        Kind.REJOINED, 4, detail="as many faces, joined otherwise"
    )


def test_mirrored_component_without_places() -> None:
    """ORCL-CODEC-6: four triangles in a zigzag are not their own mirror image."""
    strip = ((0, 1, 2), (1, 3, 2), (2, 3, 4), (3, 5, 4))
    over = tuple((a, c, b) for a, b, c in strip)
    sent = bare(*strip, (6, 7, 8), vertices=9)
    assert only(compare(sent, bare(*over, (6, 7, 8), vertices=9))) == Difference(
        Kind.COMPONENTS_MIRRORED, 1, Of.SENT, AtFace(0), "face (0, 1, 2)"
    )


def test_exchanged_faces_at_one_place() -> None:
    """ORCL-CODEC-6."""
    fan: tuple[Face, ...] = ((0, 1, 2), (0, 3, 4), (5, 1, 4), (5, 2, 3))
    other: tuple[Face, ...] = ((0, 1, 2), (5, 3, 4), (5, 1, 4), (0, 2, 3))
    at = (*CORNERS, (5.0, 0.0, 0.0), CORNERS[0])
    assert only(compare(placed(fan, *at), placed(other, *at))) == Difference(
        Kind.REJOINED, 4, detail="vertices at one place have exchanged faces"
    )
